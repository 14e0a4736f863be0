"""A server of weather that behaves as badly as its path says: http://127.0.0.1:PORT/MODE. For the tests alone; localhost only.

weather_server.py FOLDER [--tls]: writes FOLDER/port when it listens, and a line for each request to FOLDER/requests.
With --tls it takes FOLDER/certificate.pem (certificate and key)."""
import gzip
import http.server
import json
import math
import os
import re
import ssl
import sys
import threading
import time

FOLDER = sys.argv[1]
calls = {}


def forecast(number, now):
    """A body of Open-Meteo: 6 h before now to 24 h after. Each number is another weather."""
    start = int(now // 3600) * 3600 - 6 * 3600
    times = [start + 3600 * i for i in range(31)]
    wave = [math.sin(0.4 * i + number) for i in range(31)]
    hourly = {
        "time": times,
        "temperature_2m": [12 + 4 * w for w in wave],
        "dew_point_2m": [7 + 2 * w for w in wave],
        "relative_humidity_2m": [70 + 5 * w for w in wave],
        "pressure_msl": [1012 + 3 * w for w in wave],
        "wind_speed_10m": [6 + 2 * w + number % 3 for w in wave],
        "wind_direction_10m": [(240 + 30 * w + 20 * number) % 360 for w in wave],
        "wind_gusts_10m": [10 + 3 * w + number % 3 for w in wave],
        "precipitation": [max(0.0, w) for w in wave],
        "cloud_cover_low": [40 + 30 * w for w in wave],
        "cloud_cover_mid": [30 + 20 * w for w in wave],
        "cloud_cover_high": [20 + 20 * w for w in wave],
        "visibility": [20000 + 4000 * w for w in wave],
        "weather_code": [2] * 31,
        "cape": [100] * 31,
        "freezing_level_height": [2500] * 31,
    }
    units = {"time": "unixtime", "temperature_2m": "°C", "dew_point_2m": "°C", "relative_humidity_2m": "%", "pressure_msl": "hPa",
             "wind_speed_10m": "m/s", "wind_direction_10m": "°", "wind_gusts_10m": "m/s", "precipitation": "mm", "cloud_cover_low": "%",
             "cloud_cover_mid": "%", "cloud_cover_high": "%", "visibility": "m", "weather_code": "wmo code", "cape": "J/kg",
             "freezing_level_height": "m"}
    return json.dumps({"latitude": 47.5, "longitude": 7.6, "generationtime_ms": 0.1, "utc_offset_seconds": 0, "timezone": "GMT",
                       "timezone_abbreviation": "GMT", "elevation": 316.0, "hourly_units": units, "hourly": hourly}).encode()


def stations(now):
    """Two airports near Basel and one in Finland, as aviationweather.gov's JSON has them, of half an hour ago."""
    then = int(now // 60) * 60 - 1800
    group = time.strftime("%d%H%MZ", time.gmtime(then))
    return json.dumps([{"icaoId": name, "obsTime": then, "rawOb": f"METAR {name} {group} {rest}", "lat": 47.6, "lon": 7.5, "elev": 270} for name, rest in (
        ("EFHK", "02015KT 9999 OVC010 02/M01 Q0998"), ("LFSB", "24008KT 9999 FEW030 SCT045 12/08 Q1015 NOSIG"),
        ("LSZH", "26012G25KT 9999 BKN040 11/07 Q1014"))]).encode()


def hours(now):
    """meteoblue's basic-1h and clouds-1h: 6 h before now to 24 h after, in UTC."""
    start = int(now // 3600) * 3600 - 6 * 3600
    names = [time.strftime("%Y-%m-%d %H:%M", time.gmtime(start + 3600 * i)) for i in range(31)]
    values = {"temperature": 12.5, "windspeed": 5.5, "winddirection": 250, "relativehumidity": 70, "sealevelpressure": 1016.0, "precipitation": 0.0,
              "lowclouds": 40, "midclouds": 20, "highclouds": 60, "totalcloudcover": 40, "visibility": 20000}
    units = {"time": "YYYY-MM-DD hh:mm", "temperature": "C", "windspeed": "ms-1", "winddirection": "degree", "relativehumidity": "percent",
             "pressure": "hPa", "precipitation": "mm", "cloudcover": "percent", "visibility": "m"}
    metadata = {"name": "", "latitude": 47.54, "longitude": 7.58, "height": 316, "timezone_abbrevation": "UTC", "utc_timeoffset": 0.0,
                "modelrun_utc": names[0], "modelrun_updatetime_utc": names[0], "generation_time_ms": 1.0}
    return json.dumps({"metadata": metadata, "units": units, "data_1h": {"time": names} | {k: [v] * 31 for k, v in values.items()}}).encode()


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def answer(self, body, status=200, headers=(), length=None):
        self.send_response(status)
        for name, value in headers:
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(body) if length is None else length))
        self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(body)
        self.close_connection = True

    def do_GET(self):
        mode = self.path.split("?")[0].strip("/")
        calls[mode] = number = calls.get(mode, 0) + 1
        with open(os.path.join(FOLDER, "requests"), "a") as file:
            file.write(f"{self.path} {self.headers.get('If-None-Match', '-')}\n")
        try:
            getattr(self, "mode_" + mode)(number)
        except (BrokenPipeError, ConnectionResetError, ssl.SSLError):
            pass

    def good(self, number=0):
        return forecast(number, time.time())

    def mode_ok(self, number):
        self.answer(self.good())

    def mode_stations(self, number):
        self.answer(stations(time.time()))

    def mode_hours(self, number):
        self.answer(hours(time.time()))

    def mode_changing(self, number):
        self.answer(self.good(number))

    def mode_etag(self, number):
        if self.headers.get("If-None-Match") == '"one"':
            self.answer(b"", 304)
        else:
            self.answer(self.good(), headers=[("ETag", '"one"')])

    def mode_gzip(self, number):
        self.answer(gzip.compress(self.good()), headers=[("Content-Encoding", "gzip")])

    def mode_once(self, number):
        if number == 1:
            self.answer(self.good())
        else:
            self.mode_500(number)

    def mode_redirect(self, number):
        self.answer(b"", 302, [("Location", "/ok")])

    def mode_loop(self, number):
        self.answer(b"", 302, [("Location", "/loop")])

    def mode_away(self, number):
        self.answer(b"", 302, [("Location", "file:///etc/hostname")])

    def mode_slow(self, number):
        body = self.good()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        for byte in body:
            self.wfile.write(bytes([byte]))
            self.wfile.flush()
            time.sleep(0.05)

    def mode_silent(self, number):
        time.sleep(20)

    def mode_cut(self, number):
        body = self.good()
        self.answer(body[:len(body) // 2], length=len(body))

    def mode_400(self, number):
        self.answer(b'{"error":true,"reason":"Parameter latitude is out of range"}', 400)

    def mode_401(self, number):
        self.answer(json.dumps({"error_message": "The key is not valid: " + self.path}).encode(), 401)

    def mode_429(self, number):
        self.answer(b'{"error":true,"reason":"Minutely API request limit exceeded. Please try again in one minute."}', 429, [("Retry-After", "3600")])

    def mode_500(self, number):
        self.answer(b"Internal Server Error", 500)

    def mode_503(self, number):
        self.answer(b"", 503, [("Retry-After", "2")])

    def mode_html(self, number):
        self.answer(b"<!DOCTYPE html><html><body>Sign in to the hotel's network</body></html>", headers=[("Content-Type", "text/html")])

    def mode_empty(self, number):
        self.answer(b"")

    def mode_wrong(self, number):
        self.answer(b'{"latitude":47.5,"longitude":7.6,"hourly_units":{"time":"unixtime"},"hourly":{"time":[1,2,3],"temperature_2m":["warm",{},[]]}}')

    def mode_nan(self, number):
        self.answer(re.sub(rb'("temperature_2m": \[)[^,]+', rb"\1NaN", self.good(), count=1))

    def mode_huge(self, number):
        self.send_response(200)
        self.send_header("Connection", "close")
        self.end_headers()
        piece = b" " * (1 << 20)
        for _ in range(1024):
            self.wfile.write(piece)
        self.close_connection = True

    def mode_announced(self, number):
        self.answer(b"{", length=1 << 30)

    def mode_bomb(self, number):
        self.answer(gzip.compress(b" " * (32 << 20), 1), headers=[("Content-Encoding", "gzip")])


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
server.daemon_threads = True
if "--tls" in sys.argv:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(os.path.join(FOLDER, "certificate.pem"))
    server.socket = context.wrap_socket(server.socket, server_side=True)
with open(os.path.join(FOLDER, "port.new"), "w") as port:
    port.write(str(server.server_address[1]))
os.rename(os.path.join(FOLDER, "port.new"), os.path.join(FOLDER, "port"))
threading.Timer(120, lambda: os._exit(0)).start()  # whoever forgets it is forgiven
server.serve_forever()
