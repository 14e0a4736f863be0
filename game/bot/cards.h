// Test cards: each flies one manoeuvre closed-loop through the input layer and measures it, as a test pilot with a
// recorder on board does: looks every tick, moves the hands 20 times a second.
#pragma once
#include <span>
#include <string_view>

#include "engine/flight/airframe.h"
#include "game/bot/manoeuvre.h"
#include "game/bot/pilot.h"
#include "game/bot/test_pilot.h"

namespace luftpost::bot {
/// What a card is called that is none of the test cards: `--bot circuit`.
inline constexpr std::string_view kCircuit = "circuit";
/// Of `--bot card:NAME`.
std::span<std::string_view const> cardNames();

/// Where cards are flown.
struct CardGround {
    glm::dvec2 thresholdEastNorth{0.0};  // the runway begins here ...
    double heading = 0.0;                // ... and goes this way, rad clockwise from north
    double altitude = 0.0;               // m above sea level, of the runway
    double clear = 30.0;   // m above sea level: nothing within 6 km of the runway reaches up to it
    double clearFar = 100.0;  // the same within 40 km
    double gust = 0.0;        // m/s, what gusts add to the wind at the runway, as reported
};
/// How a card begins; wings level and trimmed, or at rest on the runway's threshold.
struct CardStart {
    bool runway = false;
    glm::dvec2 eastNorth{0.0};
    double altitude = 0.0;  // m above sea level
    double tas = 0.0;       // m/s
    double heading = 0.0;   // rad clockwise from north
};

class Card : public Pilot {
public:
    static constexpr double kCrosswind_kt = 15.0;  // from the runway's right: what the card of this name needs

    /// `name` is one of cardNames() or kCircuit.
    /// Each card measures the bare aircraft, with assist sim; only the circuit is flown with any `assist`.
    Card(std::string_view name, flight::Airframe const& airframe, CardGround const& ground,
         flight::AssistLevel assist = flight::AssistLevel::sim);
    Card(Card const&) = delete;
    Card& operator=(Card const&) = delete;

    CardStart const& start() const { return start_; }
    std::string const& name() const { return name_; }

    void look(flight::AircraftState const& state) override;
    ui::InputSample decide(ui::HudState const&) override;
    flight::Controls const& hands() const { return pilot_.stick; }
    Figures const* figures() const override { return &figures_; }
    bool finished() const override { return finished_; }

private:
    struct Path {
        double climb_mps = 0.0, run_m = 0.0;
    };
    static constexpr double kPathSeconds = 40.0;

    // Where the runway's line and the air work are.
    CardStart startOnRunway() const;
    CardStart startInAir(double altitude, double stalls) const;
    CardStart startOnFinal() const;
    double along() const;
    double across() const;
    double drift() const;
    double windAcross() const;  // m/s from the right
    double stalls(double share) const;  // m/s, so many times the stall's speed in whole knots
    void put(std::string key, double value) { figures_.emplace_back(std::move(key), value); }
    flight::Readings const& now() const { return pilot_.now(); }
    Turn::NextTick nextTick() { return turn_.nextTick(); }

    Manoeuvre stall();
    Manoeuvre glide();
    Manoeuvre climb();
    Manoeuvre level();
    Manoeuvre ceiling();
    Manoeuvre takeOff();
    Manoeuvre landing();
    Manoeuvre phugoid();
    Manoeuvre shortPeriod();
    Manoeuvre dutchRoll();
    Manoeuvre roll();
    Manoeuvre spiral();
    Manoeuvre trim();
    Manoeuvre circuit();
    Manoeuvre afterwards();
    // What several of them do.
    Manoeuvre slowDown(std::string key);
    Manoeuvre turnBack(double cas);
    Manoeuvre descend(double altitude);
    Manoeuvre flyPath(double cas);
    Manoeuvre flyLevel(double cas, double seconds);
    Manoeuvre fullAileron();
    Manoeuvre leaveToItself();
    Manoeuvre leaveRunway();
    Manoeuvre flyRound();
    Manoeuvre flyFinal();
    Manoeuvre touchDown();
    void rollAlong();
    void flare();
    void followLine(double course, double aside, double gain = 0.004);
    double slopeHeight() const;
    double finalSpeed() const;  // m/s calibrated, of a circuit

    struct Row {
        std::string_view name;
        CardStart (*start)(Card const&);
        Manoeuvre (Card::*fly)();
    };
    static Row const& row(std::string_view name);
    friend std::span<std::string_view const> cardNames();
    static std::span<Row const> rows();

    std::string name_;
    double stall_kt_;      // of the airframe's marks
    double takeoffFlaps_;  // share of their travel
    double takeoffStall_;  // m/s, with the flaps so
    CardGround ground_;
    CardStart start_;
    TestPilot pilot_;
    Turn turn_;
    Manoeuvre manoeuvre_;
    Manoeuvre after_;
    Figures figures_;
    bool began_ = false, over_ = false, finished_ = false;
    long long tick_ = -1;  // of the latest look

    double course_ = 0.0;        // rad, of the air work
    double altitude_ = 0.0;      // m, of the air work
    Path path_;                  // of the latest flyPath
    flight::Controls handsOff_;  // what the latest flyLevel held: the trim
    double alpha_ = 0.0;         // rad, mean of the latest flyLevel
    double measured_ = 0.0, constant_ = 0.0;  // of the latest fullAileron or leaveToItself
};
}  // namespace luftpost::bot
