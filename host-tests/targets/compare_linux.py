#!/usr/bin/env python3
"""A Linux target under user-mode emulation must say of a recording what the host says.

    compare_linux.py EMULATOR ROOT TARGET_REPLAY HOST_REPLAY STICKBAND SCENARIO SEED

In float32 the same to the last digit; in float64, where exp, log and sin are those of each
target's libm, the same words and counts, numbers within 0.1 %.
"""
import shutil
import sys

import board

TOLERANCE = {"f32": 0, "f64": 1e-3}
BUDGET = 100


def apart(one, other, tolerance):
    try:
        return abs(float(one) - float(other)) > tolerance * abs(float(other))
    except ValueError:
        return one != other


def main(arguments):
    if len(arguments) != 7:
        print(__doc__, file=sys.stderr)
        return 2
    emulator, root, target, host, stickband, scenario, seed = arguments
    board.skip_unless(emulator, target)
    failures = 0
    with board.folder() as folder:
        packed = board.recording(stickband, scenario, seed, folder)
        for precision in ("f32", "f64"):
            here = board.on_host(host, precision, "last", BUDGET, packed)
            there = board.run([shutil.which(emulator), "-L", root, target, precision, "last",
                               str(BUDGET), str(packed)])
            for name in here:
                differs = name != "ram_bytes" and apart(there[name], here[name],
                                                        TOLERANCE[precision])
                failures += differs
                print(f"{precision} {name}: target {there[name]}, host {here[name]}"
                      f"{'  DIFFERS' if differs else ''}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
