// Bad input is answered with exit 2 and one line that names what is wrong, before anything is made.
#include "tests/play/program.h"

namespace {
using luftpost::tests::Outcome;
using luftpost::tests::run;
using luftpost::tests::scratch;
using luftpost::tests::writeText;
using luftpost::tests::fs::path;

/// Exit 2, one line on standard error that says each of the words, nothing on standard output.
void expectRefused(std::string const& arguments, std::initializer_list<char const*> words,
                   std::string const& environment = "") {
    Outcome const outcome = run(arguments, environment);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.complaints(), 1) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    for (char const* word : words)
        EXPECT_NE(outcome.err.find(word), std::string::npos) << arguments << "\n" << outcome.err;
}
std::string const kFly = "play --headless --no-render --seconds 1 ";

TEST(BadInput, NamesTheNearestKnownSettingCommandOrOption) {
    expectRefused(kFly + "--set clouds.sigmo=1", {"--set", "clouds.sigmo", "clouds.sigma"});
    expectRefused(kFly + "--set clouds.sigma=99", {"clouds.sigma", "0.05", "4", "99"});
    expectRefused(kFly + "--set clouds.sigma", {"key=value"});
    expectRefused(kFly + "--second 3", {"--second", "--seconds"});
    expectRefused("plya", {"plya", "play"});
    expectRefused(kFly + "--set clouds.densty=1", {"clouds.densityThreshold"});
    expectRefused("play extra --headless --seconds 1", {"extra"});
    expectRefused("play sky -o x.png", {"sky"});
    expectRefused("sky weather preset:fair", {"weather"});
}

TEST(BadInput, IsFoundInTheReference) {
    std::string const out = "-o " + (scratch() / "r.exr").string();
    expectRefused("sky --reference 0 " + out, {"--reference", "1..", "0"});
    expectRefused("sky --reference many " + out, {"--reference", "many"});
    expectRefused("sky --reference 4 --plan 20 " + out, {"--reference", "--plan"});
    expectRefused("sky --onto a.exr " + out, {"--onto", "--reference"});
    expectRefused("sky --reference 4 --onto " + (scratch() / "none.exr").string() + " " + out, {"none.exr"});
    expectRefused("sky --reference 4 --onto a.exr --frames 0:1 " + out, {"--onto", "one picture"});
    expectRefused("sky -o " + (scratch() / "f.mp4").string(), {"f.mp4", "--frames"});
    expectRefused("sky --supersample 9 " + out, {"--supersample", "1..8", "9"});
    expectRefused("sky --supersample 2 --reference 4 " + out, {"--supersample", "--reference"});
    expectRefused("sky --supersample 4 --size 1280x720 " + out, {"--supersample", "4096", "4 times 1280x720"});
    auto const asked = [](std::string const& name, std::string const& text) {
        path const file = scratch() / (name + ".json");
        writeText(file, text);
        return "reference --case " + file.string() + " --json " + (scratch() / "out.json").string();
    };
    auto const with = [](std::string const& columns, std::string const& rest) { return "{\"columns\":" + columns + ",\"width_km\":0.5,\"thickness_km\":0.25," + rest + "}"; };
    std::string const good = "\"g\":0.85,\"albedo\":1,\"sun_zenith_deg\":0,\"photons\":1000";
    expectRefused("reference --case /no/such.json --json /tmp/x.json", {"/no/such.json"});
    expectRefused("reference --json /tmp/x.json", {"--case"});
    expectRefused(asked("broken", "{\"columns\":[1,"), {"broken.json", "byte", "JSON"});
    expectRefused(asked("list", "[1]"), {"list.json", "an object"});
    expectRefused(asked("none", with("[]", good)), {"none.json", "columns", "1..65536"});
    expectRefused(asked("negative", with("[1,-2]", good)), {"negative.json", "columns[1]", "-2"});
    expectRefused(asked("text", with("[1,\"two\"]", good)), {"columns[1]", "two"});
    expectRefused(asked("missing", with("[1]", "\"g\":0.85,\"albedo\":1,\"photons\":1")), {"sun_zenith_deg", "not there"});
    expectRefused(asked("level", with("[1]", "\"g\":0.85,\"albedo\":1,\"sun_zenith_deg\":90,\"photons\":1")), {"sun_zenith_deg", "90"});
    expectRefused(asked("g", with("[1]", "\"g\":1,\"albedo\":1,\"sun_zenith_deg\":0,\"photons\":1")), {"g", "-1", "1"});
    expectRefused(asked("part", with("[1]", "\"g\":0,\"albedo\":1,\"sun_zenith_deg\":0,\"photons\":1.5")), {"photons", "whole"});
}

TEST(BadInput, IsFoundInEveryOption) {
    expectRefused("play --headless", {"--seconds"});
    expectRefused("play --headless --seconds abc", {"--seconds", "abc"});
    expectRefused("play --headless --seconds -1", {"--seconds"});
    expectRefused("play --headless --seconds nan", {"--seconds"});
    expectRefused("play --headless --seconds", {"--seconds"});
    for (char const* size : {"0x720", "1280", "16385x10", "axb", "-1x5", "10x10x10", "1280x"})
        expectRefused(kFly + "--size " + size, {"--size", "1..16384"});
    expectRefused(kFly + "--start air:300,50", {"--start", "air:ALT_M,TAS_MPS,HEADING_DEG"});
    expectRefused(kFly + "--start air:1,50,0", {"--start", "above the ground"});
    expectRefused(kFly + "--start hangar", {"--start", "runway"});
    expectRefused(kFly + "--assist hard", {"--assist", "sim, light, normal, easy"});
    expectRefused(kFly + "--payload -5", {"--payload"});
    expectRefused(kFly + "--payload 99999", {"--payload"});
    expectRefused(kFly + "--fuel lots", {"--fuel", "lots"});
    expectRefused(kFly + "--workers 0", {"--workers"});
    expectRefused(kFly + "--frame-rate 0", {"--frame-rate"});
    expectRefused(kFly + "--bot ace", {"--bot", "courier", "circuit", "card:NAME", "ace"});
    expectRefused(kFly + "--bot card:loop", {"--bot", "stall, glide, climb", "crosswind", "card:loop"});
    expectRefused(kFly + "--seed -1", {"--seed"});
    expectRefused(kFly + "--seed 1.5", {"--seed"});
    expectRefused(kFly + "--time 2023-06-23", {"--time", "2021-06-28T16:00Z"});
    expectRefused(kFly + "--time 2023-02-30T00:00Z", {"--time"});
    expectRefused(kFly + "--place 91,0", {"--place", "latitude"});
    expectRefused(kFly + "--place 47", {"--place", "LAT,LON"});
    expectRefused(kFly + "--weather preset:sunny", {"sunny"});
    expectRefused(kFly + "--weather recorded:/no/such/file.json", {"/no/such/file.json"});
    expectRefused(kFly + "--screenshot /tmp/x.png", {"--screenshot", "--no-render"});
    for (char const* picture : {"/tmp/picture.jpg", "/tmp/picture_without_ending"})
        expectRefused(std::string{"play --headless --seconds 1 --screenshot "} + picture, {"--screenshot", "FILE.png", picture});
}

TEST(BadInput, IsAnOptionThatContradictsAnother) {
    std::string const file = (scratch() / "one").string();
    expectRefused(kFly + "--log '" + file + "' --report '" + file + "'", {"--report", file.c_str(), "--log"});
    expectRefused(kFly + "--log one.csv --report ./one.csv", {"--report", "--log"});
    expectRefused(kFly + "--bot card:stall --start runway", {"--start", "card:stall"});
    for (char const* other : {"--assist easy", "--set aircraft.assist=light"})
        expectRefused(kFly + "--bot card:stall " + other, {"--assist", "sim", "card:stall"});
    expectRefused("weather preset:fair --weather preset:storm", {"--weather", "preset:fair"});
    expectRefused("sky --plan 5 --exposure 1 -o x.exr", {"--plan", "--exposure"});
    for (char const* other : {"--weather preset:calm", "--place 1,2", "--time 2023-06-23T18:40Z", "--seed 2"})
        expectRefused(std::string{"replay r "} + other, {std::string{other}.substr(0, 6).c_str(), "replay"});
    expectRefused("replay r --set aircraft.rollSpeed=30", {"--set", "aircraft.rollSpeed", "replay"});
}

TEST(BadInput, IsAnEmptyTextInAnyOption) {
    for (char const* option : {"--log", "--report", "--screenshot", "--save-replay", "--save-weather", "--save", "--input",
                               "--settings", "--set", "--weather", "--bot", "--workers"})
        expectRefused(kFly + option + " ''", {option, "nothing"});
    expectRefused(kFly + "--log=", {"--log"});
    expectRefused("replay ''", {"file", "nothing"});
    expectRefused("weather ''", {"source", "nothing"});
}

TEST(BadInput, NamesMissingFolders) {
    for (char const* option : {"--log", "--report", "--save-replay", "--save-weather", "--save"})
        expectRefused(kFly + option + " /no/such/folder/file", {option, "/no/such/folder"});
    expectRefused("play --headless --seconds 1 --screenshot /no/such/folder/x.png",
                  {"--screenshot", "/no/such/folder"});
    expectRefused(kFly + "--log '" + scratch().string() + "'", {"--log", "folder"});
}

TEST(BadInput, NamesPlaceInFiles) {
    path const folder = scratch();
    auto const file = [&](char const* name, char const* text) {
        writeText(folder / name, text);
        return std::string{"'"}.append((folder / name).string()).append("'");
    };
    expectRefused(kFly + "--settings " + file("a.toml", "clouds.sigma = 1\nclouds.hgg = 2\n"),
                  {"a.toml:2", "clouds.hgg", "clouds.hg"});
    expectRefused(kFly + "--settings " + file("b.toml", "[clouds\n"), {"b.toml:1", "TOML"});
    expectRefused(kFly + "--settings /no/such.toml", {"/no/such.toml"});
    expectRefused(kFly + "--input " +
                      file("in.csv", "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop\n0,2,,,,,,\n"),
                  {"in.csv:2", "throttle", "0..1"});
    expectRefused(kFly + "--input /no/such.csv", {"/no/such.csv"});
    expectRefused(kFly + "--weather recorded:" + file("w.json", "{\"format\":\"luftpost-weather-1\"}"),
                  {"w.json"});
    expectRefused(kFly + "--weather recorded:" + file("x.json", "{"), {"x.json"});
    expectRefused(kFly + "--save " + file("s.json", "{\"format\":\"luftpost-save-1\",\"score\":-1}"), {"s.json", "score"});
    expectRefused("replay " + file("r.json", "{\"format\":\"luftpost-replay-1\"}"), {"r.json"});
    expectRefused("replay /no/such.replay", {"/no/such.replay"});
}

TEST(BadInput, IsAPhotographThatIsNone) {
    path const folder = scratch() / "photos";
    std::filesystem::create_directories(folder);
    writeText(folder / "text.jpg", "not an image");
    std::string const file = (folder / "text.jpg").string(), output = "-o '" + (scratch() / "no.png").string() + "'";
    std::filesystem::create_directories(scratch() / "empty");
    for (std::string const& command : {std::string{"play --headless --seconds 1"}, "sky " + output}) {
        expectRefused(command + " --photo '" + file + "'", {"text.jpg", "expected an image"});
        expectRefused(command + " --photo '" + folder.string() + "'", {"text.jpg", "expected an image"});
        expectRefused(command + " --photo /no/such.jpg", {"/no/such.jpg"});
        expectRefused(command + " --photo '" + (scratch() / "empty").string() + "'", {"empty", "photographs"});
    }
    expectRefused(kFly + "--photo '" + file + "'", {"--photo", "--no-render"});
    expectRefused("sky " + output + " --side-by-side both.png", {"--side-by-side", "--photo"});
}

TEST(BadInput, NamesThePlaceInAReplay) {
    path const good = scratch() / "good.replay", bad = scratch() / "bad.replay";
    ASSERT_EQ(run(kFly + "--save-replay '" + good.string() + "'").code, 0);
    auto const whole = nlohmann::json::parse(luftpost::tests::fileText(good));
    auto const expectPlace = [&](char const* pointer, char const* value, char const* place) {
        auto json = whole;
        json[nlohmann::json::json_pointer{pointer}] = nlohmann::json::parse(value);
        writeText(bad, json.dump());
        expectRefused("replay '" + bad.string() + "'", {"bad.replay", place, "expected"});
    };
    expectPlace("/ticks", "-5", "ticks");
    expectPlace("/ticks", "1e300", "ticks");
    expectPlace("/plan/seed", "-1", "plan.seed");
    expectPlace("/plan/payload_kg", "-100", "plan.payload_kg");
    expectPlace("/plan/payload_kg", "100000", "plan.payload_kg");
    expectPlace("/plan/place", "[100, 0, 0]", "plan.place[0]");
    expectPlace("/plan/utc", "null", "plan.utc");
    expectPlace("/plan/start/tas", "1e9", "plan.start.tas");
    expectPlace("/plan/settings", "{\"clouds.foo\": 1}", "plan.settings.clouds.foo");
    expectPlace("/plan/settings", "{\"clouds.sigma\": 99}", "plan.settings.clouds.sigma");
    expectPlace("/inputs", "[{\"tick\": -4, \"keys\": 0}]", "inputs[0].tick");
    expectPlace("/inputs", "[{\"tick\": 4, \"keys\": -1}]", "inputs[0].keys");
    expectPlace("/inputs", "[{\"tick\": 4, \"keys\": 0, \"stick\": [5, 0, 0, 0, 0, 0]}]", "inputs[0].stick[0]");
    expectPlace("/inputs", "[{\"tick\": 4, \"keys\": 0, \"stick\": [1]}]", "inputs[0].stick");
    expectPlace("/inputs", "[{\"tick\": 4, \"keys\": 0}, {\"tick\": 3, \"keys\": 0}]", "inputs[1].tick");
    expectPlace("/inputs", "[{\"tick\": 4, \"utc\": 1e300}]", "inputs[0].utc");
    expectPlace("/inputs", "[{\"tick\": 4, \"clock_rate\": 601}]", "inputs[0].clock_rate");
    expectPlace("/inputs", "[{\"tick\": 4, \"setting\": \"clouds.sigma\", \"value\": \"x\"}]", "inputs[0].value");
    expectPlace("/inputs", "[{\"tick\": 4}]", "inputs[0]");
}

TEST(BadInput, SaysThatTheDiskIsFull) {
    expectRefused(kFly + "--log /dev/full", {"/dev/full", "No space left"});
    expectRefused(kFly + "--report /dev/full", {"/dev/full", "No space left"});
}

TEST(BadInput, NamesAMissingFileOfTheData) {
    path const data = scratch() / "nowhere";
    expectRefused(kFly, {"nowhere", "LUFTPOST_DATA"}, "LUFTPOST_DATA='" + data.string() + "'");
}

TEST(BadInput, NamesAMissingShader) {
    // The whole data but for the shaders' passes.
    path const data = scratch() / "data_without_shaders";
    path const root{LUFTPOST_SOURCE_DIR};
    std::filesystem::create_directories(data / "shaders");
    std::filesystem::create_directory_symlink(root / "assets", data / "assets");
    expectRefused("play --headless --seconds 1 --size 64x36", {"shaders"},
                  "LUFTPOST_DATA='" + data.string() + "'");
}

TEST(BadInput, IsAShaderThatDoesNotCompileAndIsSaidInOneLine) {
    path const data = scratch() / "data_with_a_broken_shader";
    path const root{LUFTPOST_SOURCE_DIR};
    std::filesystem::create_directories(data);
    std::filesystem::create_directory_symlink(root / "assets", data / "assets");
    std::filesystem::copy(root / "shaders", data / "shaders", std::filesystem::copy_options::recursive);
    path const shader = data / "shaders/pass/terrain.vert";
    writeText(shader, luftpost::tests::fileText(shader) + "\nnonsense\n");
    expectRefused("play --headless --seconds 1 --size 64x36", {"shaders/pass/terrain.vert", "compiles"},
                  "LUFTPOST_DATA='" + data.string() + "'");
}

TEST(Help, IsOnStandardOutputAndIsNoError) {
    for (char const* command : {"--help", "play --help", "replay --help"}) {
        Outcome const outcome = run(command);
        EXPECT_EQ(outcome.code, 0) << command;
        EXPECT_EQ(outcome.err, "") << command;
        EXPECT_NE(outcome.out.find("--weather"), std::string::npos) << command;
    }
}
}  // namespace
