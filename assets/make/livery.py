"""Paint of the aircraft: textures drawn from shapes, in metres of the aircraft. Used by models.py."""
import math
from collections import namedtuple

from gltf_writer import png

INK = (38, 36, 40)
# Colours of the body, of what lies over the band, of the band and tips, and of the ribs that show through each; what is written
# on side and wings.
Livery = namedtuple("Livery", "body upper band rib band_rib number")
MAIL = Livery((250, 186, 22), (247, 240, 222), (188, 36, 28), (238, 172, 16), (172, 30, 24), "LP-24")
FREIGHT = Livery((222, 226, 228), (246, 246, 242), (22, 74, 128), (208, 212, 215), (18, 62, 108), "LP-40")

# Letters as strokes on a grid 4 wide and 6 high.
LETTERS = {
    "L": [[(0, 6), (0, 0), (3.6, 0)]],
    "U": [[(0, 6), (0, 1.6), (0.5, 0.5), (1.6, 0), (2.4, 0), (3.5, 0.5), (4, 1.6), (4, 6)]],
    "F": [[(0, 0), (0, 6), (3.8, 6)], [(0, 3.2), (3.1, 3.2)]],
    "T": [[(0, 6), (4, 6)], [(2, 6), (2, 0)]],
    "P": [[(0, 0), (0, 6), (2.6, 6), (3.6, 5.5), (4, 4.5), (3.6, 3.4), (2.6, 2.9), (0, 2.9)]],
    "O": [[(1.6, 0), (0.5, 0.6), (0, 1.8), (0, 4.2), (0.5, 5.4), (1.6, 6), (2.4, 6), (3.5, 5.4), (4, 4.2), (4, 1.8),
           (3.5, 0.6), (2.4, 0), (1.6, 0)]],
    "S": [[(3.8, 5), (3.2, 5.8), (2.2, 6), (1.4, 6), (0.4, 5.6), (0.1, 4.6), (0.5, 3.6), (2, 3.1), (3.5, 2.5),
           (3.9, 1.5), (3.5, 0.5), (2.5, 0), (1.4, 0), (0.5, 0.3), (0.1, 1.1)]],
    "2": [[(0.2, 4.8), (0.7, 5.7), (1.8, 6), (2.4, 6), (3.5, 5.5), (3.8, 4.4), (3.3, 3.2), (0, 0), (4, 0)]],
    "4": [[(3, 0), (3, 6), (0, 1.7), (4, 1.7)]],
    "0": [[(1.7, 0), (0.6, 0.7), (0.2, 2), (0.2, 4), (0.6, 5.3), (1.7, 6), (2.3, 6), (3.4, 5.3), (3.8, 4), (3.8, 2),
           (3.4, 0.7), (2.3, 0), (1.7, 0)]],
    "-": [[(0.6, 3), (3.4, 3)]],
}


class Canvas:
    """A picture over the rectangle (left, bottom)..(right, top) in metres."""

    def __init__(self, width, height, left, right, bottom, top, colour):
        self.width, self.height = width, height
        self.left, self.bottom = left, bottom
        self.sx, self.sy = width / (right - left), height / (top - bottom)
        self.top = top
        self.rows = [bytearray(bytes(colour) * width) for _ in range(height)]

    def paint(self, box, colour, distance):
        """Fills where `distance(x, y)` (metres, negative inside) is below 0, edges smoothed over a pixel."""
        x0, y0, x1, y1 = box
        i0, i1 = max(0, int((x0 - self.left) * self.sx)), min(self.width, int((x1 - self.left) * self.sx) + 2)
        j0, j1 = max(0, int((self.top - y1) * self.sy)), min(self.height, int((self.top - y0) * self.sy) + 2)
        pixel = max(1 / self.sx, 1 / self.sy)
        for j in range(j0, j1):
            y = self.top - (j + 0.5) / self.sy
            row = self.rows[j]
            for i in range(i0, i1):
                share = 0.5 - distance(self.left + (i + 0.5) / self.sx, y) / pixel
                if share <= 0:
                    continue
                share = min(share, 1.0)
                for c in range(3):
                    row[3 * i + c] = round(row[3 * i + c] + (colour[c] - row[3 * i + c]) * share)

    def stroke(self, points, width, colour):
        half = width / 2
        for a, b in zip(points, points[1:]):
            dx, dy = b[0] - a[0], b[1] - a[1]
            span = dx * dx + dy * dy or 1e-12

            def distance(x, y, a=a, dx=dx, dy=dy, span=span):
                t = min(1.0, max(0.0, ((x - a[0]) * dx + (y - a[1]) * dy) / span))
                return math.hypot(x - a[0] - t * dx, y - a[1] - t * dy) - half
            pad = half + 0.02
            self.paint((min(a[0], b[0]) - pad, min(a[1], b[1]) - pad, max(a[0], b[0]) + pad, max(a[1], b[1]) + pad),
                       colour, distance)

    def text(self, text, x, y, height, width, colour, mirror=False, slant=0.0):
        """Letters from (x, y), bottom left; mirrored ones run toward -x, to be read from the other side."""
        unit, sign = height / 6, -1 if mirror else 1
        for letter in text:
            for line in LETTERS[letter]:
                self.stroke([(x + sign * unit * (px + slant * py), y + unit * py) for px, py in line], width, colour)
            x += sign * unit * 5.6

    def horn(self, x, y, size, colour, mirror=False):
        """A post horn: a coil, a mouthpiece, a bell and two tassels."""
        sign = -1 if mirror else 1

        def at(px, py):
            return (x + sign * size * px, y + size * py)
        ring = [at(0.42 * math.cos(a), 0.42 * math.sin(a)) for a in (2 * math.pi * k / 40 for k in range(41))]
        self.stroke(ring, size * 0.16, colour)
        self.stroke([at(-0.95, 0.5), at(-0.2, 0.40)], size * 0.14, colour)
        self.stroke([at(-0.98, 0.56), at(-0.97, 0.44)], size * 0.16, colour)
        for k in range(14):  # the bell widens
            t = k / 13
            self.stroke([at(0.1 + 0.75 * t, -0.42 - 0.05 * t), at(0.14 + 0.75 * t, -0.42 - 0.05 * t)],
                        size * (0.13 + 0.38 * t * t * t), colour)
        for side in (-0.25, 0.12):
            self.stroke([at(side, -0.45), at(side - 0.1, -0.9)], size * 0.09, colour)
            self.stroke([at(side - 0.1, -0.82), at(side - 0.12, -1.0)], size * 0.17, colour)

    def png_rows(self):
        return self.rows


SIDE_LEFT, SIDE_RIGHT, SIDE_BOTTOM, SIDE_TOP = -6.0, 2.6, -1.0, 1.9
WING_SPAN, WING_BACK, WING_FRONT = 5.6, -1.35, 0.6


def stripe(x):
    """Height of the band's middle: level along the nose, sweeping up to the fin."""
    back = max(0.0, -0.6 - x)
    return 0.02 + 0.030 * back ** 1.75


def side(livery, mirror):
    canvas = Canvas(1024, 512, SIDE_LEFT, SIDE_RIGHT, SIDE_BOTTOM, SIDE_TOP, livery.body)
    everything = (SIDE_LEFT, SIDE_BOTTOM, SIDE_RIGHT, SIDE_TOP)
    canvas.paint(everything, livery.upper, lambda x, y: y - stripe(x) + 0.02)
    band = lambda x: 0.075 + 0.012 * max(0.0, -x)
    canvas.paint(everything, livery.band, lambda x, y: abs(y - stripe(x)) - band(x))
    canvas.paint(everything, livery.upper, lambda x, y: abs(y - stripe(x) - band(x) - 0.045) - 0.014)
    seam = (206, 190, 150)
    for x in (1.08, -1.98, -3.4):
        canvas.stroke([(x, -0.9), (x, 0.9)], 0.008, seam)
    canvas.stroke([(0.95, -0.42), (-2.0, -0.42)], 0.008, seam)
    for x in (0.58, -0.46):  # the door
        canvas.stroke([(x, -0.42), (x, 0.8)], 0.009, (120, 104, 84))
    canvas.stroke([(-0.30, -0.16), (-0.40, -0.16)], 0.03, INK)  # its handle
    for k in range(4):  # louvres of the cowling
        canvas.stroke([(1.30 + 0.09 * k, -0.28), (1.36 + 0.09 * k, -0.18)], 0.02, (120, 104, 84))
    if mirror:
        canvas.text("LUFTPOST", -1.02, -0.32, 0.22, 0.045, INK, mirror=True, slant=0.12)
    else:
        canvas.text("LUFTPOST", -2.72, -0.32, 0.22, 0.045, INK, slant=0.12)
    canvas.horn(-5.08, 1.02, 0.34, INK, mirror=not mirror)
    canvas.text(livery.number, -3.62 if not mirror else -2.72, 0.02 + 0.03, 0.14, 0.026, livery.upper, mirror=mirror)
    return canvas.rows


def wing(livery, under):
    canvas = Canvas(1024, 192, -WING_SPAN, WING_SPAN, WING_BACK, WING_FRONT, livery.body)
    for sign in (-1, 1):
        canvas.paint((-WING_SPAN, WING_BACK, WING_SPAN, WING_FRONT), livery.band,
                     lambda z, x: 4.62 - sign * z)
        canvas.paint((-WING_SPAN, WING_BACK, WING_SPAN, WING_FRONT), livery.upper,
                     lambda z, x: abs(4.50 - sign * z) - 0.06)
    for k in range(-18, 19):  # ribs under the fabric
        canvas.stroke([(0.29 * k, -1.3), (0.29 * k, 0.6)], 0.012, livery.rib if abs(k) < 16 else livery.band_rib)
    # Letters are read with the nose up: z runs right on the upper side, left when seen from below.
    if under:
        canvas.text(livery.number, -1.20, -0.52, 0.70, 0.12, INK, mirror=True)
    else:
        canvas.text(livery.number, 1.20, -0.52, 0.70, 0.12, INK)
    return canvas.rows


def side_png(livery):
    return png(1024, 1024, side(livery, mirror=True) + side(livery, mirror=False))


def wing_png(livery):
    return png(1024, 384, wing(livery, under=False) + wing(livery, under=True))


def side_uv(p, right):
    u = (p[0] - SIDE_LEFT) / (SIDE_RIGHT - SIDE_LEFT)
    v = (SIDE_TOP - p[1]) / (SIDE_TOP - SIDE_BOTTOM)
    return (u, 0.5 * min(max(v, 0.002), 0.998) + (0.5 if right else 0.0))


def wing_uv(p, under):
    u = (p[2] + WING_SPAN) / (2 * WING_SPAN)
    v = (WING_FRONT - p[0]) / (WING_FRONT - WING_BACK)
    return (u, 0.5 * min(max(v, 0.004), 0.996) + (0.5 if under else 0.0))
