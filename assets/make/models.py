#!/usr/bin/env python3
"""Makes assets/models/*.glb. Run it after a change and check the products in: `python3 assets/make/models.py`.

Every model: metres, x forward, y up, z right. plane.glb and freight_plane.glb have the airframe's datum (centre of gravity of the
reference loading) at the origin, the same body frame as engine/flight. Its moving nodes rest at angle 0 and turn
about an axis of their own:
    propeller, propeller_disc          x   (+ as the engine turns: clockwise seen from the seat)
    aileron_left/right, elevator, flap_left/right   z   (+ trailing edge DOWN)
    rudder                             y   (+ trailing edge to the RIGHT)
    wheel_left/right, wheel_nose       z   (- rolling forward)
    yoke_left/right                    x   (+ turned right)
    needle_NAME, compass_card          x   (+ clockwise for the pilot; the scales are game/app/panel_scales.h)
    horizon_ball                       z pitch, then x roll, in `horizon`, which is pressed flat along x
slip_ball moves along z.
`propeller` holds the blades alone, to be hidden for `propeller_disc` at speed; `spinner` stays. From the seat
`exterior_fuselage` and `pilot` may be hidden: `interior_cabin` and `cowling` stay. `glass` (blended) is
a child of `exterior_fuselage`.
"""
import json
import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import livery  # noqa: E402
from gltf_writer import Mesh, Node, Writer, add, lerp, mul, sub, turn_about, unit  # noqa: E402

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "models")


def srgb(r, g, b):
    return tuple((c / 255 / 12.92 if c < 10.3 else ((c / 255 + 0.055) / 1.055) ** 2.4) for c in (r, g, b))


def curve(points):
    """A smooth function through (x, value) points, x falling or rising: monotone cubic."""
    points = sorted(points)
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    slopes = [(ys[i + 1] - ys[i]) / (xs[i + 1] - xs[i]) for i in range(len(xs) - 1)]
    tangents = [slopes[0]] + [0.0 if a * b <= 0 else 2 * a * b / (a + b) for a, b in zip(slopes, slopes[1:])]
    tangents.append(slopes[-1])

    def value(x):
        x = min(max(x, xs[0]), xs[-1])
        i = max(k for k in range(len(xs) - 1) if xs[k] <= x)
        h = xs[i + 1] - xs[i]
        t = (x - xs[i]) / h
        return ((1 + 2 * t) * (1 - t) ** 2 * ys[i] + t * (1 - t) ** 2 * h * tangents[i] +
                t * t * (3 - 2 * t) * ys[i + 1] + t * t * (t - 1) * h * tangents[i + 1])
    return value


# --- fuselage -------------------------------------------------------------------------------------------------
FIREWALL, TAIL = 1.08, -5.45


class Form:
    """What makes one aeroplane another: the hull behind the front seats, the tail, the propeller, the paint. What lies ahead of
    FOREPART, with the seats, the panel and the engine, is the same in both."""

    def __init__(self, **fields):
        self.__dict__.update(fields)


# The forepart's curves (x, value), then for each form those behind it.
ROOF = [(2.14, 0.16), (2.10, 0.235), (2.0, 0.285), (1.75, 0.325), (1.4, 0.355), (1.08, 0.385), (0.90, 0.49), (0.62, 0.70),
        (0.40, 0.82), (0.15, 0.86), (-0.7, 0.86)]
KEEL = [(2.14, -0.20), (2.10, -0.31), (2.0, -0.39), (1.75, -0.48), (1.4, -0.55), (1.08, -0.60), (0.4, -0.64), (-0.7, -0.63)]
HALF = [(2.14, 0.26), (2.10, 0.345), (2.0, 0.40), (1.75, 0.455), (1.4, 0.49), (1.08, 0.515), (0.4, 0.555), (-0.7, 0.555)]
waist = curve([(2.14, -0.02), (1.08, -0.06), (0.3, 0.04), (-1.2, 0.06), (-3.5, 0.13), (TAIL, 0.16)])
SQUARENESS = [(2.14, 2.2), (1.5, 2.6), (0.6, 3.6)]
SILL_HEIGHT = [(2.14, 0.5), (1.07, 0.90), (0.92, 0.55), (0.66, 0.33), (0.40, 0.27)]

LOWER = [-90, -76, -62, -48, -34, -20, -8]  # degrees around the lower half,
MIDDLE = [0.14, 0.40, 0.72]                   # then fractions of the way up to the sill, then from there to the roof
UPPER = [0.0, 0.12, 0.32, 0.54, 0.74, 0.86, 0.93, 0.97, 1.0]
SILL = len(LOWER) + len(MIDDLE)  # index of the sill's point
ROOF_EDGE = SILL + 4
# Stations along the fuselage and how far the window posts lean (m at the roof, toward the tail is negative).
STATIONS = [(2.14, 0), (2.12, 0), (2.08, 0), (2.0, 0), (1.88, 0), (1.72, 0), (1.5, 0), (1.28, 0), (1.08, 0), (1.06, 0),
            (0.98, 0), (0.88, -0.04), (0.77, -0.10), (0.63, -0.17), (0.615, -0.17), (0.585, -0.17), (0.57, -0.17), (0.3, -0.10),
            (0.05, -0.04), (-0.2, 0), (-0.42, 0.02), (-0.44, 0.02)]
CONE = [(-2.7, 0), (-3.3, 0), (-3.9, 0), (-4.5, 0), (-5.0, 0), (-5.3, 0), (TAIL, 0)]
WINDOWS = {"windscreen": (1.06, 0.63), "front": (0.57, -0.42)}
TRIMS = [(1.08, 1.06), (0.63, 0.615), (0.585, 0.57), (-0.42, -0.44)]

MAIL = Form(
    name="plane", livery=livery.MAIL,
    roof=curve(ROOF + [(-1.05, 0.83), (-1.35, 0.76), (-1.8, 0.60), (-2.4, 0.47), (-3.5, 0.36), (-4.6, 0.27), (TAIL, 0.22)]),
    keel=curve(KEEL + [(-1.4, -0.56), (-2.4, -0.38), (-3.5, -0.18), (-4.6, 0.0), (TAIL, 0.10)]),
    half=curve(HALF + [(-1.4, 0.47), (-2.4, 0.32), (-3.5, 0.20), (-4.6, 0.11), (TAIL, 0.035)]),
    squareness=curve(SQUARENESS + [(-1.0, 3.6), (-2.4, 2.8), (TAIL, 2.2)]),
    sill=curve(SILL_HEIGHT + [(-1.2, 0.27), (-1.4, 0.40), (-1.75, 0.62), (TAIL, 0.6)]),
    stations=STATIONS + [(-0.50, 0.02), (-0.52, 0.02), (-0.75, 0.06), (-1.02, 0.10), (-1.04, 0.10), (-1.16, 0.09), (-1.18, 0.09),
                         (-1.32, 0.05), (-1.5, 0), (-1.66, 0), (-1.68, 0), (-1.85, 0), (-2.2, 0)] + CONE,
    windows=WINDOWS | {"side": [(-0.52, -1.02)], "back": (-1.18, -1.66)},
    trims=TRIMS + [(-0.50, -0.52), (-1.02, -1.04), (-1.16, -1.18), (-1.66, -1.68)],
    cabin_end=-1.9, tail_half=1.72, tail_chord=1.0, fin_top=1.60, fin_chord=1.0, blades=2, blade=0.9525, pod=False, brace=True)
# A freighter: a square hold as high as the cabin, far behind the wing, without a window at its back; a pod under the belly, one
# strut a side, three blades, a bigger tail as the airframe's areas have it.
FREIGHT = Form(
    name="freight_plane", livery=livery.FREIGHT,
    roof=curve(ROOF + [(-1.2, 0.85), (-1.9, 0.80), (-2.35, 0.71), (-2.9, 0.59), (-3.7, 0.46), (-4.6, 0.34), (TAIL, 0.25)]),
    keel=curve(KEEL + [(-1.6, -0.62), (-2.2, -0.55), (-2.9, -0.37), (-3.7, -0.17), (-4.6, 0.0), (TAIL, 0.10)]),
    half=curve(HALF + [(-1.6, 0.55), (-2.2, 0.48), (-2.9, 0.36), (-3.7, 0.25), (-4.6, 0.14), (TAIL, 0.04)]),
    squareness=curve(SQUARENESS + [(-2.0, 4.4), (-3.2, 3.4), (TAIL, 2.4)]),
    sill=curve(SILL_HEIGHT + [(-2.4, 0.27), (-2.7, 0.40), (TAIL, 0.5)]),
    stations=STATIONS + [(-0.50, 0.02), (-0.52, 0.02), (-0.75, 0.0), (-0.98, 0.0), (-1.0, 0.0), (-1.24, 0.0), (-1.26, 0.0), (-1.5, 0), (-1.74, 0),
                         (-1.76, 0), (-2.0, 0), (-2.35, 0)] + CONE,
    windows=WINDOWS | {"side": [(-0.52, -0.98), (-1.26, -1.74)], "back": None},
    trims=TRIMS + [(-0.50, -0.52), (-0.98, -1.0), (-1.24, -1.26), (-1.74, -1.76)],
    cabin_end=-2.4, tail_half=1.95, tail_chord=1.13, fin_top=1.78, fin_chord=1.06, blades=3, blade=1.015, pod=True, brace=False)


def fuselage_ring(form, x, lean, inset=0.0):
    """Right half from keel to roof, then the left half back: a closed ring."""
    right = []
    n = form.squareness(x)
    for k in range(SILL + len(UPPER)):
        if k < len(LOWER):
            angle = math.radians(LOWER[k])
            down, out = abs(math.sin(angle)) ** (2 / n), abs(math.cos(angle)) ** (2 / n)
            y, z = waist(x) - down * (waist(x) - form.keel(x)), form.half(x) * out
            px = x
        else:
            over = UPPER[k - SILL] if k >= SILL else 0.0
            f = lerp(form.sill(x), 1.0, over) if k >= SILL else form.sill(x) * MIDDLE[k - len(LOWER)]
            px = x + lean * over
            y = waist(px) + f * (form.roof(px) - waist(px))
            z = form.half(px) * max(0.0, 1 - f ** n) ** (1 / n) * (1 - 0.06 * f)
        right.append((px, y - inset * (1 if y > 0 else -1) * 0.5, max(0.0, z - inset if k not in (0,) else 0.0)))
    right[0] = (right[0][0], right[0][1], 0.0)
    right[-1] = (right[-1][0], right[-1][1], 0.0)
    left = [(p[0], p[1], -p[2]) for p in right[-2:0:-1]]
    return right + left


def fuselage_material(form, i, j):
    """skin, glass, trim of the quad between stations i, i+1 and ring points j, j+1."""
    count = SILL + len(UPPER)
    k = j if j < count - 1 else 2 * (count - 1) - 1 - j  # as on the right side
    front, back = form.stations[i][0], form.stations[i + 1][0]

    def within(window):
        return window is not None and window[0] >= front and back >= window[1]
    over_sill = k >= SILL
    if over_sill and (within(form.windows["windscreen"]) or within(form.windows["back"])):
        return "glass"
    if SILL <= k < ROOF_EDGE and any(within(window) for window in [form.windows["front"], *form.windows["side"]]):
        return "glass"
    if (front, back) in form.trims and over_sill and (k < ROOF_EDGE or front > 0.6 or (back < -1.1 and form.windows["back"])):
        return "trim"
    return "skin"


def fuselage(form):
    rows = [fuselage_ring(form, x, lean) for x, lean in form.stations]
    count = SILL + len(UPPER)
    uv = lambda p, i, j: livery.side_uv(p, right=j < count - 1)
    skin, glass, cowl = Mesh(), Mesh(), Mesh()

    def part(i, j):
        which = fuselage_material(form, i, j)
        return "glass" if which == "glass" else "cowl" if form.stations[i + 1][0] >= FIREWALL else "skin"
    pick = lambda wanted: lambda i, j: fuselage_material(form, i, j) if part(i, j) == wanted else None
    for mesh, wanted in ((skin, "skin"), (cowl, "cowl"), (glass, "glass")):
        mesh.grid(rows, pick(wanted), closed=True, uv=uv)
    skin.fan(rows[-1], "skin", (-1.0, 0.0, 0.0), uv=lambda p: livery.side_uv(p, True))
    # The inside of the cabin, seen from the seat: the same skin turned inward, without the panes.
    cabin = Mesh()
    inner = [s for s in form.stations if form.cabin_end < s[0] < 1.07]
    first = form.stations.index(inner[0])
    shell = [fuselage_ring(form, x, lean, 0.02) for x, lean in inner]
    cabin.grid(shell, lambda i, j: None if fuselage_material(form, first + i, j) == "glass" else
               ("lining" if fuselage_material(form, first + i, j) == "skin" else "trim"), closed=True, inward=True)
    return skin, cowl, glass, cabin


# --- wings and tail -------------------------------------------------------------------------------------------
def thickness_naca(t):
    """Half thickness of a NACA four-digit section per unit of thickness, closed at the back."""
    return 5 * (0.2969 * math.sqrt(t) - 0.1260 * t - 0.3516 * t ** 2 + 0.2843 * t ** 3 - 0.1036 * t ** 4)


def camber_naca(t, m=0.02, p=0.4):
    return m / p ** 2 * (2 * p * t - t * t) if t < p else m / (1 - p) ** 2 * (1 - 2 * p + 2 * p * t - t * t)


def section(front, back, x_from, x_to, thick, camber, count=11):
    """Ring of (x, y): upper side from x_from (ahead) to x_to, lower side back. Chord from `front` to `back`."""
    chord = front - back
    a, b = (front - x_from) / chord, (front - x_to) / chord
    ts = [a + (b - a) * (0.5 - 0.5 * math.cos(math.pi * k / (count - 1))) for k in range(count)]
    at = lambda t, side: (front - t * chord, chord * (camber * camber_naca(t) + side * thick * thickness_naca(min(max(t, 0), 1))))
    upper = [at(t, 1) for t in ts]
    lower = [at(t, -1) for t in reversed(ts)]
    if a <= 1e-6:
        lower = lower[:-1]
    if b >= 1 - 1e-6:
        lower = lower[1:]
    return upper, lower


CHORD, WING_LE, HINGE_X = 1.63, 0.47, -0.72
WING_Y, DIHEDRAL = 0.865, math.radians(1.7)
WING_TIP, TAPER_FROM = 5.45, 2.62


def wing_chord(z):
    z = abs(z)
    chord = CHORD if z < TAPER_FROM else lerp(CHORD, 1.14, (z - TAPER_FROM) / (5.2 - TAPER_FROM))
    if z > 4.95:
        chord *= math.sqrt(max(0.0, 1 - ((z - 4.95) / (WING_TIP - 4.95)) ** 2.6)) * 0.999 + 0.001
    return chord


def wing_edges(z):
    chord = wing_chord(z)
    share = (WING_LE - HINGE_X) / CHORD
    return HINGE_X + share * chord, HINGE_X - (1 - share) * chord


def wing_piece(stations, x_to=None, x_from=None, lids=(True, True), origin=(0.0, 0.0, 0.0), nose=False):
    """A stretch of the right wing, from its leading edge (or x_from) to x_to (or the trailing edge)."""
    rows, uppers = [], 0
    for z in stations:
        front, back = wing_edges(z)
        up, low = section(front, back, front if x_from is None else x_from, back if x_to is None else x_to, 0.12, 1.0)
        ring = up + low
        uppers = len(up)
        if nose:  # a moving surface starts round
            (x0, y0), (_, y1) = up[0], low[-1]
            ring = ring + [(x0 + 0.6 * (y0 - y1) / 2, (y0 + y1) / 2 - 0.35 * (y0 - y1) / 2), (x0 + 0.6 * (y0 - y1) / 2, (y0 + y1) / 2 + 0.35 * (y0 - y1) / 2)]
        lift = WING_Y + math.tan(DIHEDRAL) * z
        rows.append([sub((x, y + lift, z), origin) for x, y in ring])
    mesh = Mesh()
    uv = lambda p, i, j: livery.wing_uv(add(p, origin), under=j >= uppers - 1)
    mesh.grid(rows, "wing", closed=True, uv=uv)
    for lid, row, way in ((lids[0], rows[0], -1.0), (lids[1], rows[-1], 1.0)):
        if lid:
            mesh.fan(row, "wing", (0.0, 0.0, way), uv=lambda p: livery.wing_uv(add(p, origin), False))
    return mesh


def left_uv(mesh, function):
    for vertices, _, _ in mesh.parts.values():
        for k, (p, n, t) in enumerate(vertices):
            vertices[k] = (p, n, function(p, n, t))
    return mesh


def wings():
    """The fixed wing and the four moving nodes."""
    right = Mesh()
    right.extend(wing_piece([0.0, 0.3, 0.62], lids=(False, True)))
    right.extend(wing_piece([0.62, 1.3, 2.0, 2.62], x_to=HINGE_X + 0.035, lids=(False, True)))
    right.extend(wing_piece([2.62, 2.70], lids=(True, True)))
    right.extend(wing_piece([2.70, 3.4, 4.2, 4.86], x_to=HINGE_X + 0.035, lids=(False, False)))
    right.extend(wing_piece([4.86, 4.95, 5.08, 5.2, 5.29, 5.36, 5.41, 5.44, 5.45], lids=(True, False)))
    hinge = lambda z: (HINGE_X, WING_Y + math.tan(DIHEDRAL) * z - 0.005, z)
    flap = wing_piece([0.635, 1.3, 2.0, 2.605], x_from=HINGE_X, origin=hinge(0.62), nose=True)
    aileron = wing_piece([2.715, 3.4, 4.2, 4.845], x_from=HINGE_X, origin=hinge(2.7), nose=True)
    both = Mesh().extend(right).extend(left_uv(right.mirrored(), lambda p, n, t: livery.wing_uv(p, t[1] > 0.5)))
    nodes = []
    for name, mesh, z in (("flap", flap, 0.62), ("aileron", aileron, 2.7)):
        at = hinge(z)
        nodes.append(hinged(name + "_right", mesh, at, DIHEDRAL))
        mirror = (at[0], at[1], -at[2])
        twin = left_uv(mesh.mirrored(), lambda p, n, t, mirror=mirror: livery.wing_uv(add(p, mirror), t[1] > 0.5))
        nodes.append(hinged(name + "_left", twin, mirror, -DIHEDRAL))
    return both, nodes


def hinged(name, mesh, at, slope):
    """A moving surface whose hinge rises with the dihedral: a fixed parent turns, the child rests at 0."""
    straight = Mesh()
    c, s = math.cos(-slope), math.sin(-slope)  # undo the slope, about x: z over to y
    turn = lambda p: (p[0], c * p[1] + s * p[2], -s * p[1] + c * p[2])
    for material, (vertices, indices, _) in mesh.parts.items():
        for k in range(0, len(indices), 3):
            straight.triangle(material, [(turn(vertices[i][0]), turn(vertices[i][1]), vertices[i][2]) for i in indices[k:k + 3]])
    return Node(name + "_hinge", at=at, turn=turn_about((1, 0, 0), -slope), children=[Node(name, straight)])


def tail_surface(span, le, te, x_from, x_to, thick, place, uv=None, material="wing", nose=False):
    """Symmetric surface over spanwise stations; `place` (x, y, s) -> point; uv (point, i, j)."""
    rows = []
    for s in span:
        front, back = le(s), te(s)
        a = front if x_from is None else min(front, x_from)
        b = back if x_to is None else max(back, x_to)
        up, low = section(front, back, a, b, thick / max(front - back, 0.05) if False else thick, 0.0, count=8)
        ring = up + low
        if nose:
            (x0, y0), (_, y1) = up[0], low[-1]
            ring = ring + [(x0 + 0.3 * (y0 - y1), y1 / 2), (x0 + 0.3 * (y0 - y1), y0 / 2)]
        rows.append([place(x, y, s) for x, y in ring])
    mesh = Mesh()
    mesh.grid(rows, material, closed=True, uv=uv)
    return mesh, rows


TAIL_HINGE, TAIL_Y = -5.02, 0.24
FIN_HINGE, FIN_BASE = -5.16, 0.20


def rounded(s, from_s):
    return math.sqrt(max(0.0, 1 - (max(0.0, s - from_s) / (1 - from_s)) ** 2.2)) * 0.998 + 0.002


def tailplane(form):
    le = lambda s: TAIL_HINGE + form.tail_chord * (0.72 - 0.20 * s) * rounded(s, 0.55)
    te = lambda s: TAIL_HINGE - form.tail_chord * (0.46 - 0.06 * s) * rounded(s, 0.55)
    spans = [0.0, 0.25, 0.5, 0.62, 0.74, 0.84, 0.91, 0.96, 0.985, 1.0]
    uv = lambda p, i, j: (0.5, 0.25)
    fixed, _ = tail_surface(spans, le, te, None, TAIL_HINGE + 0.02, 0.085,
                            lambda x, y, s: (x, TAIL_Y + y, s * form.tail_half), uv, "yellow")
    moving, rows = tail_surface([0.06] + spans[1:], le, te, TAIL_HINGE, None, 0.085,
                                lambda x, y, s: (x - TAIL_HINGE, y, s * form.tail_half), uv, "yellow", nose=True)
    moving.fan(rows[0], "yellow", (0.0, 0.0, -1.0))
    stab = Mesh().extend(fixed).extend(fixed.mirrored())
    elevator = Mesh().extend(moving).extend(moving.mirrored())
    return stab, Node("elevator", elevator, at=(TAIL_HINGE, TAIL_Y, 0.0))


def fin(form):
    fillet = lambda s: 1.05 * max(0.0, 1 - s / 0.42) ** 2.0
    le = lambda s: FIN_HINGE + (form.fin_chord * (0.92 - 0.42 * s) + fillet(s)) * rounded(s, 0.66)
    te = lambda s: FIN_HINGE - form.fin_chord * (0.50 - 0.08 * s) * rounded(s, 0.66) * (1 if s > 0.12 else lerp(0.55, 1.0, s / 0.12))
    spans = [0.0, 0.06, 0.12, 0.2, 0.3, 0.42, 0.55, 0.66, 0.76, 0.85, 0.92, 0.965, 0.99, 1.0]

    at = (FIN_HINGE, FIN_BASE, 0.0)
    fixed = fin_piece(form, spans, le, te, None, FIN_HINGE + 0.02, (0.0, 0.0, 0.0))
    moving = fin_piece(form, [-0.05] + spans, le, te, FIN_HINGE, None, at, nose=True)
    return fixed, Node("rudder", moving, at=at)


def fin_piece(form, spans, le, te, x_from, x_to, origin, nose=False):
    rows, uppers = [], 8
    for s in spans:
        c = max(s, 0.0)
        front, back = le(c), te(c)
        main = min(front - back, 1.5)
        up, low = section(front, back, front if x_from is None else x_from, back if x_to is None else x_to,
                          0.085 * main / (front - back), 0.0, count=8)
        ring = up + low
        if nose:
            (x0, y0), (_, y1) = up[0], low[-1]
            ring = ring + [(x0 + 0.3 * (y0 - y1), y1 / 2), (x0 + 0.3 * (y0 - y1), y0 / 2)]
        rows.append([sub((x, FIN_BASE + s * (form.fin_top - FIN_BASE), y), origin) for x, y in ring])
    mesh = Mesh()
    mesh.grid(rows, "skin", closed=True, uv=lambda p, i, j: livery.side_uv(add(p, origin), right=j < uppers - 1))
    mesh.fan(rows[0], "skin", (0.0, -1.0, 0.0), uv=lambda p: livery.side_uv(add(p, origin), True))
    return mesh


# --- wheels, struts, propeller --------------------------------------------------------------------------------
MAIN = (-0.40, -0.97, 1.28)   # middle of the right main wheel: its tyre stands where the airframe has the wheel
FRONT = (1.30, -1.07, 0.0)
TYRE = {"main": (0.33, 0.125), "nose": (0.27, 0.10)}  # outer radius, half width


def wheel(radius, width):
    tyre = radius - width
    ring = [(width * math.sin(a) * 1.02, tyre + width * math.cos(a)) for a in (math.pi * (k - 8) / 11 for k in range(17))]
    mesh = Mesh()
    mesh.lathe(ring, "rubber", axis=2, sides=32)
    rim = radius * 0.52
    for side in (-1, 1):
        mesh.lathe([(side * width * 0.72, rim * 1.12), (side * width * 0.80, rim * 0.9), (side * width * 0.60, rim * 0.55),
                    (side * width * 0.85, rim * 0.30), (side * width * 0.92, 0.001)], "silver", axis=2, sides=24)
    for k in range(5):  # a turning wheel is seen to turn
        a = 2 * math.pi * k / 5
        for side in (-1, 1):
            mesh.box((rim * 0.66 * math.cos(a), rim * 0.66 * math.sin(a), side * width * 0.70), (0.045, 0.045, 0.03), "trim")
    return mesh


def undercarriage():
    fixed = Mesh()
    leg = Mesh()
    root = (-0.16, -0.54, 0.36)
    path = [add(mul(root, 1 - t), mul(add(MAIN, (0.0, 0.02, -0.16)), t)) for t in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)]
    path = [add(p, (0.0, 0.05 * math.sin(math.pi * t), 0.0)) for p, t in zip(path, (0.0, 0.2, 0.4, 0.6, 0.8, 1.0))]
    leg.tube(path, [0.085, 0.078, 0.07, 0.064, 0.058, 0.052], "skin_yellow", sides=10, flat=0.42, up=(0.0, 1.0, 0.35))
    leg.tube([add(MAIN, (0, 0, -0.18)), add(MAIN, (0, 0, 0.10))], 0.035, "silver", sides=10)
    fixed.extend(leg).extend(leg.mirrored())
    top = (1.24, -0.50, 0.0)
    fixed.tube([top, add(FRONT, (-0.02, 0.37, 0.0))], 0.05, "skin_yellow", sides=12)
    fixed.tube([add(FRONT, (-0.02, 0.38, 0.0)), add(FRONT, (0.0, 0.28, 0.0))], 0.032, "silver", sides=10)
    for side in (-1, 1):
        fixed.tube([add(FRONT, (0.0, 0.29, 0.0)), add(FRONT, (0.0, 0.25, side * 0.13)), add(FRONT, (0.0, 0.0, side * 0.13))],
                   0.024, "skin_yellow", sides=8)
    fixed.tube([add(FRONT, (0, 0, -0.14)), add(FRONT, (0, 0, 0.14))], 0.022, "silver", sides=8)
    nodes = [Node("wheel_right", wheel(*TYRE["main"]), at=MAIN), Node("wheel_left", wheel(*TYRE["main"]), at=(MAIN[0], MAIN[1], -MAIN[2])),
             Node("wheel_nose", wheel(*TYRE["nose"]), at=FRONT)]
    return fixed, nodes


def struts(form):
    right = Mesh()
    low, high = (0.30, -0.40, 0.50), (0.10, WING_Y + math.tan(DIHEDRAL) * 2.55 - 0.085, 2.55)
    path = [add(mul(low, 1 - t), mul(high, t)) for t in (0.0, 0.04, 0.5, 0.96, 1.0)]
    right.tube(path, [0.055, 0.07, 0.07, 0.07, 0.05], "skin_yellow", sides=14, flat=0.42, up=(0.0, 0.6, -0.8))
    if not form.brace:
        return Mesh().extend(right).extend(right.mirrored())
    rear_high = (-0.52, WING_Y + math.tan(DIHEDRAL) * 2.5 - 0.06, 2.50)
    rear = [add(mul((0.22, -0.40, 0.50), 1 - t), mul(rear_high, t)) for t in (0.0, 0.5, 1.0)]
    right.tube(rear, [0.035, 0.04, 0.035], "skin_yellow", sides=10, flat=0.5, up=(0.0, 0.6, -0.8))
    middle = [add(mul(path[0], 0.42), mul(path[-1], 0.58)), add(mul(rear[0], 0.42), mul(rear[-1], 0.58))]
    right.tube(middle, 0.014, "silver", sides=6)
    return Mesh().extend(right).extend(right.mirrored())


PROPELLER = (2.27, -0.02, 0.0)


def propeller(form):
    mesh, spinner = Mesh(), Mesh()
    spinner.lathe([(0.30, 0.001), (0.295, 0.025), (0.27, 0.065), (0.20, 0.112), (0.10, 0.142), (0.0, 0.152), (-0.08, 0.152), (-0.081, 0.001)],
               "red", axis=0, sides=28)
    for turn in (2 * math.pi * k / form.blades for k in range(form.blades)):
        rows, tips = [], []
        for k in range(13):
            r = lerp(0.10, form.blade, k / 12)
            t = r / form.blade
            chord = 0.165 * math.sin(math.pi * min(1.0, 0.18 + 0.66 * t)) ** 0.8 * math.sqrt(max(0.0, 1 - max(0.0, (t - 0.9) / 0.1) ** 2)) + 0.004
            pitch = math.atan2(0.24, r) + 0.02
            ring = []
            for a in (2 * math.pi * m / 12 for m in range(12)):
                along, thick = 0.5 * chord * math.cos(a), 0.5 * chord * lerp(0.30, 0.09, min(1, t * 1.5)) * math.sin(a)
                x, z = along * math.sin(pitch) + thick * math.cos(pitch), along * math.cos(pitch) - thick * math.sin(pitch)
                y, w = r, z
                ring.append((x, y * math.cos(turn) - w * math.sin(turn), y * math.sin(turn) + w * math.cos(turn)))
            rows.append(ring)
        mesh.grid(rows[:11], "blade", closed=True)
        mesh.grid(rows[10:], "blade_tip", closed=True)
    disc = Mesh()
    for k in range(48):
        a, b = 2 * math.pi * k / 48, 2 * math.pi * (k + 1) / 48
        for near, far, material in ((0.15, 0.80, "disc"), (0.80, form.blade, "disc_tip")):
            ring = [(0.03, near * math.cos(a), near * math.sin(a)), (0.03, far * math.cos(a), far * math.sin(a)),
                    (0.03, far * math.cos(b), far * math.sin(b)), (0.03, near * math.cos(b), near * math.sin(b))]
            disc.quad(ring, material)
    return Node("propeller", mesh, at=PROPELLER), Node("propeller_disc", disc, at=PROPELLER), Node("spinner", spinner, at=PROPELLER)


def cowling(form):
    """Front plate, air intakes, exhaust, landing light."""
    mesh = Mesh()
    front = fuselage_ring(form, *STATIONS[0])
    mesh.fan(front, "trim", (1.0, 0.0, 0.0))
    lip = [add(mul(sub(p, (2.14, -0.02, 0)), 0.93), (2.15, -0.02, 0.0)) for p in front]
    mesh.grid([front, lip], "silver", closed=True)
    for side in (-1, 1):
        rows = []
        for x, s in ((2.155, 1.0), (2.165, 0.92), (2.12, 0.86)):
            rows.append([(x, 0.0 + s * 0.075 * math.sin(a), side * 0.19 + s * 0.085 * math.cos(a)) for a in (2 * math.pi * k / 20 for k in range(20))])
        mesh.grid(rows[:2], "silver", closed=True)
        mesh.grid(rows[1:], "trim", closed=True, inward=True)
        mesh.fan(rows[2], "dark", (1.0, 0.0, 0.0))
    mesh.lathe([(2.165, 0.001), (2.165, 0.07)], "lamp", axis=0, sides=20, middle=(0.0, -0.17, 0.0))
    mesh.lathe([(2.165, 0.07), (2.18, 0.082), (2.14, 0.088)], "silver", axis=0, sides=20, middle=(0.0, -0.17, 0.0))
    mesh.tube([(1.55, -0.50, 0.20), (1.50, -0.64, 0.22), (1.36, -0.72, 0.22), (1.22, -0.74, 0.22)], 0.04, "exhaust", sides=12)
    return mesh


def lights(form):
    mesh = Mesh()
    y = WING_Y + math.tan(DIHEDRAL) * 5.4
    mesh.ellipsoid((HINGE_X + 0.62, y, -5.44), (0.06, 0.025, 0.025), "light_red", sides=12)
    mesh.ellipsoid((HINGE_X + 0.62, y, 5.44), (0.06, 0.025, 0.025), "light_green", sides=12)
    mesh.ellipsoid((-5.30, form.fin_top + 0.01, 0.0), (0.035, 0.03, 0.025), "light_beacon", sides=12)
    mesh.tube([(-0.9, 0.90, 0.0), (-0.98, 1.22, 0.0)], [0.012, 0.004], "trim", sides=6)      # aerial
    mesh.tube([(0.12, 0.92, 3.3), (0.12, 0.78, 3.3), (0.34, 0.77, 3.3)], 0.012, "silver", sides=6)  # pitot
    return mesh


# --- inside ---------------------------------------------------------------------------------------------------
SCALES = {row[0]: tuple(map(float, row[1:])) for row in
          re.findall(r'DialScale\{"(\w+)", ([-.\d]+), ([-.\d]+), ([-.\d]+), ([-.\d]+)\}', open(os.path.join(OUT, "..", "..", "game", "app", "panel_scales.h")).read())}

# Strokes of a figure in a box 1 wide and 2 high, from its lower left corner; h is a half.
STROKES = {"0": ["00 10 12 02 00"], "1": ["h0 h2"], "2": ["02 12 11 01 00 10"], "3": ["02 12 10 00", "01 11"], "4": ["02 01 11", "12 10"],
           "5": ["12 02 01 11 10 00"], "6": ["12 02 00 10 11 01"], "7": ["02 12 10"], "8": ["00 10 12 02 00", "01 11"], "9": ["11 01 02 12 10 00"],
           "-": ["01 11"], "N": ["00 02 10 12"], "E": ["10 00 02 12", "01 11"], "S": ["12 02 01 11 10 00"], "W": ["02 00 h1 10 12"],
           "A": ["00 02 12 10", "01 11"], "F": ["00 02 12", "01 11"], "G": ["12 02 00 10 11 h1"], "K": ["00 02", "12 01 10"], "L": ["02 00 10"],
           "M": ["00 02 h1 12 10"], "O": ["00 10 12 02 00"], "P": ["00 02 12 11 01"], "R": ["00 02 12 11 01", "h1 10"], "T": ["02 12", "h2 h0"]}


def on_dial(radius, angle):
    """y and z from the dial's middle, at so many degrees clockwise from the top."""
    a = math.radians(angle)
    return radius * math.cos(a), radius * math.sin(a)


def figure(mesh, x, y, z, text, high, material="mark", turn=0.0):
    """Plates for the text's strokes about (y, z), upright or turned by degrees clockwise."""
    unit_, bold = high / 2, high * 0.085
    wide = unit_ * (len(text) * 1.55 - 0.55)
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    for k, letter in enumerate(text):
        for stroke in STROKES[letter]:
            points = [(-wide / 2 + unit_ * (1.55 * k + (0.5 if p[0] == "h" else int(p[0]))), -unit_ + unit_ * int(p[1])) for p in stroke.split()]
            for (z0, y0), (z1, y1) in zip(points, points[1:]):
                size = math.hypot(z1 - z0, y1 - y0)
                ez, ey = (z1 - z0) / size * bold, (y1 - y0) / size * bold
                corners = [(z0 - ez - ey, y0 - ey + ez), (z1 + ez - ey, y1 + ey + ez), (z1 + ez + ey, y1 + ey - ez), (z0 - ez + ey, y0 - ey - ez)]
                plate(mesh, x, [(y + b * c - a * s, z + a * c + b * s) for a, b in corners], material)


def face(mesh, y, z, radius, x):
    mesh.lathe([(x - 0.004, radius), (x - 0.004, 0.001)][::-1], "dial", axis=0, sides=32, middle=(0.0, y, z))
    mesh.lathe([(x - 0.001, radius * 1.12), (x - 0.010, radius * 1.06), (x - 0.006, radius)], "silver", axis=0, sides=32, middle=(0.0, y, z))


def tick(mesh, y, z, x, angle, inner, outer, wide, material="mark"):
    (y0, z0), (y1, z1) = on_dial(inner, angle), on_dial(outer, angle)
    ey, ez = on_dial(wide, angle + 90)
    plate(mesh, x, [(y + y0 - ey, z + z0 - ez), (y + y1 - ey, z + z1 - ez), (y + y1 + ey, z + z1 + ez), (y + y0 + ey, z + z0 + ez)], material)


def arc(mesh, y, z, x, from_angle, to_angle, inner, outer, material):
    steps = max(2, int(abs(to_angle - from_angle) / 8))
    for k in range(steps):
        a, b = (from_angle + (to_angle - from_angle) * (k + d) / steps for d in (0, 1))
        corners = [on_dial(inner, a), on_dial(outer, a), on_dial(outer, b), on_dial(inner, b)]
        plate(mesh, x, [(y + p, z + q) for p, q in corners], material)


def angle_on(scale, reading):
    low, high, from_angle, to_angle = SCALES[scale]
    return from_angle + (to_angle - from_angle) * (reading - low) / (high - low)


def dial(mesh, y, z, radius, x, scale, step, figures, name, divide=1.0, high=0.2, name_at=-0.32):
    """A face with its name, a tick every `step` and figures (of the reading over `divide`) at `figures`."""
    face(mesh, y, z, radius, x)
    figure(mesh, x - 0.0055, y + name_at * radius, z, name, radius * 0.24)
    low, high_reading = SCALES[scale][:2]
    count = round((high_reading - low) / step)
    for k in range(count + 1):
        reading = low + k * step
        big = any(abs(reading - f) < 1e-6 for f in figures)
        tick(mesh, y, z, x - 0.0055, angle_on(scale, reading), radius * (0.76 if big else 0.84), radius * 0.93, radius * (0.03 if big else 0.018))
    for reading in figures:
        dy, dz = on_dial(radius * 0.58, angle_on(scale, reading))
        text = f"{abs(reading) / divide:.0f}"
        figure(mesh, x - 0.0055, y + dy, z + dz, text, radius * high)


def hand(name, y, z, radius, x, length=0.84, wide=0.05, lift=0.0):
    """A needle's node: it points to the top and turns about the dial's middle."""
    mesh = Mesh()
    plate(mesh, -0.0068 - lift, [(-0.18 * radius, -wide * radius), (length * radius, -0.25 * wide * radius), (length * radius, 0.25 * wide * radius), (-0.18 * radius, wide * radius)], "needle")
    mesh.lathe([(-0.0085 - lift, 0.1 * radius), (-0.0085 - lift, 0.001)][::-1], "silver", axis=0, sides=12)
    return Node(name, mesh, at=(x, y, z))


def horizon(mesh, y, z, radius, x):
    """A ball pressed flat by the game (`horizon`), in it the ball that pitches about z and rolls about x."""
    mesh.lathe([(x - 0.001, radius * 1.12), (x - 0.012, radius * 1.06), (x - 0.004, radius * 0.98)], "silver", axis=0, sides=32, middle=(0.0, y, z))
    ball = Mesh()
    at = lambda degrees, out=1.0: (out * radius * math.sin(math.radians(degrees)), out * radius * math.cos(math.radians(degrees)))
    ball.lathe([at(d) for d in range(0, 91, 6)], "horizon_sky", axis=1, sides=36)
    ball.lathe([at(d) for d in range(-90, 1, 6)], "horizon_land", axis=1, sides=36)
    for d, half in ((0, 1.1), (10, 0.55), (20, 0.55), (-10, 0.55), (-20, 0.55)):
        ball.lathe([at(d - half, 1.012), at(d + half, 1.012)], "mark", axis=1, sides=36)
    for side in (-1, 1):  # the aircraft before it
        plate(mesh, x - 0.0125, [(y + 0.0014, z + side * radius * 0.22), (y + 0.0014, z + side * radius * 0.62), (y - 0.0014, z + side * radius * 0.62), (y - 0.0014, z + side * radius * 0.22)], "index")
    plate(mesh, x - 0.0125, [(y + 0.0018, z - 0.0018), (y + 0.0018, z + 0.0018), (y - 0.0018, z + 0.0018), (y - 0.0018, z - 0.0018)], "index")
    return Node("horizon", at=(x - 0.002, y, z), children=[Node("horizon_ball", ball)])


def compass(mesh, y, z, radius, x):
    face(mesh, y, z, radius, x)
    card = Mesh()
    for k in range(36):
        tick(card, 0, 0, -0.0055, 10 * k, radius * (0.76 if k % 3 == 0 else 0.86), radius * 0.93, radius * (0.03 if k % 3 == 0 else 0.02))
    for k, text in enumerate("NESW"):
        dy, dz = on_dial(radius * 0.56, 90 * k)
        figure(card, -0.0055, dy, dz, text, radius * 0.36, turn=90 * k)
    tick(mesh, y, z, x - 0.007, 0, radius * 0.80, radius * 1.04, radius * 0.04, "index")
    tick(mesh, y, z, x - 0.007, 0, -radius * 0.3, radius * 0.3, radius * 0.03, "index")
    tick(mesh, y, z, x - 0.007, 90, -radius * 0.24, radius * 0.24, radius * 0.03, "index")
    return Node("compass_card", card, at=(x, y, z))


def turn_and_slip(mesh, y, z, radius, x):
    face(mesh, y, z, radius, x)
    for side in (-1, 1):  # level, and the turn that takes two minutes
        for angle in (90, 90 + angle_on("needle_turn", 3)):
            tick(mesh, y, z, x - 0.0055, side * angle, radius * 0.78, radius * 0.94, radius * 0.04)
    dy = -0.55 * radius
    plate(mesh, x - 0.0055, [(y + dy + 0.0055, z - 0.026), (y + dy + 0.0055, z + 0.026), (y + dy - 0.0055, z + 0.026), (y + dy - 0.0055, z - 0.026)], "mark")
    for side in (-1, 1):
        plate(mesh, x - 0.0062, [(y + dy + 0.0055, z + side * 0.0066 - 0.0006), (y + dy + 0.0055, z + side * 0.0066 + 0.0006), (y + dy - 0.0055, z + side * 0.0066 + 0.0006), (y + dy - 0.0055, z + side * 0.0066 - 0.0006)], "dial")
    ball = Mesh()
    ball.lathe([(-0.0068, 0.0050), (-0.0068, 0.0005)][::-1], "dial", axis=0, sides=16)
    plane_ = Mesh()
    for angle, length_, wide in ((90, 0.72, 0.045), (-90, 0.72, 0.045), (0, 0.26, 0.04)):
        tick(plane_, 0, 0, -0.0072, angle, 0.0, radius * length_, radius * wide, "needle")
    return [Node("slip_ball", ball, at=(x, y + dy, z)), Node("needle_turn", plane_, at=(x, y, z))]


def airspeed(mesh, y, z, radius, x):
    """With the arcs of the airframe's own marks."""
    dial(mesh, y, z, radius, x, "needle_airspeed", 10, range(40, 181, 40), "KT", name_at=0.24, high=0.27)
    with open(os.path.join(OUT, "..", "airframes", "mail_plane.json")) as file:
        marks = json.load(file)["speeds"]
    kt = lambda name: marks[name + "_kt"]
    at = lambda reading: angle_on("needle_airspeed", reading)
    arc(mesh, y, z, x - 0.0052, at(kt("stallFlaps")), at(kt("flapLimit")), radius * 0.68, radius * 0.73, "mark")
    arc(mesh, y, z, x - 0.0052, at(kt("stall")), at(kt("cruiseLimit")), radius * 0.94, radius * 0.995, "arc_green")
    arc(mesh, y, z, x - 0.0052, at(kt("cruiseLimit")), at(kt("neverExceed")), radius * 0.94, radius * 0.995, "index")
    tick(mesh, y, z, x - 0.0060, at(kt("neverExceed")), radius * 0.72, radius * 1.0, radius * 0.03, "red")


def instruments(mesh, x):
    """The faces go into the mesh of the panel; the nodes that move are the answer."""
    top, low, big, small = 0.226, 0.110, 0.051, 0.033
    left, middle, right = -0.365, -0.247, -0.129
    airspeed(mesh, top, left, big, x)
    dial(mesh, top, right, big, x, "needle_altitude", 50, range(0, 1000, 100), "FT", divide=100, high=0.30)
    dial(mesh, low, right, big, x, "needle_climb", 250, range(-2000, 2001, 1000), "FPM", divide=100, high=0.29, name_at=-0.26)
    dial(mesh, 0.228, 0.03, 0.044, x, "needle_rpm", 250, range(0, 3001, 1000), "RPM", name_at=-0.74, divide=100, high=0.34)
    dial(mesh, 0.122, 0.03, 0.044, x, "needle_fuel", 20, range(0, 161, 80), "KG", high=0.32)
    dial(mesh, 0.240, 0.118, small, x, "needle_angle", 5, range(-10, 21, 10), "AOA", name_at=-0.68, high=0.34)
    dial(mesh, 0.164, 0.118, small, x, "needle_load", 1, range(-2, 5, 2), "G", name_at=0.30, high=0.36)
    dial(mesh, 0.088, 0.118, small, x, "needle_flaps", 25, range(0, 101, 50), "FLAPS", high=0.34, name_at=-0.5)
    return [hand("needle_airspeed", top, left, big, x), hand("needle_altitude_short", top, right, big, x, length=0.5, wide=0.09), hand("needle_altitude", top, right, big, x, lift=0.001),
            hand("needle_climb", low, right, big, x), hand("needle_rpm", 0.228, 0.03, 0.044, x), hand("needle_fuel", 0.122, 0.03, 0.044, x),
            hand("needle_angle", 0.240, 0.118, small, x), hand("needle_load", 0.164, 0.118, small, x), hand("needle_flaps", 0.088, 0.118, small, x),
            horizon(mesh, top, middle, big, x), compass(mesh, low, middle, big, x), *turn_and_slip(mesh, low, left, big, x)]


def plate(mesh, x, corners, material):
    ring = [(x, y, z) for y, z in corners]
    facing = Mesh()
    facing.quad(ring, material)
    normal = next(iter(facing.parts.values()))[0][0][1]
    mesh.quad(ring if normal[0] < 0 else ring[::-1], material)


def cockpit(form):
    mesh = Mesh()
    x = 0.80
    edge = sorted((p[2], p[1]) for p in fuselage_ring(form, 1.085, 0.0)[len(LOWER):SILL + len(UPPER)])
    rim = lambda z: curve(edge)(abs(z))  # the cowling's top edge under the windscreen
    outline = [(x, 0.335 - 0.085 * (abs(z) / 0.47) ** 3, z) for z in [0.47 - 0.094 * k for k in range(11)]]
    ring = outline + [(x, -0.12, -0.48), (x, -0.12, 0.48)]
    mesh.fan(ring, "panel", (-1.0, 0.0, 0.0))
    shield = [[(x - 0.06, p[1] + 0.012, p[2]) for p in outline], [(x + 0.10, p[1] + 0.035, p[2]) for p in outline],
              [(1.085, rim(1.06 * p[2]) + 0.002, 1.06 * p[2]) for p in outline]]
    glare = Mesh()
    glare.grid(shield, "glare", inward=False)
    if next(iter(glare.parts.values()))[0][0][1][1] < 0:
        glare = Mesh().grid(shield, "glare", inward=True)
    mesh.extend(glare)
    mesh.quad([(x - 0.06, p[1] + 0.012 - d, p[2]) for p, d in ((outline[0], 0), (outline[0], 0.03), (outline[-1], 0.03), (outline[-1], 0))], "glare")
    moving = instruments(mesh, x)
    for k in range(3):
        mesh.box((x - 0.012, 0.235 - 0.075 * k, 0.27), (0.022, 0.058, 0.19), "radio", 0.004)
        plate(mesh, x - 0.0245, [(0.222 - 0.075 * k, 0.195), (0.222 - 0.075 * k, 0.29), (0.249 - 0.075 * k, 0.29), (0.249 - 0.075 * k, 0.195)], "radio_glow")
    for z, material in ((-0.02, "dark"), (0.04, "red")):
        mesh.tube([(x - 0.01, -0.07, z), (x - 0.10, -0.07, z)], 0.007, "silver", sides=8)
        mesh.lathe([(x - 0.125, 0.001), (x - 0.12, 0.02), (x - 0.10, 0.022), (x - 0.095, 0.001)], material, axis=0, sides=14, middle=(0, -0.07, z))
    mesh.quad([(1.0, -0.46, 0.38), (1.0, -0.46, -0.38), (-1.2, -0.46, -0.38), (-1.2, -0.46, 0.38)][::-1], "carpet")
    wall = [p for p in fuselage_ring(form, -1.24, 0.0, 0.03) if p[1] < 0.36]
    mesh.fan(wall, "lining", (1.0, 0.0, 0.0))
    for side in (-1, 1):
        seat(mesh, side * 0.27)
    parcels(mesh)
    return mesh, moving


def seat(mesh, z):
    mesh.box((-0.02, -0.22, z), (0.46, 0.12, 0.42), "leather", 0.035)
    back = Mesh()
    back.box((0.0, 0.0, 0.0), (0.10, 0.56, 0.40), "leather", 0.03)
    lean = math.radians(14)
    for material, (vertices, indices, _) in back.parts.items():
        turned = lambda p: (p[0] * math.cos(lean) - p[1] * math.sin(lean), p[0] * math.sin(lean) + p[1] * math.cos(lean), p[2])
        for k in range(0, len(indices), 3):
            mesh.triangle(material, [(add(turned(vertices[i][0]), (-0.30, 0.08, z)), turned(vertices[i][1]), vertices[i][2]) for i in indices[k:k + 3]])
    for dz in (-0.15, 0.15):
        mesh.box((-0.02, -0.37, z + dz), (0.40, 0.18, 0.03), "dark")


def parcels(mesh):
    """Freight behind the seats."""
    for at, size in (((-0.98, -0.25, -0.20), (0.44, 0.42, 0.46)), ((-1.00, -0.30, 0.25), (0.40, 0.32, 0.36)), ((-0.95, -0.0, 0.2), (0.3, 0.26, 0.3))):
        mesh.box(at, size, "cardboard", 0.008)
        mesh.box(at, (size[0] + 0.008, size[1] + 0.008, 0.045), "strap")
        mesh.box(at, (0.045, size[1] + 0.008, size[2] + 0.008), "strap")


def yoke():
    mesh = Mesh()
    mesh.tube([(0.13, 0.0, 0.0), (0.0, 0.0, 0.0)], 0.016, "silver", sides=10)
    mesh.tube([(0.0, 0.075, -0.135), (0.0, 0.0, -0.125), (0.0, -0.045, -0.07), (0.0, -0.045, 0.07), (0.0, 0.0, 0.125), (0.0, 0.075, 0.135)],
              [0.017, 0.017, 0.015, 0.015, 0.017, 0.017], "dark", sides=10, up=(1.0, 0.0, 0.0))
    mesh.box((0.0, -0.03, 0.0), (0.035, 0.06, 0.08), "dark", 0.008)
    return mesh


def pilot(z=-0.27):
    """Someone sits there: leather cap, scarf."""
    mesh = Mesh()
    mesh.ellipsoid((-0.10, 0.08, z), (0.15, 0.27, 0.21), "jacket", sides=18)
    mesh.ellipsoid((-0.06, 0.30, z), (0.09, 0.06, 0.10), "red", sides=14)
    mesh.ellipsoid((-0.05, 0.46, z), (0.105, 0.135, 0.092), "face", sides=18)
    mesh.ellipsoid((-0.068, 0.485, z), (0.108, 0.128, 0.10), "leather", sides=18)
    for side in (-1, 1):
        mesh.tube([(-0.08, 0.20, z + side * 0.19), (0.14, -0.02, z + side * 0.20), (0.50, 0.10, z + side * 0.13)], [0.06, 0.05, 0.038], "jacket", sides=10)
        mesh.ellipsoid((0.045, 0.49, z + side * 0.036), (0.012, 0.026, 0.03), "dark", sides=10)
    return mesh


PLANE_MATERIALS = {
    "skin": dict(color=(1, 1, 1), rough=0.34, texture="side"),
    "wing": dict(color=(1, 1, 1), rough=0.42, texture="wing"),
    "skin_yellow": dict(color=srgb(250, 186, 22), rough=0.36),
    "yellow": dict(color=srgb(250, 186, 22), rough=0.42),
    "red": dict(color=srgb(188, 36, 28), rough=0.3),
    "glass": dict(color=(0.06, 0.09, 0.11, 0.32), rough=0.04, blend=True),
    "trim": dict(color=srgb(52, 50, 52), rough=0.6),
    "dark": dict(color=srgb(24, 24, 27), rough=0.7),
    "rubber": dict(color=srgb(32, 31, 32), rough=0.9),
    "silver": dict(color=srgb(200, 202, 206), rough=0.28, metal=1.0),
    "exhaust": dict(color=srgb(120, 104, 92), rough=0.5, metal=1.0),
    "blade": dict(color=srgb(58, 58, 62), rough=0.45),
    "blade_tip": dict(color=srgb(246, 200, 30), rough=0.45),
    "disc": dict(color=(0.05, 0.05, 0.055, 0.09), rough=0.9, blend=True, both=True),
    "disc_tip": dict(color=(0.55, 0.36, 0.05, 0.07), rough=0.9, blend=True, both=True),
    "lamp": dict(color=(1, 1, 0.95), rough=0.2, emit=(1.0, 0.93, 0.75)),
    "light_red": dict(color=(0.8, 0.02, 0.02), rough=0.2, emit=(1.0, 0.05, 0.03)),
    "light_green": dict(color=(0.02, 0.7, 0.1), rough=0.2, emit=(0.03, 0.9, 0.2)),
    "light_beacon": dict(color=(0.9, 0.9, 0.9), rough=0.2, emit=(0.9, 0.9, 0.9)),
    "lining": dict(color=srgb(176, 160, 134), rough=0.9),
    "carpet": dict(color=srgb(74, 66, 60), rough=1.0),
    "panel": dict(color=srgb(58, 56, 58), rough=0.8),
    "glare": dict(color=srgb(30, 29, 30), rough=1.0),
    "dial": dict(color=srgb(14, 14, 16), rough=0.5),
    "mark": dict(color=srgb(232, 228, 214), rough=0.8, emit=(0.10, 0.09, 0.07)),
    "needle": dict(color=srgb(250, 246, 232), rough=0.8, emit=(0.18, 0.16, 0.12)),
    "index": dict(color=srgb(250, 168, 30), rough=0.8, emit=(0.16, 0.10, 0.01)),
    "arc_green": dict(color=srgb(60, 170, 70), rough=0.8, emit=(0.03, 0.10, 0.03)),
    "horizon_sky": dict(color=srgb(66, 138, 214), rough=0.8, emit=(0.02, 0.05, 0.09)),
    "horizon_land": dict(color=srgb(122, 82, 44), rough=0.8, emit=(0.04, 0.025, 0.01)),
    "radio": dict(color=srgb(34, 34, 38), rough=0.6),
    "radio_glow": dict(color=srgb(40, 24, 8), rough=0.6, emit=(0.35, 0.16, 0.03)),
    "leather": dict(color=srgb(112, 66, 36), rough=0.65),
    "jacket": dict(color=srgb(86, 58, 38), rough=0.8),
    "face": dict(color=srgb(222, 172, 138), rough=0.7),
    "cardboard": dict(color=srgb(186, 146, 98), rough=0.9),
    "strap": dict(color=srgb(52, 74, 110), rough=0.8),
}


def pod():
    """Under the belly, for freight: a shallow trough with rounded ends."""
    mesh = Mesh()
    rows = []
    for x, s in ((0.92, 0.02), (0.86, 0.45), (0.70, 0.78), (0.45, 0.95), (0.1, 1.0), (-1.0, 1.0), (-1.5, 0.93), (-1.9, 0.62), (-2.15, 0.25), (-2.25, 0.02)):
        low, wide, top = -0.58 - 0.25 * s, 0.10 + 0.33 * s ** 0.5, -0.52
        rows.append([(x, top + (low - top) * max(0.0, math.sin(a)) ** 0.6, wide * math.copysign(abs(math.cos(a)) ** 0.6, math.cos(a)))
                     for a in (math.pi * k / 12 for k in range(13))])
    mesh.grid(rows, "skin_yellow")
    if next(iter(mesh.parts.values()))[0][len(rows[0]) // 2][1][1] > 0:
        mesh = Mesh().grid(rows, "skin_yellow", inward=True)
    return mesh


def plane(form):
    skin, cowl, glass, cabin = fuselage(form)
    wing_mesh, wing_nodes = wings()
    stab, elevator = tailplane(form)
    fin_mesh, rudder = fin(form)
    gear, wheels = undercarriage()
    turning, disc, spinner = propeller(form)
    outside = Mesh().extend(skin).extend(fin_mesh)
    surfaces = Mesh().extend(wing_mesh).extend(stab).extend(struts(form)).extend(gear).extend(lights(form))
    if form.pod:
        surfaces.extend(pod())
    seats, moving = cockpit(form)
    inside = Mesh().extend(cabin).extend(seats)
    roots = [Node("exterior_fuselage", outside, children=[Node("glass", glass)]), Node("cowling", Mesh().extend(cowl).extend(cowling(form))), Node("exterior_wings", surfaces), Node("interior_cabin", inside, children=moving),
             Node("pilot", pilot()), Node("yoke_left", yoke(), at=(0.58, 0.10, -0.27)), Node("yoke_right", yoke(), at=(0.58, 0.10, 0.27)),
             *wing_nodes, elevator, rudder, *wheels, turning, spinner, disc]
    paint = dict(color=srgb(*form.livery.body), rough=0.36)
    materials = PLANE_MATERIALS | {"skin_yellow": paint, "yellow": paint | dict(rough=0.42), "red": dict(color=srgb(*form.livery.band), rough=0.3)}
    writer = Writer(materials, {"side": livery.side_png(form.livery), "wing": livery.wing_png(form.livery)})
    writer.save(os.path.join(OUT, form.name + ".glb"), [Node("plane", children=roots)])


# --- freight and airfield -------------------------------------------------------------------------------------
def parcel():
    mesh = Mesh()
    mesh.box((0, 0, 0), (0.9, 0.66, 0.66), "crate", 0.02)
    for k in (-1, 1):
        for y in (-1, 1):
            mesh.box((0, y * 0.335, k * 0.335), (0.94, 0.07, 0.07), "edge", 0.01)
            mesh.box((k * 0.455, y * 0.335, 0), (0.07, 0.07, 0.74), "edge", 0.01)
            mesh.box((k * 0.455, 0, y * 0.335), (0.07, 0.74, 0.07), "edge", 0.01)
        mesh.box((k * 0.22, 0, 0), (0.06, 0.70, 0.70), "strap", 0.008)
    mesh.box((0, -0.40, 0), (0.92, 0.12, 0.68), "pad", 0.03)
    for z in (-1, 1):  # a horn on either side, of boxes around a ring
        for k in range(16):
            a = 2 * math.pi * k / 16
            mesh.box((0.10 * math.cos(a), 0.06 + 0.10 * math.sin(a), z * 0.333), (0.045, 0.045, 0.012), "ink")
        mesh.box((0.12, -0.05, z * 0.333), (0.20, 0.05, 0.012), "ink")
    mesh.box((0.22, 0.37, 0), (0.05, 0.05, 0.12), "silver")
    mesh.box((-0.22, 0.37, 0), (0.05, 0.05, 0.12), "silver")
    materials = {"crate": dict(color=srgb(214, 168, 96), rough=0.85), "edge": dict(color=srgb(150, 104, 56), rough=0.85),
                 "strap": dict(color=srgb(188, 36, 28), rough=0.7), "pad": dict(color=srgb(222, 214, 190), rough=0.9),
                 "ink": dict(color=srgb(40, 36, 34), rough=0.8), "silver": dict(color=srgb(190, 190, 194), rough=0.3, metal=1.0)}
    Writer(materials).save(os.path.join(OUT, "parcel.glb"), [Node("parcel", mesh)])


def parachute():
    """Canopy of 16 gores, its lines meeting at the origin: the parcel's top hangs 0.4 m below."""
    gores, radius, bottom = 16, 2.6, 4.4
    rows = []
    for i in range(11):
        t = i / 10
        row = []
        for k in range(gores * 4):
            a = 2 * math.pi * k / (gores * 4)
            bulge = 1 + 0.055 * abs(math.sin(a * gores / 2)) * t
            polar = math.radians(lerp(4, 96, t))
            scallop = 0.16 * abs(math.sin(a * gores / 2)) * max(0.0, t - 0.8) / 0.2
            r = radius * math.sin(polar) * bulge
            row.append((r * math.cos(a), bottom + 0.68 * radius * (math.cos(polar) + 0.10) + scallop, r * math.sin(a)))
        rows.append(row)
    colour = lambda i, j: ("white", "red")[(j // 4) % 2]
    canopy = Mesh()
    canopy.grid(rows, colour, closed=True)
    canopy.grid(rows, lambda i, j: ("white_in", "red_in")[(j // 4) % 2], closed=True, inward=True)
    lines = Mesh()
    for k in range(gores):
        lines.tube([rows[10][4 * k], mul(rows[10][4 * k], 0.02)], 0.012, "line", sides=4, lids=False)
    lines.tube([(0.0, 0.1, 0.0), (0.0, -0.05, 0.0)], 0.03, "line", sides=6)
    for x in (-0.22, 0.22):
        for z in (-0.3, 0.3):
            lines.tube([(0.0, 0.0, 0.0), (x, -0.42, z)], 0.012, "line", sides=4, lids=False)
    materials = {"white": dict(color=srgb(246, 240, 226), rough=0.8), "red": dict(color=srgb(206, 48, 34), rough=0.8),
                 "white_in": dict(color=srgb(214, 206, 190), rough=0.9), "red_in": dict(color=srgb(170, 40, 30), rough=0.9),
                 "line": dict(color=srgb(230, 224, 208), rough=0.9)}
    Writer(materials).save(os.path.join(OUT, "parachute.glb"), [Node("parachute", children=[Node("canopy", canopy), Node("lines", lines)])])


def windsock():
    """Foot of the mast at the origin. `sock` turns about y: at rest it streams toward +x; node `sock_droop` about z."""
    mast = Mesh()
    mast.tube([(0, 0, 0), (0, 6.1, 0)], [0.07, 0.045], "mast", sides=12)
    for k in range(3):
        mast.tube([(0, 2.0 + 1.4 * k, 0), (0, 2.7 + 1.4 * k, 0)], 0.075 - 0.006 * k, "red", sides=12)
    ring = Mesh()
    ring.lathe([(0.05, 0.46), (0.02, 0.48), (-0.01, 0.46), (0.02, 0.44), (0.05, 0.46)], "mast", axis=0, sides=20)
    sock = Mesh()
    for k in range(5):
        a, b = k / 5, (k + 1) / 5
        profile = [(3.6 * t, lerp(0.46, 0.22, t)) for t in (a, (a + b) / 2, b)]
        sock.lathe(profile, ("red", "white")[k % 2], axis=0, sides=20)
        rows = []
        for along, radius in profile:
            rows.append([(along, radius * math.cos(2 * math.pi * m / 20), radius * math.sin(2 * math.pi * m / 20)) for m in range(20)])
        sock.grid(rows, ("red", "white")[k % 2], closed=True, inward=True)
    materials = {"mast": dict(color=srgb(210, 210, 212), rough=0.5), "red": dict(color=srgb(222, 70, 28), rough=0.85),
                 "white": dict(color=srgb(244, 240, 230), rough=0.85)}
    Writer(materials).save(os.path.join(OUT, "windsock.glb"), [Node("windsock", mast, children=[
        Node("sock", ring, at=(0, 6.0, 0), children=[Node("sock_droop", sock)])])])


def hangar():
    """A hangar and a hut at an airfield's edge; door toward +z, foot at y = 0, 18 x 14 m."""
    mesh = Mesh()
    profile = [(9.0 * math.cos(a), 2.6 + 3.6 * math.sin(a)) for a in (math.pi * k / 16 for k in range(17))]
    outline = [(9.0, -1.0)] + profile + [(-9.0, -1.0)]
    rows = [[(x, y, z) for x, y in profile] for z in (-7.0, 7.0)]
    mesh.grid(rows, lambda i, j: ("tin", "tin_dark")[j % 2])
    for side in (-1, 1):
        corners = [(side * 9, -1, -7), (side * 9, 2.6, -7), (side * 9, 2.6, 7), (side * 9, -1, 7)]
        mesh.quad(corners if side < 0 else corners[::-1], "wall")
    for z, way in ((-7.0, -1.0), (6.95, 1.0)):
        mesh.fan([(x, y, z) for x, y in outline], "wall", (0.0, 0.0, way))
    for side in (-1, 1):
        mesh.box((side * 3.0, 1.4, 7.0), (5.7, 4.8, 0.18), "door", 0.03)
        for k in range(4):
            mesh.box((side * 3.0 - 2.1 + 1.4 * k, 1.4, 7.10), (0.10, 4.7, 0.06), "tin_dark")
    mesh.box((0, 4.9, 7.03), (5.4, 0.9, 0.12), "sign", 0.03)
    for k in range(20):  # the horn over the door
        a = 2 * math.pi * k / 20
        mesh.box((-1.9 + 0.26 * math.cos(a), 4.92 + 0.26 * math.sin(a), 7.10), (0.12, 0.12, 0.04), "ink")
    scale = 0.48 / 6
    x = -1.2
    for letter in "LUFTPOST":
        for line in livery.LETTERS[letter]:
            for a, b in zip(line, line[1:]):
                mesh.tube([(x + scale * a[0], 4.66 + scale * a[1], 7.10), (x + scale * b[0], 4.66 + scale * b[1], 7.10)], 0.04, "ink", sides=6, up=(0, 0, 1))
        x += scale * 5.3
    hut = (13.2, 0.0, 2.0)
    mesh.box(add(hut, (0, 1.0, 0)), (5.0, 4.0, 6.0), "plaster", 0.02)
    for side in (-1, 1):
        slope = [add(hut, p) for p in ((side * 2.9, 2.85, -3.4), (0.0, 4.6, -3.4), (0.0, 4.6, 3.4), (side * 2.9, 2.85, 3.4))]
        for ring in (slope, slope[::-1]):
            mesh.quad(ring, "roof")
    for z in (-3.0, 3.0):
        mesh.fan([add(hut, p) for p in ((-2.5, 3.0, z), (2.5, 3.0, z), (0.0, 4.5, z))], "plaster", (0, 0, 1 if z > 0 else -1))
    for z in (-1.6, 1.6):
        mesh.box(add(hut, (2.52, 1.7, z)), (0.06, 1.2, 1.4), "pane", 0.01)
    mesh.box(add(hut, (0.8, 1.05, 3.02)), (1.1, 2.1, 0.06), "door", 0.01)
    mesh.box(add(hut, (-1.2, 1.8, 3.02)), (1.4, 1.1, 0.06), "pane", 0.01)
    mesh.tube([add(hut, (-1.4, 3.5, -1.5)), add(hut, (-1.4, 5.2, -1.5))], 0.22, "brick", sides=4)
    materials = {"tin": dict(color=srgb(150, 156, 158), rough=0.5, metal=0.6), "tin_dark": dict(color=srgb(120, 126, 130), rough=0.5, metal=0.6),
                 "wall": dict(color=srgb(172, 64, 46), rough=0.8), "door": dict(color=srgb(236, 228, 208), rough=0.7),
                 "sign": dict(color=srgb(250, 186, 22), rough=0.6), "ink": dict(color=srgb(36, 34, 36), rough=0.7),
                 "plaster": dict(color=srgb(236, 226, 202), rough=0.9), "roof": dict(color=srgb(140, 66, 48), rough=0.9),
                 "pane": dict(color=srgb(50, 66, 78), rough=0.1), "brick": dict(color=srgb(146, 84, 66), rough=0.9)}
    Writer(materials).save(os.path.join(OUT, "hangar.glb"), [Node("hangar", mesh)])


def drop_zone():
    """Marker of a drop zone: a cross of cloth 30 m wide on the ground, a mast with a pennant. Foot at the origin."""
    cloth = Mesh()
    for turn in (0, 1):
        for half_width, y, material in ((2.2, 0.12, "white"), (1.5, 0.16, "red")):
            size = 15.0 if half_width > 2 else 14.3
            a = [(-size, y, -half_width), (-size, y, half_width), (size, y, half_width), (size, y, -half_width)]
            if turn:
                a = [(p[2], p[1] + 0.01, -p[0]) for p in a]
            cloth.quad(a, material)
    mast = Mesh()
    mast.tube([(0, -1.0, 0), (0, 9.0, 0)], [0.09, 0.05], "mast", sides=10)
    mast.ellipsoid((0, 9.05, 0), (0.16, 0.16, 0.16), "gold", sides=12)
    pennant = Mesh()
    for side in (0, 1):
        tip, top, low = (3.2, -0.65, 0.0), (0.0, 0.0, 0.0), (0.0, -1.3, 0.0)
        ring = [top, low, tip] if side else [tip, low, top]
        normal = (0.0, 0.0, 1.0 if side else -1.0)
        pennant.triangle("gold", [(p, normal, (0.0, 0.0)) for p in ring])
    materials = {"white": dict(color=srgb(250, 248, 240), rough=0.9), "red": dict(color=srgb(206, 36, 26), rough=0.9),
                 "mast": dict(color=srgb(220, 220, 222), rough=0.5), "gold": dict(color=srgb(252, 190, 20), rough=0.6)}
    Writer(materials).save(os.path.join(OUT, "drop_zone.glb"), [Node("drop_zone", children=[
        Node("cloth", cloth), Node("mast", mast, children=[Node("pennant", pennant, at=(0, 8.8, 0))])])])


def main():
    os.makedirs(OUT, exist_ok=True)
    for form in (MAIL, FREIGHT):
        plane(form)
    for make in (parcel, parachute, windsock, hangar, drop_zone):
        make()


if __name__ == "__main__":
    main()
