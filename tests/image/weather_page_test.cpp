// The weather's page: everything fits at the usual sizes, the strip shows the hours, and the controls answer.
#include "game/ui/weather_page.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cmath>

#include "engine/assets/image.h"
#include "engine/core/time.h"
#include "engine/weather/source.h"
#include "game/app/settings.h"
#include "game/app/weather_desk.h"
#include "game/ui/air_overlay.h"
#include "game/ui/menu.h"
#include "game/ui/screen_frame.h"
#include "tests/image/list_raster.h"

namespace {
using namespace luftpost;
using test::Picture;

/// The menu as a real flight over Basel's storm has it.
struct Basel {
    app::Session session{options()};
    app::WeatherDesk desk{session.world().source()};

    static app::SessionOptions options() {
        app::SessionOptions options;
        app::HoursFile const hours = app::readHours(std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/hours.json");
        options.plan = app::planFor(hours.hours.front(), {});
        return options;
    }
    ui::MenuWeather menu() {
        ui::MenuWeather weather = desk.menu(session);
        weather.photo = {"basel_20230622_1721.jpg", "taken 2023-06-22 17:21 UTC, by EXIF", "colours alike 0.731 (CIELAB histogram intersection, 0..1); to move: L* 4.1, a* 0.8, b* 3.2", {}, {400, 300}};
        return weather;
    }
};

constexpr char const* kTabs[] = {"Recorded", "Hours", "By hand", "Photograph"};

/// Frames of the menu on one of the weather's own pages; what the last one answered.
ui::WeatherAnswer drawPage(ui::ScreenFrame& frame, ui::MenuWeather const& weather, char const* tab, glm::ivec2 size, Picture* picture = nullptr,
                           platform::Input const* input = nullptr, int frames = 4) {
    app::Settings settings;
    core::SettingList const list = app::settingList(settings);
    ui::BindingsPage page;
    ui::WeatherAnswer answer;
    for (int i = 0; i < frames; ++i) {
        frame.begin(size, 1.0f, 1.0 / 60.0, input);
        answer = ui::drawConfigMenu(list, {weather, ui::Bindings{}, page, nullptr, true}).weather;
        if (i < 2)
            for (int bar = 0; bar < ImGui::GetCurrentContext()->TabBars.GetMapSize(); ++bar)
                if (ImGuiTabBar* tabs = ImGui::GetCurrentContext()->TabBars.TryGetMapData(bar))
                    for (ImGuiTabItem& item : tabs->Tabs)
                        if (std::string_view{tabs->GetTabName(&item)} == tab) tabs->NextSelectedTabId = item.ID;
        ImDrawData* const lists = frame.end();
        if (picture && i + 1 == frames) test::drawLists(*picture, *lists);
    }
    return answer;
}

TEST(WeatherPage, FitsItsWidthOnEveryPageAt720And1080Lines) {
    Basel basel;
    for (glm::ivec2 const size : {glm::ivec2{1280, 720}, glm::ivec2{1920, 1080}, glm::ivec2{960, 540}})
        for (char const* tab : kTabs) {
            ui::ScreenFrame frame;
            drawPage(frame, basel.menu(), tab, size);
            int seen = 0;
            for (ImGuiWindow const* window : ImGui::GetCurrentContext()->Windows) {
                if (!window->WasActive || std::string_view{window->Name}.find("rows") == std::string_view::npos) continue;
                ++seen;
                for (ImDrawVert const& vertex : window->DrawList->VtxBuffer) {
                    EXPECT_GE(vertex.pos.x, window->Pos.x - 4.0f) << tab << " at " << size.y;
                    ASSERT_LE(vertex.pos.x, window->Pos.x + window->Size.x + 1.0f) << tab << " at " << size.y;
                }
            }
            EXPECT_EQ(seen, 1) << tab << " at " << size.y;
        }
}

TEST(WeatherPage, ShowsTimeStripMomentsAndSpeedWithoutScrolling) {
    Basel basel;
    ui::ScreenFrame frame;
    drawPage(frame, basel.menu(), "Recorded", {1280, 720});
    for (ImGuiWindow const* window : ImGui::GetCurrentContext()->Windows)
        if (window->WasActive && std::string_view{window->Name}.find("rows") != std::string_view::npos) {
            EXPECT_GT(window->InnerRect.GetHeight(), 330.0f) << "of which strip, slider, steps, moments and speed take about 320";
        }
}

/// Mean brightness of a box of pixels.
float brightness(Picture& picture, glm::ivec2 from, glm::ivec2 to) {
    float sum = 0.0f;
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) sum += (picture.at(x, y).x + picture.at(x, y).y + picture.at(x, y).z) / 3.0f;
    return sum / static_cast<float>((to.x - from.x) * (to.y - from.y));
}

TEST(WeatherPage, TheStripFillsItsRowsByCover) {
    ui::WeatherStrip strip{0.0, 4.0 * 3600.0, {}, {}};
    for (int i = 0; i < 4; ++i) {
        ui::StripColumn column;
        column.time = (i + 0.5) * 3600.0;
        column.low = i * 0.25;  // 0, 2, 4, 6 eighths
        strip.columns.push_back(column);
    }
    ui::ScreenFrame frame;
    frame.begin({640, 360}, 2.0f, 1.0 / 60.0, nullptr);
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({640.0f, 360.0f});
    ImGui::Begin("strip", nullptr, ImGuiWindowFlags_NoDecoration);
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    ui::drawWeatherStrip(strip, 0.0, 560.0f);
    ImGui::End();
    Picture picture{640, 360, glm::vec3{0.0f}};
    test::drawLists(picture, *frame.end());
    float before = 0.0f;
    for (int i = 0; i < 4; ++i) {  // the low row lies 34 to 54 units below the top, under the spacing of 11; the columns begin 42 from the left
        int const x = static_cast<int>(corner.x) + 42 + 12 + i * 111, y = static_cast<int>(corner.y) + 46;
        float const now = brightness(picture, {x, y}, {x + 86, y + 18});
        EXPECT_GT(now, before + (i == 0 ? 0.0f : 0.08f)) << i;
        before = now;
    }
}

TEST(WeatherPage, APressOnTheStripSetsTheTime) {
    Basel basel;
    ui::MenuWeather const weather = basel.menu();
    ui::ScreenFrame frame;
    drawPage(frame, weather, "Recorded", {1280, 720});
    platform::Input input;
    input.mouse = {1000.0, 260.0};
    drawPage(frame, weather, "Recorded", {1280, 720}, nullptr, &input, 2);
    input.mouseHeld[0] = true;
    ui::WeatherAnswer const answer = drawPage(frame, weather, "Recorded", {1280, 720}, nullptr, &input, 1);
    ASSERT_TRUE(answer.utc);
    EXPECT_GT(*answer.utc, weather.start);
    EXPECT_LT(*answer.utc, weather.end);
}

TEST(WeatherDesk, AHandThatDragsSendsFewInputsAndTheLastOneCounts) {
    Basel basel;
    app::Session& session = basel.session;
    ui::HandWeather hand;
    double last = 0.0;
    for (int i = 0; i < 60; ++i) {  // a second of dragging at 60 frames a second
        ui::WeatherAnswer answer;
        hand.speed_mps = last = 3.0 + 0.1 * i;
        ui::tidy(hand);
        answer.hand = hand;
        basel.desk.obey(answer, session);
        basel.desk.advance(1.0 / 60.0, false, session);
        EXPECT_FALSE(session.enterOffered());
        for (int k = 0; k < 4; ++k) session.tick();
    }
    for (int i = 0; i < 300 && session.world().field().at(0.0, 0.0, session.simulation().utc()).windSurface == glm::dvec2{0.0}; ++i) session.tick();
    for (int i = 0; i < 900; ++i) {
        basel.desk.advance(1.0 / 60.0, false, session);
        EXPECT_FALSE(session.enterOffered());
        for (int k = 0; k < 4; ++k) session.tick();
    }
    std::size_t inputs = 0;
    for (app::StampedInput const& input : session.replay().inputs) inputs += std::holds_alternative<app::WeatherInput>(input.what);
    EXPECT_GE(inputs, 1u);
    EXPECT_LE(inputs, 6u);
    EXPECT_EQ(session.world().source(), app::kHandSource);
    EXPECT_NEAR(glm::length(session.world().field().at(0.0, 0.0, session.simulation().utc()).windSurface), last, 0.05);
}

TEST(WeatherDesk, TheClockRunsAsFastAsAskedAndAReplayKnowsIt) {
    Basel basel;
    app::Session& session = basel.session;
    double const start = session.simulation().utc();
    for (int i = 0; i < 240; ++i) session.tick();
    EXPECT_NEAR(session.simulation().utc(), start + 1.0, 1e-6);
    ui::WeatherAnswer answer;
    answer.rate = 60.0;
    basel.desk.obey(answer, session);
    for (int i = 0; i < 240; ++i) session.tick();
    EXPECT_NEAR(session.simulation().utc(), start + 61.0, 1e-6);
    answer.rate = 0.0;
    basel.desk.obey(answer, session);
    for (int i = 0; i < 240; ++i) session.tick();
    EXPECT_NEAR(session.simulation().utc(), start + 61.0, 1e-6);
    app::SessionOptions again = Basel::options();
    again.script = session.replay().inputs;
    app::Session replayed{again};
    for (int i = 0; i < 720; ++i) replayed.tick();
    EXPECT_EQ(replayed.simulation().stateHash(), session.simulation().stateHash());
}

TEST(AirOverlay, TellsUpFromDownWithoutColourByDayAndByNight) {
    for (float ground : {0.9f, 0.05f}) {
        int filled[2] = {0, 0};
        for (bool const up : {true, false}) {
            ui::AirView view;
            view.camera.positionWorld = {0.0, 500.0, 0.0};
            view.camera.horizontalFov = 1.3;
            view.subject.positionWorld = {0.0, 490.0, -10.0};
            for (int i = 0; i < 22; ++i) view.lift.push_back({{250.0 * (i - 11), 2000.0}, up ? 3.0 : -3.0});
            ui::ScreenFrame frame;
            frame.begin({1280, 720}, 1.0f, 1.0 / 60.0, nullptr);
            ui::drawAirOverlay(view);
            Picture picture{1280, 720, glm::vec3{ground}};
            test::drawLists(picture, *frame.end());
            int touched = 0;
            for (int y = 90; y < 270; ++y)  // the map of lift at the right edge
                for (int x = 1070; x < 1250; ++x) {
                    glm::vec3 const c = picture.at(x, y);
                    bool const bright = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z > 0.45f;
                    filled[up ? 0 : 1] += bright && y > 115;
                    touched += bright;
                }
            EXPECT_GT(touched, 60) << "over " << ground;
        }
        EXPECT_GT(filled[0], filled[1] + 40) << "a filled head has more light than an empty one, over " << ground;
    }
}
}  // namespace
