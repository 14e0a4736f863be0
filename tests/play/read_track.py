"""What a reader of KML or GPX finds in the file, as JSON: for each part of the way its points as [lat, lon, altitude, time], and the marks."""
import json
import sys
import xml.etree.ElementTree as xml

KML, GX, GPX = "{http://www.opengis.net/kml/2.2}", "{http://www.google.com/kml/ext/2.2}", "{http://www.topografix.com/GPX/1/1}"


def kml(root):
    parts = []
    for track in root.iter(GX + "Track"):
        assert track.find(KML + "altitudeMode").text == "absolute"
        times = [when.text for when in track.findall(KML + "when")]
        places = [[float(v) for v in coord.text.split()] for coord in track.findall(GX + "coord")]
        assert len(times) == len(places)
        parts.append([[lat, lon, alt, time] for (lon, lat, alt), time in zip(places, times)])
    marks = []
    for placemark in root.iter(KML + "Placemark"):
        point = placemark.find(KML + "Point")
        if point is not None:
            lon, lat, alt = (float(v) for v in point.find(KML + "coordinates").text.split(","))
            marks.append([placemark.find(KML + "name").text, lat, lon, alt, placemark.find(f"{KML}TimeStamp/{KML}when").text])
    return parts, marks


def gpx(root):
    assert root.get("version") == "1.1"
    def place(node):
        return [float(node.get("lat")), float(node.get("lon")), float(node.find(GPX + "ele").text), node.find(GPX + "time").text]
    parts = [[place(point) for point in segment.findall(GPX + "trkpt")] for segment in root.iter(GPX + "trkseg")]
    return parts, [[mark.find(GPX + "name").text] + place(mark) for mark in root.findall(GPX + "wpt")]


root = xml.parse(sys.argv[1]).getroot()
parts, marks = {KML + "kml": kml, GPX + "gpx": gpx}[root.tag](root)
json.dump({"parts": parts, "marks": marks}, sys.stdout)
