#!/usr/bin/env python3
"""Simulated step tests by hand: whether a stem that sticks is found, and what is excluded.

    step_tests.py STICKBAND [TESTS [FIRST_SEED]]

Four to twelve moves of u, a process with one lag or two, linear or curved, even or slower
upwards, noise of four colours, some with a drift. Half of the valves stick: bands of 8 to 90 %
of a usual move, play to nearly pure stiction, a quarter of them upwards only. Counted are what
is told, and the sticking valves whose band is wider than what the answer excludes.
"""
import collections
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile

stickband = sys.argv[1]
tests = int(sys.argv[2]) if len(sys.argv) > 2 else 400
first = int(sys.argv[3]) if len(sys.argv) > 3 else 1


def moved_by_hand(chance):
    """u of every sample, its usual move, and the samples between two moves, about."""
    moves, between = chance.randint(4, 12), chance.randint(55, 160)
    count = (moves + 1) * between
    at = sorted(chance.sample(range(between // 2, count - between // 3), moves))
    at = [k for i, k in enumerate(at) if i == 0 or k - at[i - 1] > 6]
    level, u = 50.0, []
    steps = []
    for begin, end in zip([0] + at, at + [count]):
        u += [level] * (end - begin)
        step = chance.uniform(4, 14) * chance.choice((1, -1))
        step = step if 20 < level + step < 80 else -step
        steps.append(abs(step))
        level += step
    return u, statistics.median(steps[:-1]), between


def stem(u, bands, jumps, chance):
    """Positions of a stem with a stick band and a slip jump upwards and downwards."""
    lag = [max(band - jump, 0) / 2 for band, jump in zip(bands, jumps)]
    breaks = [a + jump for a, jump in zip(lag, jumps)]
    x, way, out = u[0] - chance.uniform(-0.5, 0.5) * max(bands), 0, []
    for value in u:
        ahead = value - x
        if way > 0 and ahead > lag[0] or ahead > breaks[0]:
            x, way = value - lag[0], 1
        elif way < 0 and ahead < -lag[1] or ahead < -breaks[1]:
            x, way = value + lag[1], -1
        elif way > 0 and ahead < lag[0] or way < 0 and ahead > -lag[1]:
            way = 0
        out.append(x)
    return out


def answered(v, between, chance):
    """y of every sample."""
    curve = chance.choice((lambda z: z, lambda z: z, lambda z: math.sqrt(max(z, 0) + 0.05),
                           lambda z: math.exp(1.2 * z)))
    z = [curve((value - 20) / 60) for value in v]
    lag = chance.uniform(3, 0.8 * between)
    second = chance.choice((0, 0, 0.3)) * lag
    dead, slower = chance.randint(0, 7), chance.choice((1, 1, 1.4))
    a = b = z[0]
    y = []
    for value in ([z[0]] * dead + z)[:len(z)]:
        a += (1 - math.exp(-1 / (lag * (slower if value > a else 1)))) * (value - a)
        b = a if second == 0 else b + (1 - math.exp(-1 / second)) * (a - b)
        y.append(b)
    scale = statistics.pstdev(y)
    colour, noise = chance.choice((0, 0.7, 0.95, 0.99)), chance.choice((0.02, 0.05, 0.12))
    drift, e = chance.choice((0, 0, 0.3)), 0
    for k, value in enumerate(y):
        e = colour * e + math.sqrt(1 - colour * colour) * chance.gauss(0, 1)
        y[k] = 100 * (value + scale * (noise * e + drift * (k / len(y) - 0.5)
                                       + 0.01 * chance.gauss(0, 1)))
    return y


def judged(seed):
    chance = random.Random(seed)
    u, move, between = moved_by_hand(chance)
    band, v = 0, u
    if chance.random() < 0.5:
        band = chance.uniform(0.08, 0.9) * move
        jump = band * chance.choice((0, 0.2, 0.5, 0.8))
        up_only = chance.random() < 0.25
        v = stem(u, (band, 0 if up_only else band), (jump, 0 if up_only else jump), chance)
    y = answered(v, between, chance)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "test.csv"
        file.write_text("time,u,y\n" + "".join(f"{k},{a:.5g},{b:.5g}\n"
                                               for k, (a, b) in enumerate(zip(u, y))))
        answer = json.loads(subprocess.run([stickband, "identify", str(file), "--json"],
                                           capture_output=True, text=True).stdout)
    excluded = answer["detectable_band"]["value"]
    healthy = answer["verdict"] == "no_stiction"
    return answer["verdict"], band / move, bool(healthy and excluded and excluded < band)


told = collections.defaultdict(collections.Counter)
wrong = 0
for seed in range(first, first + tests):
    verdict, share, beyond = judged(seed)
    kind = "healthy" if share == 0 else "band below half a move" if share < 0.5 else \
        "band of half a move or more"
    told[kind][verdict] += 1
    wrong += beyond
for kind, verdicts in sorted(told.items(), reverse=True):
    print(f"{kind}, {sum(verdicts.values())}: "
          + ", ".join(f"{name} {count}" for name, count in verdicts.most_common()))
print(f"told not to stick above less than their band: {wrong}")
