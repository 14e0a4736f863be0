#!/usr/bin/env python3
"""A second reading of aerodrome reports, built otherwise than the program's: regular expressions over the whole body, one per group.

    luftpost weather FILE --json > out.json; metar_check.py out.json FILE

compares every group of every report with what the program says and prints a table: groups seen, right, and each disagreement.
FILE: a report a line, or the table of the Iowa Environmental Mesonet.
"""
import json
import re
import sys

KNOT = 0.514444444
AMOUNT = {"FEW": 1.5 / 8, "SCT": 3.5 / 8, "BKN": 6 / 8, "OVC": 1.0}
WEATHER = re.compile(r"(?<!\S)([+-]?)(VC)?(MI|PR|BC|DR|BL|SH|TS|FZ)?((?:DZ|RA|SN|SG|IC|PL|GR|GS|UP|BR|FG|FU|VA|DU|SA|HZ|PY|PO|SQ|FC|SS|DS)*)(?!\S)")


def reports(path):
    lines = [line.rstrip("\n") for line in open(path, encoding="utf-8")]
    if any(line.startswith("station\tvalid") for line in lines):
        lines = [line.split("\t")[2] for line in lines if "\t" in line and not line.startswith(("#", "station"))]
    return [line for line in lines if re.match(r"[A-Z]\w{3} \d{5,6}Z", line)]


def split(report):
    body, _, remarks = report.partition(" RMK")
    body = re.split(r"\s(?:BECMG|TEMPO|INTER)\b", body)[0]
    return body + " ", remarks + " "


def wind(body):
    found = re.search(r"\s(VRB|///|\d{3})(//|P?\d{2,3})(?:G(//|P?\d{2,3}))?(KT|MPS|KMH)\s", body)
    if not found:
        return None
    factor = {"KT": KNOT, "MPS": 1.0, "KMH": 1 / 3.6}[found[4]]
    number = lambda text: None if not text or "/" in text else int(text.strip("P")) * factor
    speed, gust = number(found[2]), number(found[3])
    direction = int(found[1]) if found[1].isdigit() and speed != 0 else None
    return {"speed_mps": speed, "gust_mps": gust, "from_deg": direction}


def visibility(body):
    if re.search(r"\sCAVOK\s", body):
        return {"m": 10000.0, "minimum": True}
    miles = re.search(r"\s(?:(\d) )?([PM]?)(\d+)(?:/(\d+))?SM\s", body)
    if miles:
        value = int(miles[3]) / int(miles[4] or 1) + int(miles[1] or 0)
        return {"m": value * 1609.344, "minimum": miles[2] == "P" or miles[3] == "10" and not miles[4]}
    km = re.search(r"\s(\d+)KM\s", body)
    if km:
        return {"m": int(km[1]) * 1000.0, "minimum": False}
    metres = re.search(r"\s(\d{4})(?:NDV|[NESW]{1,2})?\s", body)
    if metres:
        return {"m": 10000.0 if metres[1] == "9999" else float(metres[1]), "minimum": metres[1] == "9999"}
    return {"m": None, "minimum": False} if re.search(r"\s////\s", body) else None


def kind_of(word):
    descriptor, seen = word[2] or "", re.findall("..", word[3])
    if word[1] or descriptor in ("DR", "BL"):
        return None
    liquid = "RA" in seen or "DZ" in seen
    if "GR" in seen or "GS" in seen:
        return "hail"
    if descriptor == "FZ" and liquid:
        return "freezing_rain"
    if "PL" in seen or liquid and "SN" in seen:
        return "sleet"
    names = {"DZ": "drizzle", "RA": "rain", "SN": "snow", "SG": "snow", "IC": "snow", "UP": "unknown"}
    return next((names[s] for s in seen if s in names), None)


def weather(body):
    """Kind and thunder where a group of present weather stands; None where there is none."""
    words = [m.groups() for m in WEATHER.finditer(body) if m[0] and (m[4] or m[3] in ("TS", "SH"))]
    if not words:
        return None
    return {"kind": next((k for k in map(kind_of, words) if k), None), "thunder": any(w[2] == "TS" for w in words)}


def clouds(body, american):
    layers, below = [], 0.0
    for found in re.finditer(r"\s(FEW|SCT|BKN|OVC|///)(\d{3}|///)(CB|TCU|///)?(?=\s)", body):
        if found[1] == found[2] == "///" and found[3] in (None, "///"):
            continue
        amount = AMOUNT.get(found[1])
        if american and amount is not None:
            own = (amount - below) / (1 - below) if below < 1 else None
            amount, below = own, max(below, amount)
        height = None if found[2] == "///" else int(found[2]) * 30.48
        layers.append((amount, height, {"CB": "Cb", "TCU": "Cu"}.get(found[3])))
    if layers:
        return layers
    return [] if re.search(r"\s(SKC|CLR|NSC|NCD|CAVOK)\s", body) else None


def temperature(body, remarks):
    found = re.search(r"\s(M?\d\d|//)/(M?\d\d|//)?\s", body)
    if not found:
        return None
    values = [None if not g or "/" in g else -float(g[1:]) if g[0] == "M" else float(g) for g in found.groups()]
    tenths = re.search(r"\sT([01])(\d{3})(?:([01])(\d{3}))?\s", remarks)
    if tenths:
        precise = [int(tenths[2]) / 10 * (-1 if tenths[1] == "1" else 1)]
        precise.append(int(tenths[4]) / 10 * (-1 if tenths[3] == "1" else 1) if tenths[4] else None)
        values = [p if p is not None else v for p, v in zip(precise, values)]
    return values


def pressure(body, remarks):
    q, a, slp = re.search(r"\sQ(\d{4})\s", body), re.search(r"\sA(\d{4})\s", body), re.search(r"\sSLP(\d{3})\s", remarks)
    value = float(q[1]) if q else int(a[1]) * 0.3386389 if a else None
    if value is None:
        a = re.search(r"\sA(\d{4})\s", remarks)
        value = int(a[1]) * 0.3386389 if a else None
    if slp:
        tens = int(slp[1]) / 10
        value = min((900 + tens, 1000 + tens), key=lambda p: abs(p - (value or 1000)))
    if value is None and not re.search(r"\s[QA]////\s", body):
        return "absent"
    return value


def near(a, b, tolerance):
    return (a is None) == (b is None) and (a is None or abs(a - b) <= tolerance)


def layers_agree(ours, theirs, elevation):
    if ours is None or theirs is None:
        return ours is None and theirs is None
    return len(ours) == len(theirs) and all(
        near(o["cover"], t[0], 1e-5) and near(None if o["base_m"] is None else o["base_m"] - elevation, t[1], 0.02) and o["genus"] == t[2]
        for o, t in zip(ours, theirs))


def compare(text, site, note):
    body, remarks = split(text)
    expected = wind(body)
    if expected:
        note("wind", all(near(site["wind"][k], expected[k], 1e-4) for k in expected), text, site["wind"], expected)
    elif site["wind"]["speed_mps"] is not None:
        note("wind", False, text, site["wind"], None)
    expected = visibility(body)
    if expected:
        ours = {"m": site["visibility_m"], "minimum": site["visibility_is_minimum"]}
        note("visibility", near(ours["m"], expected["m"], 0.01) and ours["minimum"] == expected["minimum"], text, ours, expected)
    elif site["visibility_m"] is not None:
        note("visibility", False, text, site["visibility_m"], None)
    expected = weather(body)
    if expected:
        kind = site["precipitation"]["kind"]
        right = kind == expected["kind"] or expected["kind"] is None and kind in ("none", None)
        note("weather", right and bool(site["thunder"]) == expected["thunder"], text, (kind, site["thunder"]), expected)
    elif site["precipitation"]["kind"] not in ("none", None) or site["thunder"]:
        note("weather", False, text, site["precipitation"], None)
    expected = clouds(body, text[0] in "KP")
    if expected is not None or site["layers"] is not None:
        elevation = site["elevation_m"] or site["filled"].get("elevation_m", 0.0)
        note("cloud", layers_agree(site["layers"], expected, elevation), text, site["layers"], expected)
    vertical = re.search(r"\sVV(\d{3}|///)\s", body)
    if vertical:
        height = None if vertical[1] == "///" else int(vertical[1]) * 30.48
        note("vertical visibility", near(site["vertical_visibility_m"], height, 0.01), text, site["vertical_visibility_m"], height)
    expected = temperature(body, remarks)
    if expected:
        ours = [site["temperature_c"], site["dew_point_c"]]
        note("temperature", all(near(o, e, 1e-6) for o, e in zip(ours, expected)), text, ours, expected)
    elif site["temperature_c"] is not None:
        note("temperature", False, text, site["temperature_c"], None)
    expected = pressure(body, remarks)
    if expected != "absent":
        note("pressure", near(site["pressure_hpa"], expected, 0.01), text, site["pressure_hpa"], expected)


def main():
    sites = json.load(open(sys.argv[1], encoding="utf-8"))
    sites = sites["sites"] if isinstance(sites, dict) else sites
    texts = reports(sys.argv[2])
    if [t[:4] for t in texts] != [s["name"] for s in sites]:
        sys.exit(f"{len(texts)} reports in the file, {len(sites)} entries, or another order")
    seen, right = {}, {}

    def note(group, agrees, text, ours, expected):
        seen[group] = seen.get(group, 0) + 1
        right[group] = right.get(group, 0) + agrees
        if not agrees:
            print(f"{group}: {text}\n    program {ours}\n    here    {expected}")

    for text, site in zip(texts, sites):
        compare(text, site, note)
    for group in seen:
        print(f"{group:20} {seen[group]:5} seen, {right[group]:5} agree")


if __name__ == "__main__":
    main()
