#!/usr/bin/env python3
"""Writes a recording of Basel / Binningen from MeteoSwiss's open data.

usage: weather_basel.py TEN_MINUTES.csv OBSERVER.csv -o OUT.json

TEN_MINUTES.csv  the station's automatic values (SwissMetNet), semicolons: dkl010z0 fkl010z0 fkl010z1 gre000z0 oli000z0
                 pp0qffs0 rre150z0 sre000z0 tde200s0 tre200s0; `termin` in UTC is the end of the ten minutes
OBSERVER.csv     what a human saw: termin_utc, okta_nto (total cover in eighths), genus_cc1_wmo0500, vis_vho_wmo4377, ww_wmo4677

What was measured or seen stands in the report. What is concluded from it stands in `filled`, so that the game can say so:
- Cover between the observers' hours. By day from global radiation against a clear sky's (Haurwitz 1945) and Kasten and Czeplak's
  G/G0 = 1 - 0.75 (n/8)^3.4, and from the share of sunshine (observed at Basel: 1.00 0.96 0.71 0.60 0.18 0.01 of the direct sun
  at 0 2 5 6 7 8 eighths); by night from long-wave radiation with Brutsaert's clear-sky emissivity 1.24 (e/T)^(1/7). Each is moved so
  that it meets what the observer saw, linearly in time between two looks.
- Genus between the observers' hours: cumulonimbus around heavy showers, nimbostratus around hours of light rain, else what the
  observer saw last, going over to what he saw next. Where two genera share the sky, together they make the cover.
- Bases of low cloud: 125 m per kelvin of dew-point spread (mean over two hours; cumulus keeps the afternoon's base).
- Visibility between the observers' hours: by humidity (Smirnova et al. 2000) and rain, moved by what the observer saw.
"""
import argparse
import csv
import datetime
import json
import math

LAT, LON, ELEVATION = 47.541, 7.584, 316.0
GENERA = {0: "Ci", 1: "Cc", 2: "Cs", 3: "Ac", 4: "As", 5: "Ns", 6: "Sc", 7: "St", 8: "Cu", 9: "Cb"}
SUNSHINE = [(0.0, 8.0), (0.01, 8.0), (0.18, 7.0), (0.60, 6.0), (0.71, 5.0), (0.96, 2.0), (1.0, 0.0)]  # share -> eighths
CONVECTIVE = ("Cu", "Cb")
STEP = 600.0


def utc(text):
    return datetime.datetime.strptime(text, "%Y%m%d%H%M%S").replace(tzinfo=datetime.timezone.utc).timestamp()


def iso(time):
    return datetime.datetime.fromtimestamp(time, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%MZ")


def number(text):
    return float(text) if text.strip() not in ("", "-") else None


def read_ten_minutes(path):
    keys = {"from": "dkl010z0", "speed": "fkl010z0", "gust": "fkl010z1", "global": "gre000z0", "longwave": "oli000z0",
            "pressure": "pp0qffs0", "rain": "rre150z0", "sun": "sre000z0", "dew": "tde200s0", "temperature": "tre200s0"}
    with open(path, newline="", encoding="utf-8") as file:
        return [dict({name: number(row[key]) for name, key in keys.items()}, time=utc(row["termin"]))
                for row in csv.DictReader(file, delimiter=";")]


def visibility_of_code(code):
    """WMO code table 4377 in metres; nothing where the code names no distance."""
    if 1 <= code <= 50:
        return 100.0 * code
    if 56 <= code <= 80:
        return 1000.0 * (code - 50)
    if 81 <= code <= 88:
        return 30000.0 + 5000.0 * (code - 80)
    return None


def read_observer(path, first, last):
    looks = []
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            time = utc(row["termin_utc"])
            if not first <= time <= last or row["okta_nto"] == "":
                continue
            genus, code, weather = row["genus_cc1_wmo0500"], row["vis_vho_wmo4377"], row["ww_wmo4677"]
            looks.append({"time": time, "cover": min(int(row["okta_nto"]), 8) / 8.0,
                          "genus": GENERA[int(genus)] if genus else None,
                          "visibility": visibility_of_code(int(code)) if code else None,
                          "weather": int(weather) if weather else None})
    return looks


def sun_height(time):
    """Sine of the sun's height (Spencer 1971), good to a few hundredths of a degree here."""
    date = datetime.datetime.fromtimestamp(time, datetime.timezone.utc)
    hours = date.hour + date.minute / 60.0
    g = 2.0 * math.pi * (date.timetuple().tm_yday - 1 + (hours - 12.0) / 24.0) / 365.0
    declination = (0.006918 - 0.399912 * math.cos(g) + 0.070257 * math.sin(g) - 0.006758 * math.cos(2 * g) + 0.000907 * math.sin(2 * g)
                   - 0.002697 * math.cos(3 * g) + 0.00148 * math.sin(3 * g))
    minutes = 229.18 * (0.000075 + 0.001868 * math.cos(g) - 0.032077 * math.sin(g) - 0.014615 * math.cos(2 * g) - 0.040849 * math.sin(2 * g))
    angle = math.radians((hours + minutes / 60.0 - 12.0) * 15.0 + LON)
    lat = math.radians(LAT)
    return math.sin(lat) * math.sin(declination) + math.cos(lat) * math.cos(declination) * math.cos(angle)


def clear_radiation(sine):
    return 1098.0 * sine * math.exp(-0.057 / sine) if sine > 0.01 else 0.0


def between(knots, x):
    """Linear through (x, y) knots, held beyond."""
    if x <= knots[0][0]:
        return knots[0][1]
    for (x0, y0), (x1, y1) in zip(knots, knots[1:]):
        if x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return knots[-1][1]


def smooth(low, high, x):
    u = min(max((x - low) / (high - low), 0.0), 1.0)
    return u * u * (3.0 - 2.0 * u)


def window(rows, i, seconds):
    return [row for row in rows if abs(row["time"] - rows[i]["time"]) <= seconds]


def cover_by_day(near):
    clear = [clear_radiation(sun_height(row["time"] - STEP / 2)) for row in near]
    share = min(1.0, sum(row["global"] for row in near) / max(sum(clear), 1.0))
    by_radiation = ((1.0 - share) / 0.75) ** (1 / 3.4)
    by_sunshine = between(SUNSHINE, sum(row["sun"] for row in near) / (10.0 * len(near))) / 8.0
    return 0.5 * (min(by_radiation, 1.0) + by_sunshine)


def cover_by_night(near):
    found = []
    for row in near:
        kelvin = row["temperature"] + 273.15
        vapour = 6.112 * math.exp(17.62 * row["dew"] / (243.12 + row["dew"]))
        clear = 1.24 * (vapour / kelvin) ** (1 / 7)
        found.append((row["longwave"] / (5.670374e-8 * kelvin ** 4) - clear) / (1.0 - clear))
    return sum(found) / len(found)


def moved(rows, looks, estimate, usable):
    """The estimate, moved so that it meets every look at which it is usable; linear in time between those."""
    own = [estimate(window(rows, i, 2400.0)) for i in range(len(rows))]
    at = {row["time"]: value for row, value in zip(rows, own)}
    offsets = [(look["time"], look["cover"] - at[look["time"]]) for look in looks if usable(look["time"])]
    return [value + between(offsets, row["time"]) for row, value in zip(rows, own)]


def height_deg(time):
    return math.degrees(math.asin(sun_height(time - STEP / 2)))


def covers(rows, looks):
    """By day and by night, each held to the looks, blended while the sun is 7 to 15 degrees high."""
    by_day = moved(rows, looks, cover_by_day, lambda time: height_deg(time) > 10.0)
    by_night = moved(rows, looks, cover_by_night, lambda time: True)
    day = [smooth(7.0, 15.0, height_deg(row["time"])) for row in rows]
    return [min(max(share * d + (1 - share) * n, 0.0), 1.0) for share, d, n in zip(day, by_day, by_night)]


def spells(rows):
    """Rain with pauses up to half an hour: (first, last, largest rate in mm/h)."""
    found = []
    for row in rows:
        if not row["rain"]:
            continue
        if found and row["time"] - found[-1][1] <= 2400.0:
            found[-1] = (found[-1][0], row["time"], max(found[-1][2], 6.0 * row["rain"]))
        else:
            found.append((row["time"], row["time"], 6.0 * row["rain"]))
    return found


def lasting(time, first, last, lead, tail, ramp=1800.0):
    return smooth(first - lead - ramp, first - lead, time) * (1.0 - smooth(last + tail, last + tail + ramp, time))


def genus_shares(rows, looks):
    """For each row what share of the cloud belongs to which genus; the shares sum to 1."""
    seen_storms = [look["time"] for look in looks if look["genus"] == "Cb"]
    plain = [look for look in looks if look["genus"] and look["genus"] != "Cb"]
    all_shares = []
    for row in rows:
        time, shares = row["time"], {}
        storm = steady = 0.0
        for first, last, most in spells(rows):
            if most >= 10.0 or any(first - 3600.0 <= t <= last + 3600.0 for t in seen_storms):
                storm = max(storm, lasting(time, first, min(last, first + 3600.0), 1200.0, 1800.0))
            elif last - first >= 3600.0:
                steady = max(steady, lasting(time, first, last, 1200.0, 1200.0))
        steady *= 1.0 - storm
        rest = 1.0 - storm - steady
        before = [look for look in plain if look["time"] <= time] or plain[:1]
        after = [look for look in plain if look["time"] > time] or plain[-1:]
        gone = 0.0 if before[-1] is after[0] else smooth(before[-1]["time"] * 0.65 + after[0]["time"] * 0.35,
                                                         before[-1]["time"] * 0.35 + after[0]["time"] * 0.65, time)
        for genus, share in (("Cb", storm), ("Ns", steady), (before[-1]["genus"], rest * (1 - gone)), (after[0]["genus"], rest * gone)):
            shares[genus] = shares.get(genus, 0.0) + share
        all_shares.append({genus: share for genus, share in shares.items() if share > 0.0})
    return all_shares


def shared_cover(cover, share):
    """Covers of layers that overlap by chance and together make `cover`."""
    return cover if share >= 0.999 else 1.0 - (1.0 - min(cover, 0.97)) ** share


def lifting_heights(rows):
    means = []
    for i in range(len(rows)):
        near = window(rows, i, 3600.0)
        means.append(125.0 * sum(max(0.0, row["temperature"] - row["dew"]) for row in near) / len(near))
    kept = [max(means[max(0, i - 18):i + 1]) for i in range(len(rows))]
    return means, kept


def base_of(genus, mean, kept):
    height = {"Cu": max(300.0, kept), "Cb": min(max(300.0, mean), 1500.0), "Sc": min(max(mean, 500.0), 1800.0),
              "Ns": min(max(2 * mean, 400.0), 1500.0), "St": min(max(mean, 100.0), 500.0)}.get(genus)
    return None if height is None else round(ELEVATION + height, -1)


def modelled_visibility(row):
    magnus = [17.62 * t / (243.12 + t) for t in (row["dew"], row["temperature"])]
    humidity = min(1.0, math.exp(magnus[0] - magnus[1]))
    rain = 2.24 * (0.072 * (6 * row["rain"]) ** 0.88) ** 0.75 if row["rain"] else 0.0
    return 1.0 / (1.0 / (60000.0 * math.exp(-2.5 * (100 * humidity - 15) / 80)) + rain / 3000.0)


def visibilities(rows, looks):
    at = {row["time"]: row for row in rows}
    ratios = [(look["time"], math.log(look["visibility"] / modelled_visibility(at[look["time"]]))) for look in looks if look["visibility"]]
    return [round(min(modelled_visibility(row) * math.exp(between(ratios, row["time"])), 80000.0), -2) for row in rows]


def drop_contradictions(rows, looks):
    """A visibility of a mist with neither mist, fog nor rain in the present weather and dry air is a slip of the pen."""
    at = {row["time"]: row for row in rows}
    for look in looks:
        row = at[look["time"]]
        if look["visibility"] and look["visibility"] < 5000 and look["weather"] is not None and look["weather"] < 10 \
                and row["temperature"] - row["dew"] > 1.5 and not row["rain"]:
            look["visibility"] = None


def report_of(row, look, cover, shares, heights, visibility, thunder_seen):
    filled = {}
    report = {"time": iso(row["time"]), "interval_s": 600,
              "wind": {"speed_mps": row["speed"], "gust_mps": row["gust"], "from_deg": row["from"] if row["speed"] else None},
              "visibility_m": look["visibility"] if look else None,
              "temperature_c": row["temperature"], "dew_point_c": row["dew"], "pressure_hpa": row["pressure"],
              "precipitation": {"kind": "unknown" if row["rain"] else "none", "rate_mm_h": round(6 * row["rain"], 1)},
              "thunder": None}
    if report["visibility_m"] is None:
        filled["visibility_m"] = visibility
    if look and look["weather"] is not None:
        report["thunder"] = look["weather"] >= 95 or look["weather"] in (17, 29)
    elif "Cb" in shares and row["rain"] and any(abs(row["time"] - t) <= 3000 for t in thunder_seen):
        filled["thunder"] = True
    if look and look["genus"]:
        report["cover_total"] = look["cover"]
        shares = {look["genus"]: 1.0}
    layers = []
    for genus, share in sorted(shares.items()):
        own = round(shared_cover(cover, share), 3)
        base = base_of(genus, *heights)
        place = "layers[%d]." % len(layers)
        if own < 0.005 and not (look and look["genus"]):
            continue
        layers.append({"genus": genus if look and look["genus"] else None, "cover": look["cover"] if look and look["genus"] else None,
                       "base_m": None, "top_m": None})
        if not (look and look["genus"]):
            filled[place + "genus"] = genus
            filled[place + "cover"] = own
        if base is not None:
            filled[place + "base_m"] = base
    report["layers"] = layers if layers or look else None
    report["filled"] = filled
    return report


def main():
    parser = argparse.ArgumentParser(description="A recording of Basel / Binningen from MeteoSwiss's open data")
    parser.add_argument("ten_minutes")
    parser.add_argument("observer")
    parser.add_argument("-o", required=True, dest="out")
    options = parser.parse_args()
    rows = read_ten_minutes(options.ten_minutes)
    looks = read_observer(options.observer, rows[0]["time"], rows[-1]["time"])
    drop_contradictions(rows, looks)
    means, kept = lifting_heights(rows)
    at = {look["time"]: look for look in looks}
    thunder = [look["time"] for look in looks if look["weather"] and look["weather"] >= 95]
    reports = [report_of(row, at.get(row["time"]), cover, shares, (mean, keep), visibility, thunder)
               for row, cover, shares, mean, keep, visibility in zip(rows, covers(rows, looks), genus_shares(rows, looks), means, kept,
                                                                     visibilities(rows, looks))]
    first, last = (datetime.datetime.fromtimestamp(rows[i]["time"], datetime.timezone.utc) for i in (0, -1))
    name = "Basel, %d-%d %s" % (first.day, last.day, first.strftime("%B %Y"))
    head = {"format": "luftpost-weather-1", "name": name, "source": "MeteoSwiss (open data)",
            "licence": "Open data of MeteoSwiss, free use with the source named: Source: MeteoSwiss"}
    site = {"name": "Basel / Binningen", "lat": LAT, "lon": LON, "elevation_m": ELEVATION}
    with open(options.out, "w", encoding="utf-8") as file:
        file.write(json.dumps(head, ensure_ascii=False)[:-1] + ', "sites": [\n' + json.dumps(site, ensure_ascii=False)[:-1] + ', "reports": [\n')
        file.write(",\n".join(json.dumps(report, separators=(",", ":")) for report in reports) + "\n]}]}\n")


if __name__ == "__main__":
    main()
