#!/usr/bin/env python3
"""Writes a recording from a United States station's METARs in the tab-separated files of IEM's ASOS archive (public domain).

usage: weather_kcvg.py HOURLY.tsv SPECIALS.tsv -o OUT.json

Reads what these reports use: wind, visibility in statute miles, present weather, sky cover, and of the remarks the tenths of
temperature and dew point (T), the pressure at sea level (SLP) and the rain since the last hourly report (P), of which
each report here has what fell since the one before. Amounts of cloud
include the layers below (FMH-1), so each layer's own share is (S - below) / (1 - below). What is concluded stands in `filled`: the
genus, by height, amount and rain, and a trace of rain as 0.1 mm/h.
"""
import argparse
import json
import re

ELEVATION = 273.0  # m: 896 ft, Cincinnati / Northern Kentucky International
SITE = {"name": "Cincinnati / Northern Kentucky (KCVG)", "lat": 39.049, "lon": -84.668, "elevation_m": ELEVATION}
EIGHTHS = {"FEW": 1.5, "SCT": 3.5, "BKN": 6.0, "OVC": 8.0}
FOOT, KNOT, MILE, INCH = 0.3048, 1852 / 3600, 1609.344, 25.4
CLEAR_TO = ELEVATION + 12000 * FOOT  # CLR of an automatic station


def rows(name):
    with open(name, encoding="utf-8") as file:
        for line in file:
            parts = line.rstrip("\n").split("\t")
            if len(parts) == 3 and parts[0] == "CVG":
                yield parts[1].replace(" ", "T") + "Z", parts[2]


def signed(text):
    return (-1 if text[0] == "1" else 1) * int(text[1:]) / 10


def genus_of(base_ft, cover, wet):
    if base_ft >= 20000:
        return "Cs" if cover > 0.9 else "Ci"
    if base_ft >= 6500:
        return "As" if cover > 0.9 else "Ac"
    if base_ft < 2000:
        return "St"
    return "Ns" if wet and cover > 0.9 else "Sc"


def sky(body, wet, filled):
    if " CLR" in body:
        return [], CLEAR_TO
    layers, below = [], 0.0
    for amount, hundreds in re.findall(r" (FEW|SCT|BKN|OVC)(\d{3})", body):
        total = EIGHTHS[amount] / 8
        own = (total - below) / (1 - below)
        filled["layers[%d].genus" % len(layers)] = genus_of(100 * int(hundreds), total, wet)
        layers.append({"genus": None, "cover": round(own, 3), "base_m": round(ELEVATION + 100 * int(hundreds) * FOOT, 1), "top_m": None})
        below = total
    return layers, None


def amount_of(remarks):
    """Inches since the last hourly report; a trace is 0, no group is none."""
    found = re.search(r" P(\d{4})", remarks)
    return int(found.group(1)) / 100 if found else None


def fallen(body, amount, before, since, filled):
    falling = re.search(r" [-+]?(DZ|RA|PL|SN|PLRA|RASN)( |$)", body)
    if amount is None and not falling:
        return {"kind": "none", "rate_mm_h": 0.0}
    kind = {"DZ": "drizzle", "SN": "snow", "PLRA": "sleet", "PL": "sleet", "RASN": "sleet"}.get(falling and falling.group(1), "rain")
    inches = max((amount or 0.0) - before, 0.0)
    if inches > 0:
        return {"kind": kind, "rate_mm_h": round(inches * INCH * 3600 / since, 2)}
    filled["precipitation.rate_mm_h"] = 0.1 if falling else 0.0
    return {"kind": kind, "rate_mm_h": None}


def report_of(time, text, since, before):
    body, _, remarks = text.partition(" RMK")
    wind = re.search(r" (\d{3})(\d{2,3})(?:G(\d{2,3}))?KT", body)
    miles = float(re.search(r" (\d+)SM", body).group(1))
    tenths = re.search(r" T([01]\d{3})([01]\d{3})", remarks)
    pressure = re.search(r" SLP(\d{3})", remarks)
    filled = {}
    rain = fallen(body, amount_of(remarks), before, since, filled)
    layers, to = sky(body, rain["kind"] != "none", filled)
    report = {"time": time, "interval_s": since,
              "wind": {"speed_mps": round(int(wind.group(2)) * KNOT, 2), "gust_mps": round(int(wind.group(3)) * KNOT, 2) if wind.group(3) else None,
                       "from_deg": float(wind.group(1))},
              "visibility_m": round(miles * MILE), "visibility_is_minimum": miles >= 10, "temperature_c": signed(tenths.group(1)),
              "dew_point_c": signed(tenths.group(2)), "pressure_hpa": 1000 + int(pressure.group(1)) / 10 if pressure else None,
              "precipitation": rain, "thunder": False, "layers": layers, "layers_to_m": to}
    if filled:
        report["filled"] = filled
    return report


def seconds(time):
    return int(time[11:13]) * 3600 + int(time[14:16]) * 60


def main():
    parser = argparse.ArgumentParser(description="A recording from METARs of KCVG")
    parser.add_argument("hourly")
    parser.add_argument("specials")
    parser.add_argument("-o", required=True, dest="out")
    options = parser.parse_args()
    special = list(rows(options.specials))
    reports, before, fallen_inches = [], None, 0.0
    for time, text in sorted(list(rows(options.hourly)) + special):
        since = 3600 if before is None else seconds(time) - before
        reports.append(report_of(time, text, since, fallen_inches))
        before = seconds(time)
        fallen_inches = (amount_of(text) or 0.0) if (time, text) in special else 0.0  # the count starts anew with the hourly report
    head = {"format": "luftpost-weather-1", "name": "Cincinnati, 1 March 2024", "source": "NWS METAR, archived by IEM ASOS (Iowa State University)",
            "licence": "Public domain (United States government work)"}
    with open(options.out, "w", encoding="utf-8") as file:
        file.write(json.dumps(head, ensure_ascii=False)[:-1] + ', "sites": [\n' + json.dumps(SITE, ensure_ascii=False)[:-1] + ', "reports": [\n')
        file.write(",\n".join(json.dumps(report, separators=(",", ":")) for report in reports) + "\n]}]}\n")


if __name__ == "__main__":
    main()
