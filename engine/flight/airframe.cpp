#include "engine/flight/airframe.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
using Json = nlohmann::json;
constexpr double kRpm = 2.0 * core::kPi / 60.0;

/// One object of the file, which knows where it stands. Every key that it holds must be asked for.
class Reader {
public:
    Reader(Json const& json, std::string file, std::string place)
        : json_{json}, file_{std::move(file)}, place_{std::move(place)} {
        if (!json.is_object()) refuse("", "an object");
    }

    [[noreturn]] void refuse(std::string const& key, std::string const& expected) const {
        throw core::Error{file_, pathOf(key), "expected " + expected};
    }
    bool has(std::string const& key) const { return json_.contains(key); }

    double number(std::string const& key, double low, double high) {
        Json const& value = at(key, fmt::format("a number {:g}..{:g}", low, high));
        return inRange(key, value, low, high);
    }
    double number(std::string const& key, double low, double high, double otherwise) {
        return has(key) ? number(key, low, high) : otherwise;
    }
    double angle(std::string const& key, double low_deg, double high_deg) {
        return core::radians(number(key, low_deg, high_deg));
    }
    double angle(std::string const& key, double low_deg, double high_deg, double otherwise_deg) {
        return core::radians(number(key, low_deg, high_deg, otherwise_deg));
    }
    bool flag(std::string const& key) {
        if (!has(key)) return false;
        if (!at(key, "").is_boolean()) refuse(key, "true or false");
        return json_[key].get<bool>();
    }
    std::string text(std::string const& key) {
        Json const& value = at(key, "a text");
        if (!value.is_string() || value.get<std::string>().empty()) refuse(key, "a text");
        return value.get<std::string>();
    }
    template <class T>
    T word(std::string const& key, std::vector<std::pair<std::string, T>> const& words) {
        std::string all;
        for (auto const& [name, value] : words) all += (all.empty() ? "one of " : ", ") + name;
        Json const& found = at(key, all);
        for (auto const& [name, value] : words)
            if (found.is_string() && found.get<std::string>() == name) return value;
        refuse(key, all);
    }
    std::vector<double> numbers(std::string const& key, double low, double high) {
        Json const& list = at(key, "a list of numbers");
        if (!list.is_array()) refuse(key, "a list of numbers");
        std::vector<double> values;
        for (Json const& value : list) values.push_back(inRange(key, value, low, high));
        return values;
    }
    glm::dvec3 point(std::string const& key) {
        std::vector<double> const values = numbers(key, -50.0, 50.0);
        if (values.size() != 3) refuse(key, "three numbers [forward, up, right] in m");
        return glm::dvec3{values[0], values[1], values[2]};
    }
    Reader object(std::string const& key) { return Reader{at(key, "an object"), file_, pathOf(key)}; }
    std::vector<Reader> objects(std::string const& key, std::size_t most) {
        Json const& list = at(key, "a list of objects");
        if (!list.is_array() || list.empty() || list.size() > most)
            refuse(key, fmt::format("a list of 1 to {} objects", most));
        std::vector<Reader> readers;
        for (std::size_t i = 0; i < list.size(); ++i)
            readers.emplace_back(list[i], file_, fmt::format("{}[{}]", pathOf(key), i));
        return readers;
    }
    void finish() const {
        for (auto const& [key, value] : json_.items())
            if (!asked_.contains(key)) refuse(key, "no such key (a slip of the pen?)");
    }

private:
    std::string pathOf(std::string const& key) const {
        return place_.empty() ? key : key.empty() ? place_ : place_ + "." + key;
    }
    Json const& at(std::string const& key, std::string const& expected) {
        asked_.insert(key);
        if (!has(key)) refuse(key, expected + ", found nothing");
        return json_[key];
    }
    double inRange(std::string const& key, Json const& value, double low, double high) const {
        if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high))
            refuse(key, fmt::format("a number {:g}..{:g}, found {}", low, high, value.dump()));
        return value.get<double>();
    }

    Json const& json_;
    std::string file_, place_;
    std::set<std::string> asked_;
};

StripData readStrip(Reader& in) {
    StripData s;
    s.name = in.text("name");
    s.place = in.word<StripPlace>("place", {{"wing", StripPlace::wing},
                                            {"tail", StripPlace::tail},
                                            {"fin", StripPlace::fin},
                                            {"fuselage", StripPlace::fuselage}});
    s.position = in.point("position");
    double const lean = in.angle("normalFromUp_deg", -90.0, 90.0, 0.0);  // + leans right
    s.normal = glm::dvec3{0.0, core::cos(lean), core::sin(lean)};
    s.area = in.number("area_m2", 0.01, 200.0);
    s.chord = in.number("chord", 0.05, 20.0);
    s.incidence = in.angle("incidence_deg", -15.0, 15.0, 0.0);
    s.liftSlope = in.number("liftSlope", 0.0, 7.0);
    s.zeroLiftAngle = in.angle("zeroLift_deg", -10.0, 10.0, 0.0);
    s.stallAngle = in.angle("stall_deg", 5.0, 60.0);
    s.stallAngleNegative = in.angle("stallNegative_deg", -60.0, -5.0);
    s.stallWidth = in.angle("stallWidth_deg", 0.5, 20.0);
    s.dragZero = in.number("dragZero", 0.0, 2.0);
    s.inducedDrag = in.number("inducedDrag", 0.0, 1.0, 0.0);
    s.momentZero = in.number("momentZero", -0.5, 0.5, 0.0);
    s.wash = in.number("wash", 0.0, 1.0, 0.0);
    s.swirl = in.number("swirl", 0.0, 1.0, 0.0);
    if (in.has("surface")) {
        Reader surface = in.object("surface");
        s.surface = surface.word<ControlSurface>("moves", {{"elevator", ControlSurface::elevator},
                                                           {"aileron", ControlSurface::aileron},
                                                           {"rudder", ControlSurface::rudder},
                                                           {"flap", ControlSurface::flap}});
        s.surfaceLift = surface.number("lift", 0.0, 1.0);
        s.surfaceDrag = surface.number("drag", 0.0, 2.0);
        s.surfaceMoment = surface.number("moment", -2.0, 0.0, 0.0);
        s.surfaceStall = surface.number("stallLoss", 0.0, 1.0, 0.0);
        surface.finish();
    }
    return s;
}

StripData mirrored(StripData strip) {
    strip.position.z = -strip.position.z;
    strip.normal.z = -strip.normal.z;
    return strip;
}

void readStrips(Reader& in, Airframe& frame) {
    for (Reader& item : in.objects("strips", kMaxStrips)) {
        StripData strip = readStrip(item);
        bool const both = item.flag("mirrored");
        if (both && !(strip.position.z > 0.0))
            item.refuse("position", "a place on the right for a mirrored strip");
        std::string const name = strip.name;
        if (both) strip.name = "right " + name;
        frame.strips.push_back(strip);
        if (both) {
            frame.strips.push_back(mirrored(strip));
            frame.strips.back().name = "left " + name;
        }
        item.finish();
    }
    if (frame.strips.size() > kMaxStrips)
        in.refuse("strips", fmt::format("at most {} strips, both sides counted", kMaxStrips));
}

void readPropeller(Reader in, PropellerData& p) {
    p.position = in.point("position");
    p.diameter = in.number("diameter", 0.3, 6.0);
    p.inertia = in.number("inertia_kg_m2", 0.01, 100.0);
    p.advance = in.numbers("advance", 0.0, 5.0);
    p.thrust = in.numbers("thrust", -1.0, 1.0);
    p.power = in.numbers("power", -1.0, 1.0);
    if (p.advance.size() < 2 || p.advance.front() != 0.0)
        in.refuse("advance", "two or more numbers, the first 0");
    for (std::size_t i = 1; i < p.advance.size(); ++i)
        if (!(p.advance[i] > p.advance[i - 1])) in.refuse("advance", "rising numbers");
    if (p.thrust.size() != p.advance.size()) in.refuse("thrust", "as many numbers as advance has");
    if (p.power.size() != p.advance.size()) in.refuse("power", "as many numbers as advance has");
    p.sideForce = in.number("sideForce", 0.0, 2.0);
    p.offset = in.number("offset", 0.0, 2.0);
    in.finish();
}

void readEngine(Reader in, EngineData& e) {
    e.power = in.number("power_kW", 0.0, 5000.0) * 1000.0;
    e.rate = in.number("rate_rpm", 100.0, 10000.0) * kRpm;
    e.idleShare = in.number("idleShare", 0.0, 0.5);
    e.frictionTorque = in.number("frictionTorque_Nm", 0.0, 1000.0);
    e.consumption = in.number("consumption_kg_kWh", 0.0, 5.0) / 3.6e6;
    e.altitudeLoss = in.number("altitudeLoss", 0.0, 0.5);
    in.finish();
}

void readWheels(Reader& in, Airframe& frame) {
    for (Reader& item : in.objects("wheels", kMaxWheels)) {
        WheelData w;
        w.name = item.text("name");
        w.position = item.point("position");
        w.stiffness = item.number("stiffness_kN_m", 1.0, 1000.0) * 1000.0;
        w.damping = item.number("damping_kNs_m", 0.0, 100.0) * 1000.0;
        w.skid = item.flag("skid");
        w.rolling = item.number("rolling", 0.0, 1.0);
        w.braking = item.number("braking", 0.0, 1.5, 0.0);
        w.side = item.number("side", 0.0, 1.5);
        w.steering = item.angle("steering_deg", 0.0, 60.0, 0.0);
        item.finish();
        frame.wheels.push_back(w);
    }
}

void readStrikes(Reader& in, Airframe& frame) {
    for (Reader& item : in.objects("strikes", kMaxStrikes)) {
        frame.strikes.push_back({item.text("name"), item.point("position")});
        item.finish();
    }
}

MassData readMass(Reader in, bool hasMass) {
    MassData m;
    if (hasMass) m.mass = in.number("mass", 1.0, 1.0e5);
    m.position = in.point("position");
    return m;
}

void readMasses(Reader& in, Airframe& frame) {
    Reader empty = in.object("empty");
    frame.empty = {empty.number("mass", 50.0, 1.0e5), empty.point("position")};
    std::vector<double> const i = empty.numbers("inertia_kg_m2", 1.0, 1.0e7);
    if (i.size() != 3) empty.refuse("inertia_kg_m2", "three numbers: about roll, pitch, yaw");
    frame.emptyInertia = glm::dmat3{0.0};
    frame.emptyInertia[0][0] = i[0], frame.emptyInertia[1][1] = i[2], frame.emptyInertia[2][2] = i[1];
    empty.finish();
    frame.pilot = readMass(in.object("pilot"), true);
    Reader payload = in.object("payload"), fuel = in.object("fuel");
    frame.payload.position = payload.point("position");
    frame.payloadMax = payload.number("most", 0.0, 1.0e5);
    payload.finish();
    frame.fuel.position = fuel.point("position");
    frame.fuelMax = fuel.number("most", 0.0, 1.0e5);
    fuel.finish();
}

void readWingAndControls(Reader& in, Airframe& frame) {
    Reader wing = in.object("wing");
    frame.wingArea = wing.number("area_m2", 1.0, 1000.0);
    frame.wingSpan = wing.number("span", 1.0, 100.0);
    frame.wingChord = wing.number("chord", 0.1, 20.0);
    frame.wingHeight = wing.number("heightAboveWheels", 0.0, 20.0);
    frame.downwash = wing.number("downwash", 0.0, 1.0);
    frame.downwashLength = wing.number("downwashLength", 0.1, 50.0);
    wing.finish();
    Reader controls = in.object("controls");
    frame.elevatorUp = controls.angle("elevatorUp_deg", 1.0, 60.0);
    frame.elevatorDown = controls.angle("elevatorDown_deg", 1.0, 60.0);
    frame.aileronUp = controls.angle("aileronUp_deg", 1.0, 60.0);
    frame.aileronDown = controls.angle("aileronDown_deg", 1.0, 60.0);
    frame.rudder = controls.angle("rudder_deg", 1.0, 60.0);
    frame.flapTravel = controls.angle("flaps_deg", 0.0, 60.0);
    double const takeoffFlaps = controls.angle("takeoffFlaps_deg", 0.0, core::degrees(frame.flapTravel));
    frame.takeoffFlaps = frame.flapTravel > 0.0 ? takeoffFlaps / frame.flapTravel : 0.0;
    frame.flapSeconds = controls.number("flapSeconds", 0.1, 60.0);
    frame.surfaceSeconds = controls.number("surfaceSeconds", 0.01, 1.0);
    controls.finish();
}

void readSpeeds(Reader in, Airframe& frame) {
    auto const speed = [&](char const* key) {
        return in.number(key, 5.0, 500.0) * core::kMetresPerSecondPerKnot;
    };
    frame.stallSpeed = speed("stall_kt");
    frame.stallSpeedFlaps = speed("stallFlaps_kt");
    frame.flapLimitSpeed = speed("flapLimit_kt");
    frame.cruiseLimitSpeed = speed("cruiseLimit_kt");
    frame.neverExceedSpeed = speed("neverExceed_kt");
    in.finish();
}
}  // namespace

Airframe parseAirframe(std::string const& text, std::string const& name) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (Json::parse_error const& error) {
        throw core::Error{name, fmt::format("byte {}", error.byte), "expected JSON"};
    } catch (Json::exception const&) {
        throw core::Error{name, "", "expected JSON whose numbers a double holds"};
    }
    Reader in{json, name, ""};
    Airframe frame;
    frame.name = in.text("name");
    if (in.has("about")) in.text("about");
    readMasses(in, frame);
    readWingAndControls(in, frame);
    readStrips(in, frame);
    readPropeller(in.object("propeller"), frame.propeller);
    readEngine(in.object("engine"), frame.engine);
    readWheels(in, frame);
    readStrikes(in, frame);
    frame.touchdownLimit = in.number("touchdownLimit", 0.5, 20.0);
    readSpeeds(in.object("speeds"), frame);
    in.finish();
    return frame;
}

Airframe loadAirframe(std::filesystem::path const& file) {
    return parseAirframe(core::readFile(file), file.string());
}
}  // namespace luftpost::flight
