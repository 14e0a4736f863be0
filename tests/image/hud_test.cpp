// The HUD is legible over snow and at night, at 720 lines and at 4K, and leaves the target and the middle free.
#include "game/ui/hud.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "game/app/settings.h"
#include "game/ui/devices.h"
#include "game/ui/hud_geometry.h"
#include "game/ui/menu.h"
#include "game/ui/screen_frame.h"
#include "tests/image/list_raster.h"

namespace {
using namespace luftpost;
using test::Picture;

ui::HudState flying() {
    ui::HudState state;
    state.time = 10.1;  // the dot is bright
    state.utc = 1687545600.0;
    state.positionWorld = {0.0, 700.0, 0.0};
    state.velocityWorld = {30.0, 2.1, -38.0};
    state.windWorld = {5.0, 0.0, 3.0};
    state.indicatedSpeed = 50.0;
    state.height = 312.0;
    state.heading = 0.64;
    state.throttle = 0.72;
    state.rpm = 2310.0;
    state.fuel_kg = 78.0;
    state.target = ui::HudTarget{"Alder Meadow", {1500.0, 420.0, -1800.0}, 150.0};
    state.weather = {"Basel, 23 June 2023", "recorded", 2400.0};
    state.camera.positionWorld = {-12.0, 704.0, 12.0};
    state.camera.worldFromCamera = glm::angleAxis(-0.67, glm::dvec3{0.0, 1.0, 0.0});
    state.camera.horizontalFov = 1.3;
    return state;
}

Picture drawn(ui::HudState const& state, glm::ivec2 size, glm::vec3 ground) {
    ui::ScreenFrame frame;
    frame.begin(size, 1.0f, 1.0 / 60.0, nullptr);
    ui::drawHud(state);
    Picture picture{size.x, size.y, ground};
    test::drawLists(picture, *frame.end());
    return picture;
}

float luminance(glm::vec3 encoded) {  // WCAG 2: relative luminance of sRGB
    auto const linear = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return 0.2126f * linear(encoded.x) + 0.7152f * linear(encoded.y) + 0.0722f * linear(encoded.z);
}

/// Contrast of the brightest against the darkest pixel in a box given in units of 1/720 of the height.
float contrast(Picture& picture, glm::ivec2 from, glm::ivec2 to) {
    float low = 1.0f, high = 0.0f;
    int const s = picture.height / 720;
    for (int y = from.y * s; y < to.y * s; ++y)
        for (int x = from.x * s; x < to.x * s; ++x) {
            float const l = luminance(picture.at(x, y));
            low = std::min(low, l), high = std::max(high, l);
        }
    return (high + 0.05f) / (low + 0.05f);
}

TEST(Hud, IsLegibleOverSnowAndAtNightAt720LinesAndIn4K) {
    struct Box {
        char const* what;
        glm::ivec2 from, to;
    };
    Box const boxes[] = {{"speed", {66, 580}, {130, 612}}, {"altitude", {1112, 580}, {1200, 612}}, {"score", {20, 12}, {130, 60}},
                         {"clock", {1080, 12}, {1250, 36}}, {"heading", {610, 44}, {670, 68}}, {"distance", {405, 648}, {485, 680}}};
    for (glm::ivec2 const size : {glm::ivec2{1280, 720}, glm::ivec2{3840, 2160}})
        for (float ground : {1.0f, 0.0f, 0.5f}) {
            Picture picture = drawn(flying(), size, glm::vec3{ground});
            for (Box const& box : boxes)  // WCAG's AAA for text is 7
                EXPECT_GT(contrast(picture, box.from, box.to), 7.0f) << box.what << " over " << ground << " at " << size.y;
        }
}

TEST(Hud, ShowsAsMuchAsIsAskedFor) {
    auto const touched = [](ui::HudDensity density, bool inside) {
        ui::HudState state = flying();
        state.density = density;
        state.inside = inside;
        Picture picture = drawn(state, {1280, 720}, glm::vec3{0.5f});
        return std::count_if(picture.pixels.begin(), picture.pixels.end(), [](glm::vec3 p) { return p != glm::vec3{0.5f}; });
    };
    using enum ui::HudDensity;
    EXPECT_GT(touched(full, false), touched(reduced, false) + 30000);
    EXPECT_GT(touched(reduced, false), touched(minimal, false) + 30000);
    EXPECT_GT(touched(minimal, false), 20000) << "speed, height, heading and the way";
    ui::HudState state = flying();
    state.inside = true;
    Picture picture = drawn(state, {1280, 720}, glm::vec3{0.5f});
    for (int y = 470; y < 720; ++y)
        for (int x = 240; x < 1040; ++x) ASSERT_EQ(picture.at(x, y), glm::vec3{0.5f}) << "the panel is free at " << x << ", " << y;
}

TEST(Hud, MarksTheLimitsOfTheSpeedByMoreThanColour) {
    ui::HudState slow = flying(), fast = flying();
    slow.indicatedSpeed = 24.0, fast.indicatedSpeed = 80.0;
    for (ui::HudState const& state : {slow, fast}) {  // the hatched band beside the scale: strokes of ink in it
        Picture picture = drawn(state, {1280, 720}, glm::vec3{0.5f});
        int changes = 0;
        bool const below = state.indicatedSpeed < 50.0;
        for (int y = below ? 425 : 260; y < (below ? 540 : 390); ++y)
            changes += std::abs(luminance(picture.at(92, y)) - luminance(picture.at(92, y + 1))) > 0.02f;
        EXPECT_GT(changes, 10) << state.indicatedSpeed;
    }
}

TEST(Hud, TellsALandingForSomeSeconds) {
    ui::HudState state = flying();
    state.landing = ui::HudLanding{.touchdownSpeed = 0.8, .speed = 27.0, .loadFactor = 1.3, .drift = 0.6, .onAirfield = true, .beyondAim = 35.0, .offLine = -3.0, .age = 2.0};
    for (float ground : {1.0f, 0.0f}) {
        Picture picture = drawn(state, {1280, 720}, glm::vec3{ground});
        EXPECT_GT(contrast(picture, {500, 150}, {780, 250}), 7.0f) << "over " << ground;
    }
    Picture const before = drawn(flying(), {1280, 720}, glm::vec3{0.5f});
    state.landing->age = ui::kLandingSeconds + 0.1;
    EXPECT_EQ(drawn(state, {1280, 720}, glm::vec3{0.5f}).pixels, before.pixels) << "and no longer";
}

TEST(Hud, SaysThatTheFlightIsPaused) {
    ui::HudState paused = flying();
    paused.paused = true;
    for (float ground : {1.0f, 0.0f}) {
        Picture picture = drawn(paused, {1280, 720}, glm::vec3{ground});
        EXPECT_GT(contrast(picture, {572, 272}, {708, 304}), 7.0f) << "over " << ground;
    }
}

TEST(Hud, LeavesTheMiddleOfThePictureAndTheTargetFree) {
    Picture picture = drawn(flying(), {1280, 720}, glm::vec3{0.5f});
    auto const target = ui::seenAt(flying().camera, {1280.0f, 720.0f}, flying().target->positionWorld);
    ASSERT_TRUE(target);
    int touched = 0;
    for (int y = 170; y < 540; ++y)
        for (int x = 240; x < 1040; ++x) touched += picture.at(x, y) != glm::vec3{0.5f};
    EXPECT_GT(touched, 200);   // the pin and its name
    EXPECT_LT(touched, 8000);  // and little else: under 3 % of the middle
    for (int dy = -4; dy <= 30; ++dy)
        for (int dx = -30; dx <= 30; ++dx)
            EXPECT_EQ(picture.at(static_cast<int>(target->x) + dx, static_cast<int>(target->y) + dy), glm::vec3{0.5f}) << dx << ", " << dy;
}

/// Pixels of the navigation bar's field that are black, and that are of the target's blue.
struct FieldCount {
    int black = 0, blue = 0;
};
FieldCount countField(Picture& picture) {
    FieldCount count;
    for (int y = 615; y < 706; ++y)
        for (int x = 492; x < 788; ++x) {
            glm::vec3 const c = picture.at(x, y);
            count.black += std::max({c.x, c.y, c.z}) < 0.02f;
            count.blue += c.z > 0.8f && c.x < 0.2f && c.y < 0.5f;
        }
    return count;
}

TEST(Hud, DrawsABlackArrowAndABlueDotThatBlinks) {
    ui::HudState state = flying();
    Picture bright = drawn(state, {1280, 720}, glm::vec3{0.6f});
    state.time += 0.8 / 1.6;  // into the dark part of the blink
    Picture dark = drawn(state, {1280, 720}, glm::vec3{0.6f});
    EXPECT_GT(countField(bright).black, 80);
    EXPECT_GT(countField(bright).blue, 60);
    EXPECT_LT(countField(dark).blue, countField(bright).blue / 3);
    state.velocityWorld = {0.0, -3.0, 0.0};
    Picture still = drawn(state, {1280, 720}, glm::vec3{0.6f});
    EXPECT_LT(countField(still).black, countField(dark).black - 60);
}

TEST(Hud, DrawsNothingWhenHidden) {
    ui::HudState state = flying();
    state.visible = false;
    Picture picture = drawn(state, {640, 360}, glm::vec3{0.25f});
    EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](glm::vec3 p) { return p == glm::vec3{0.25f}; }));
}

TEST(Hud, PointsTheWindsArrowFromWhereItBlowsOnTheNose) {
    constexpr double kEast = 0.5 * 3.141592653589793;
    auto const expect = [](glm::vec2 arrow, glm::vec2 wanted) { EXPECT_LT(glm::distance(arrow, wanted), 1e-6f) << arrow.x << ", " << arrow.y; };
    glm::dvec3 const toWest{-8.0, 0.0, 0.0};
    expect(ui::windArrow(toWest, kEast), {0.0f, 1.0f});         // on the nose: down the screen
    expect(ui::windArrow(toWest, -kEast), {0.0f, -1.0f});       // from behind
    expect(ui::windArrow(toWest, 0.0), {-1.0f, 0.0f});          // flying north, from the right
    expect(ui::windArrow(toWest, 2.0 * kEast), {1.0f, 0.0f});   // flying south, from the left
    expect(ui::windArrow({3.0, 1.0, 3.0}, 0.0), glm::vec2{0.70710678f, 0.70710678f});
}

TEST(Hud, CutsNoNumberShort) {
    ui::HudState state = flying();  // the widest readings of each kind
    state.score = 1'234'567, state.deliveries = 99'999;
    state.positionWorld.y = 11'999.0, state.height = 11'000.0, state.velocityWorld = {199.0, -60.0, 199.0};
    state.indicatedSpeed = 188.0, state.rpm = 3990.0, state.fuel_kg = 240.0;
    for (glm::ivec2 const size : {glm::ivec2{1280, 720}, glm::ivec2{1024, 768}}) {
        Picture picture = drawn(state, size, glm::vec3{0.5f});
        for (int y = 0; y < picture.height; ++y)  // the outermost pixels stay free on either side
            for (int x : {0, 1, 2, picture.width - 3, picture.width - 2, picture.width - 1})
                ASSERT_EQ(picture.at(x, y), glm::vec3{0.5f}) << x << ", " << y;
    }
}

struct TestSettings {
    double roll = 1.0;
    bool trees = true;
};
constexpr std::tuple kTestFields{core::Field{&TestSettings::roll, "aircraft.rollFactor", 0.0, 2.0, "Share of the roll command"},
                                 core::Field{&TestSettings::trees, "graphics.trees", "Trees are drawn"}};

ui::MenuWeather fairWeather() {
    ui::MenuWeather weather;
    weather.sources = {{"preset:fair", "Fair", "", true}};
    weather.current = "preset:fair";
    weather.utc = 1687545600.0;
    return weather;
}

/// One frame of the config menu with the pointer there, its button up or down.
ui::ConfigAnswer frameOfMenu(ui::ScreenFrame& frame, core::SettingList const& list, glm::dvec2 pointer, bool down) {
    platform::Input input;
    input.mouse = pointer;
    input.mouseHeld[0] = down;
    frame.begin({1280, 720}, 1.0f, 1.0 / 60.0, &input);
    ui::MenuWeather const weather = fairWeather();
    ui::Bindings const bindings;
    ui::BindingsPage page;
    ui::ConfigAnswer answer = ui::drawConfigMenu(list, {weather, bindings, page});
    frame.end();
    return answer;
}

TEST(ConfigMenu, ShowsThatAllItsPagesAreThere) {
    app::Settings settings;
    core::SettingList const list = app::settingList(settings);
    for (glm::ivec2 const size : {glm::ivec2{960, 540}, glm::ivec2{1280, 720}, glm::ivec2{1024, 768}}) {
        ui::ScreenFrame frame;
        ui::BindingsPage page;
        for (int i = 0; i < 3; ++i) {
            frame.begin(size, 1.0f, 1.0 / 60.0, nullptr);
            ui::drawConfigMenu(list, {fairWeather(), settings.bindings, page});
            frame.end();
        }
        ImGuiTabBar const& tabs = *ImGui::GetCurrentContext()->TabBars.GetByIndex(0);
        EXPECT_EQ(tabs.Tabs.Size, 8) << "aircraft, weather, clouds, picture, view, sound, controls, keys";
        EXPECT_LE(tabs.WidthAllTabsIdeal, tabs.BarRect.GetWidth()) << "no tab behind the arrows at " << size.x;
    }
}

TEST(KeysPage, IsSeenWhole) {
    for (glm::ivec2 const size : {glm::ivec2{960, 540}, glm::ivec2{1280, 720}}) {
        ui::ScreenFrame frame;
        for (int i = 0; i < 3; ++i) {
            frame.begin(size, 1.0f, 1.0 / 60.0, nullptr);
            ui::drawKeysPage(ui::keyHelp(ui::Bindings{}));
            frame.end();
        }
        ImGuiWindow const* page = ImGui::FindWindowByName("keys");
        ASSERT_TRUE(page);
        for (ImGuiWindow const* part : ImGui::GetCurrentContext()->Windows) EXPECT_EQ(part->ScrollMax.y, 0.0f) << part->Name;
        EXPECT_GE(page->Pos.y, 0.0f);
        EXPECT_LE(page->Pos.y + page->Size.y, static_cast<float>(size.y));
    }
}

TEST(ConfigMenu, ChangesASettingByDraggingAndTakesItBackByItsButton) {
    TestSettings settings;
    core::SettingList list;
    core::appendSettings(list, settings, kTestFields);
    ui::ScreenFrame frame;
    for (int i = 0; i < 3; ++i) frameOfMenu(frame, list, {10.0, 10.0}, false);
    glm::dvec2 const slider{1190.0, 184.0}, back{1226.0, 184.0}, cross{1247.0, 98.0};  // as the menu stands at 1280 x 720
    frameOfMenu(frame, list, slider, false);
    ui::ConfigAnswer const dragged = frameOfMenu(frame, list, slider, true);
    ASSERT_EQ(dragged.changes.size(), 1u);
    EXPECT_EQ(dragged.changes[0].key, "aircraft.rollFactor");
    EXPECT_GT(std::get<double>(dragged.changes[0].value), 1.5);
    EXPECT_LE(std::get<double>(dragged.changes[0].value), 2.0);
    list[0].set(dragged.changes[0].value);
    frameOfMenu(frame, list, slider, false);
    frameOfMenu(frame, list, back, false);
    frameOfMenu(frame, list, back, true);
    ui::ConfigAnswer const reset = frameOfMenu(frame, list, back, false);
    ASSERT_EQ(reset.changes.size(), 1u);
    EXPECT_EQ(std::get<double>(reset.changes[0].value), 1.0);
    list[0].set(reset.changes[0].value);
    frameOfMenu(frame, list, cross, false);
    frameOfMenu(frame, list, cross, true);
    EXPECT_TRUE(frameOfMenu(frame, list, cross, false).close);
}
}  // namespace
