#!/usr/bin/env python3
"""Writes a recording from hourly model data in the JSON of Open-Meteo's API (one place).

usage: weather_open_meteo.py INPUT.json --name "Melbourne, 16 January 2024" --site Melbourne -o OUT.json

Instants: temperature, dew point, pressure, cover by level, wind at 10 m and aloft, visibility, CAPE, freezing level, code. Of the hour
before: the precipitation's sum and the gust's maximum. Cover comes by level, not by layer, so `layers` stays null and the game
fills in genera and heights. A visibility at the model's upper end is a minimum.
"""
import argparse
import datetime
import json

MOST_VISIBLE = 24140.0  # m: the model's largest figure, 15 statute miles
SPEEDS = {"km/h": 1 / 3.6, "m/s": 1.0, "kn": 1852 / 3600, "mph": 0.44704}


def iso(time):
    return datetime.datetime.fromtimestamp(time, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%MZ")


class Hours:
    """The hourly arrays; a variable that is missing is null at every hour."""

    def __init__(self, data):
        self.values, self.units = data["hourly"], data["hourly_units"]
        assert self.units["time"] == "unixtime" and self.units["temperature_2m"] == "°C", "asks for timeformat=unixtime and degrees Celsius"

    def at(self, name, hour, factor=1.0, digits=2):
        column = self.values.get(name)
        value = column[hour] if column else None
        return None if value is None else round(value * factor, digits)

    def speed(self, name, hour):
        return self.at(name, hour, SPEEDS[self.units[name]]) if name in self.units else None


def levels(hours, i, elevation):
    found = []
    for height in (80, 120, 180):
        speed, direction = hours.speed("wind_speed_%dm" % height, i), hours.at("wind_direction_%dm" % height, i)
        if speed is not None and direction is not None:
            found.append({"altitude_m": elevation + height, "temperature_c": hours.at("temperature_%dm" % height, i), "speed_mps": speed,
                          "from_deg": direction})
    return found


def kind_of(hours, i):
    rain = (hours.at("rain", i) or 0) + (hours.at("showers", i) or 0)
    snow = hours.at("snowfall", i) or 0
    if rain > 0 and snow > 0:
        return "sleet"
    return "rain" if rain > 0 else "snow" if snow > 0 else "none"


def report_of(hours, i, elevation):
    visibility, code = hours.at("visibility", i), hours.at("weather_code", i)
    report = {"time": iso(hours.values["time"][i]), "interval_s": 3600,
              "wind": {"speed_mps": hours.speed("wind_speed_10m", i), "gust_mps": hours.speed("wind_gusts_10m", i),
                       "from_deg": hours.at("wind_direction_10m", i)},
              "visibility_m": visibility, "visibility_is_minimum": visibility is not None and visibility >= MOST_VISIBLE,
              "temperature_c": hours.at("temperature_2m", i), "dew_point_c": hours.at("dew_point_2m", i),
              "pressure_hpa": hours.at("pressure_msl", i),
              "precipitation": {"kind": kind_of(hours, i), "rate_mm_h": hours.at("precipitation", i)},
              "thunder": None if code is None else code >= 95, "layers": None,
              "cover_low": hours.at("cloud_cover_low", i, 0.01),
              "cover_mid": hours.at("cloud_cover_mid", i, 0.01), "cover_high": hours.at("cloud_cover_high", i, 0.01),
              "cover_total": hours.at("cloud_cover", i, 0.01), "cover_bounds_m": [3000, 8000], "cape_j_kg": hours.at("cape", i),
              "freezing_level_m": hours.at("freezing_level_height", i), "snow_depth_m": hours.at("snow_depth", i),
              "weather_code": None if code is None else int(code), "levels": levels(hours, i, elevation)}
    return report


def main():
    parser = argparse.ArgumentParser(description="A recording from Open-Meteo's hourly model data")
    parser.add_argument("input")
    parser.add_argument("--name", required=True)
    parser.add_argument("--site", required=True)
    parser.add_argument("-o", required=True, dest="out")
    options = parser.parse_args()
    with open(options.input, encoding="utf-8") as file:
        data = json.load(file)
    hours = Hours(data)
    head = {"format": "luftpost-weather-1", "name": options.name, "source": "Open-Meteo (model data)",
            "licence": "CC BY 4.0, Weather data by Open-Meteo.com"}
    site = {"name": options.site, "lat": data["latitude"], "lon": data["longitude"], "elevation_m": data["elevation"]}
    reports = [report_of(hours, i, data["elevation"]) for i in range(len(hours.values["time"]))]
    with open(options.out, "w", encoding="utf-8") as file:
        file.write(json.dumps(head, ensure_ascii=False)[:-1] + ', "sites": [\n' + json.dumps(site, ensure_ascii=False)[:-1] + ', "reports": [\n')
        file.write(",\n".join(json.dumps(report, separators=(",", ":")) for report in reports) + "\n]}]}\n")


if __name__ == "__main__":
    main()
