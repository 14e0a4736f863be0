#!/usr/bin/env python3
"""Makes assets/sounds/*.wav from formulas: 16 bit, mono. Run it after a change and check the products in.

Loops are periodic by construction: every partial has a whole number of cycles in the file, and noise is made of such
partials or filtered around the ring, so that the last sample runs into the first. Deterministic.
"""
import array
import math
import os
import random
import wave

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "sounds")
RATE = 22050
TAU = 2 * math.pi


def save(name, samples, peak):
    """Without a mean (for loops and shots alike), scaled to `peak`."""
    mean = sum(samples) / len(samples)
    samples = [s - mean for s in samples]
    top = max(abs(s) for s in samples)
    data = array.array("h", (round(32767 * peak * s / top) for s in samples))
    with wave.open(os.path.join(OUT, name + ".wav"), "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(RATE)
        out.writeframes(data.tobytes())


def white(count, seed):
    source = random.Random(seed)
    return [source.uniform(-1, 1) for _ in range(count)]


def low_pass(samples, hertz, ring):
    """One pole; on a ring it runs round twice, so that its state at the seam is the same."""
    share = 1 - math.exp(-TAU * hertz / RATE)
    value, out = 0.0, list(samples)
    for _ in range(2 if ring else 1):
        for i, s in enumerate(samples):
            value += share * (s - value)
            out[i] = value
    return out


def high_pass(samples, hertz, ring):
    return [s - l for s, l in zip(samples, low_pass(samples, hertz, ring))]


def band(samples, low, high, ring):
    return high_pass(low_pass(low_pass(samples, high, ring), high, ring), low, ring)


def resonance(samples, hertz, width, ring):
    """Two poles around `hertz`."""
    r = math.exp(-math.pi * width / RATE)
    a, b = 2 * r * math.cos(TAU * hertz / RATE), -r * r
    y1 = y2 = 0.0
    out = list(samples)
    for _ in range(2 if ring else 1):
        for i, s in enumerate(samples):
            y = (1 - r) * s + a * y1 + b * y2
            out[i], y2, y1 = y, y1, y
    return out


def normal(samples):
    """To an effective value of 1."""
    power = math.sqrt(sum(s * s for s in samples) / len(samples))
    return [s / power for s in samples]


def mix(*parts):
    return [sum(share * layer[i] for share, layer in parts) for i in range(len(parts[0][1]))]


def engine():
    """A flat four at 2400 rpm: 80 firings a second, each cylinder with a voice of its own. 1 s."""
    count, firings = RATE, 80
    pulses = [0.0] * count
    voices = [(1.0, 0.0), (0.82, 0.012), (0.94, -0.008), (0.76, 0.005)]  # loudness, how early (share of a period)
    source = random.Random(4)
    for k in range(firings):
        loud, early = voices[k % 4]
        loud *= 1 + 0.10 * source.uniform(-1, 1)
        start = (k + early) / firings * count
        for i in range(int(0.020 * RATE)):  # a burst that dies within 20 ms
            t = i / RATE
            pulses[int(start + i) % count] += loud * math.exp(-t / 0.0034) * math.sin(TAU * 118 * t) * (1 - math.exp(-t / 0.0005))
    rumble = normal(resonance(pulses, 92, 60, ring=True))
    body = normal(resonance(pulses, 236, 130, ring=True))
    bark = normal(band(pulses, 380, 1500, ring=True))
    breath = [n * (0.55 + 0.45 * math.cos(TAU * firings * i / count)) for i, n in enumerate(band(white(count, 9), 500, 2200, ring=True))]
    save("engine", mix((1.0, rumble), (0.62, body), (0.34, bark), (0.10, normal(breath))), 0.86)


def propeller():
    """Two blades at 2400 rpm: 80 passes a second, with the tearing of the tips. 1 s."""
    count, passes = RATE, 80
    tone = [sum(math.sin(TAU * passes * h * i / count + 0.7 * h * h) / h ** 1.6 for h in range(1, 22)) for i in range(count)]
    tear = [n * max(0.0, math.cos(TAU * passes * i / count)) ** 3 for i, n in enumerate(band(white(count, 21), 700, 4200, ring=True))]
    save("propeller", mix((1.0, normal(tone)), (0.42, normal(tear))), 0.80)


def wind():
    """Air over the skin: broad noise that comes and goes. 3 s."""
    count = 3 * RATE
    noise = white(count, 33)
    low, middle, high = (normal(band(noise, a, b, ring=True)) for a, b in ((60, 260), (250, 900), (900, 3600)))
    sway = lambda i, turns, phase: 1 + 0.28 * math.sin(TAU * turns * i / count + phase)
    save("wind", [low[i] * sway(i, 2, 0.4) + 0.62 * middle[i] * sway(i, 3, 2.0) + 0.30 * high[i] * sway(i, 5, 4.1) for i in range(count)], 0.80)


def strike(ring, start, loud, pitch, fade, seconds):
    """Adds a tone that dies away, `fade` s to 1/e, to a loop."""
    for i in range(int(seconds * RATE)):
        ring[(start + i) % len(ring)] += loud * math.exp(-i / RATE / fade) * math.sin(TAU * pitch * i / RATE)


def rain():
    """A hiss and single drops on metal and glass. 3 s."""
    count = 3 * RATE
    hiss = normal(band(white(count, 51), 1400, 7000, ring=True))
    drops = [0.0] * count
    source = random.Random(52)
    for _ in range(420):
        start, pitch, loud = source.randrange(count), source.uniform(900, 3800), source.random() ** 2
        fade = source.uniform(0.004, 0.014)
        strike(drops, start, loud, pitch, fade, 5 * fade)
    save("rain", mix((1.0, hiss), (0.75, normal(drops))), 0.80)


def stall():
    """The reed of a stall horn: a nasal tone that beats. 1 s."""
    count = RATE
    wave_at = lambda i, pitch: sum(math.sin(TAU * pitch * h * i / count) / h for h in range(1, 12)) * 0.6
    tone = [wave_at(i, 466) + 0.7 * wave_at(i, 472) for i in range(count)]
    save("stall", mix((1.0, normal(resonance(tone, 1400, 900, ring=True))), (0.5, normal(tone))), 0.62)


def wheels():
    """Balloon tyres over ground. 2 s."""
    count = 2 * RATE
    rumble = normal(band(white(count, 71), 30, 170, ring=True))
    grit = normal(band(white(count, 72), 300, 1600, ring=True))
    knock = [0.0] * count
    source = random.Random(73)
    for _ in range(26):
        start, loud = source.randrange(count), source.uniform(0.3, 1)
        strike(knock, start, loud, 74, 0.03, 0.12)
    save("wheels", mix((1.0, rumble), (0.25, grit), (0.6, normal(knock))), 0.82)


def buffet():
    """Flow that has left the wing beats on the tail: thumps of uneven strength in a low roar. 2 s."""
    count = 2 * RATE
    roar = normal(band(white(count, 141), 25, 140, ring=True))
    thump = [0.0] * count
    source = random.Random(142)
    for k in range(22):
        start, loud = int((k + source.uniform(-0.25, 0.25)) / 22 * count), source.uniform(0.4, 1)
        strike(thump, start, loud, 52, 0.035, 0.16)
    save("buffet", mix((0.8, roar), (1.0, normal(thump))), 0.85)


def climb():
    """The tone of the variometer: a soft reed, 500 cycles. 1 s."""
    count = RATE
    save("climb", [sum(math.sin(TAU * 500 * h * i / count) / h ** 2.2 for h in range(1, 6)) for i in range(count)], 0.6)


def shot(seconds, at, seed=0):
    source = random.Random(seed)
    count = int(seconds * RATE)
    samples = [at(i / RATE, source) for i in range(count)]
    fade = int(0.02 * RATE)
    return [s * min(1.0, (count - i) / fade, i / 24) for i, s in enumerate(samples)]


def chute():
    """Cloth rushes out and snaps open."""
    count = int(1.3 * RATE)
    noise = white(count, 81)
    rush = normal(band(noise, 400, 3000, ring=False))
    flap = normal(band(noise, 60, 500, ring=False))
    out = []
    for i in range(count):
        t = i / RATE
        swell = min(1.0, t / 0.30) ** 2 * math.exp(-max(0.0, t - 0.34) / 0.06)
        snap = math.exp(-max(0.0, t - 0.36) / 0.10) if t > 0.36 else 0.0
        flutter = math.exp(-max(0.0, t - 0.45) / 0.35) * (0.5 + 0.5 * math.sin(TAU * 17 * t)) if t > 0.45 else 0.0
        out.append(0.55 * swell * rush[i] + 1.3 * snap * flap[i] + 0.28 * flutter * flap[i])
    save("chute", [s * min(1.0, (count - i) / 900) for i, s in enumerate(out)], 0.88)


def touchdown():
    """Tyres chirp, the legs take the weight."""
    noise = band(white(int(0.7 * RATE), 91), 700, 3600, ring=False)
    source = iter(normal(noise))
    save("touchdown", shot(0.7, lambda t, _: 1.2 * math.exp(-t / 0.07) * math.sin(TAU * (62 + 30 * math.exp(-t / 0.04)) * t)
                           + 0.22 * math.exp(-t / 0.09) * next(source) + 0.35 * math.exp(-((t - 0.16) / 0.03) ** 2) * math.sin(TAU * 84 * t)), 0.9)


def parcel_landed():
    """Wood on earth."""
    source = iter(normal(band(white(int(0.5 * RATE), 95), 200, 1200, ring=False)))
    save("parcel_landed", shot(0.5, lambda t, _: math.exp(-t / 0.05) * math.sin(TAU * 96 * t) + 0.5 * math.exp(-t / 0.03) * math.sin(TAU * 233 * t)
                               + 0.3 * math.exp(-t / 0.04) * next(source)), 0.85)


def horn_note(t, start, seconds, pitch):
    """A post horn: brass that opens as it is blown."""
    t -= start
    if t < 0 or t > seconds + 0.25:
        return 0.0
    swell = min(1.0, t / 0.035) * (1.0 if t < seconds else math.exp(-(t - seconds) / 0.06))
    bright = 0.45 + 0.36 * min(1.0, t / 0.09)
    vibrato = 0.004 * math.sin(TAU * 5.2 * t) * min(1.0, t / 0.3)
    return swell * sum(bright ** h * math.sin(TAU * pitch * h * (t + vibrato / TAU) + 0.2 * h) / h ** 0.8 for h in range(1, 12))


def delivery():
    """The post horn's call: the signal of an arrival, on the natural notes of a horn in F."""
    f = 349.23
    notes = [(0.00, 0.13, f * 3 / 2), (0.16, 0.13, f * 3 / 2), (0.32, 0.20, f * 2), (0.56, 0.13, f * 3 / 2), (0.72, 0.62, f * 2)]
    save("delivery", shot(1.7, lambda t, _: sum(horn_note(t, *n) for n in notes)), 0.72)


def lost():
    """The same horn, sorry."""
    f = 349.23
    save("lost", shot(1.2, lambda t, _: horn_note(t, 0.0, 0.24, f) + horn_note(t, 0.32, 0.55, f * 3 / 4)), 0.62)


def crash():
    source = iter(normal(band(white(int(1.8 * RATE), 101), 80, 2600, ring=False)))
    noise = random.Random(102)
    bits = [(noise.uniform(0.03, 0.9), noise.uniform(400, 2600), noise.uniform(0.1, 0.5)) for _ in range(26)]

    def at(t, _):
        metal = sum(loud * math.exp(-(t - s) / 0.05) * math.sin(TAU * pitch * (t - s)) for s, pitch, loud in bits if t >= s)
        return 1.6 * math.exp(-t / 0.22) * next(source) + 1.4 * math.exp(-t / 0.12) * math.sin(TAU * 48 * t) + 0.6 * metal
    save("crash", shot(1.8, at), 0.92)


def release():
    """The hatch: a latch and a rush of air."""
    source = iter(normal(band(white(int(0.6 * RATE), 111), 200, 1800, ring=False)))
    save("release", shot(0.6, lambda t, _: math.exp(-t / 0.012) * math.sin(TAU * 640 * t) + 0.7 * (math.exp(-(t - 0.09) / 0.02) * math.sin(TAU * 310 * t) if t > 0.09 else 0)
                         + 0.30 * min(1.0, t / 0.1) * math.exp(-t / 0.16) * next(source)), 0.75)


def click():
    save("click", shot(0.06, lambda t, _: math.exp(-t / 0.005) * math.sin(TAU * 1900 * t) + 0.6 * math.exp(-t / 0.008) * math.sin(TAU * 820 * t)), 0.5)


def flaps():
    """An electric motor starts and stops."""
    save("flaps", shot(0.9, lambda t, r: min(1.0, t / 0.08) * min(1.0, (0.9 - t) / 0.15) *
                       (sum(math.sin(TAU * 108 * h * t) / h for h in range(1, 9)) + 0.5 * math.sin(TAU * 1330 * t) * (1 + 0.3 * math.sin(TAU * 27 * t)) + 0.2 * r.uniform(-1, 1)), 121), 0.45)


def thunder():
    count = 5 * RATE
    noise = white(count, 131)
    deep, crack = normal(band(noise, 20, 120, ring=False)), normal(band(noise, 120, 900, ring=False))
    source = random.Random(132)
    rolls = [(source.uniform(0.0, 2.6), source.uniform(0.15, 0.7), source.uniform(0.3, 1.0)) for _ in range(9)] + [(0.05, 0.25, 1.2)]
    out = []
    for i in range(count):
        t = i / RATE
        roll = sum(loud * min(1.0, (t - s) / 0.03) * math.exp(-(t - s) / width) for s, width, loud in rolls if t >= s)
        out.append((roll + 0.25 * math.exp(-t / 1.4)) * deep[i] + 0.5 * math.exp(-t / 0.5) * roll * crack[i])
    save("thunder", [s * min(1.0, (count - i) / (0.6 * RATE), i / 60) for i, s in enumerate(out)], 0.92)


def main():
    os.makedirs(OUT, exist_ok=True)
    for make in (engine, propeller, wind, rain, stall, wheels, buffet, climb, chute, touchdown, parcel_landed, delivery, lost, crash, release, click, flaps, thunder):
        make()


if __name__ == "__main__":
    main()
