#!/usr/bin/env python3
"""The board must say of a recording what the host says.

    compare_replay.py IMAGE REPLAY_HOST STICKBAND SCENARIO SEED [APART]

In float32 the same to the last digit. In float64 the same verdict and the same quantities
known, stick bands within APART, 0.01 unless told.
"""
import sys

import board

BANDS = ("stick_band_ascending", "stick_band_descending")
SAME = ("verdict", "window_samples", "evaluations", "raised")
BUDGET = 100
APART = 0.01


def apart(one, other, most):
    """Whether two bands differ by more than that share, or only one is known."""
    if "-" in (one, other):
        return one != other
    return abs(float(one) - float(other)) > most * float(other)


def main(arguments):
    if len(arguments) not in (5, 6):
        print(__doc__, file=sys.stderr)
        return 2
    image, replay_host, stickband, scenario, seed = arguments[:5]
    most = float(arguments[5]) if len(arguments) > 5 else APART
    board.skip_unless("qemu-system-arm", image)
    with board.folder() as folder:
        packed = board.recording(stickband, scenario, seed, folder)
        there = board.on_board(image, "replay", "last", BUDGET, packed)
        here = {precision: board.on_host(replay_host, precision, "last", BUDGET, packed)
                for precision in ("f32", "f64")}
    single, double = here["f32"], here["f64"]
    wrong = {name for name in single if name != "ram_bytes" and there[name] != single[name]}
    wrong |= {name for name in SAME if there[name] != double[name]}
    wrong |= {name for name in BANDS if apart(there[name], double[name], most)}
    for name in single:
        print(f"{name}: board {there[name]}, host float32 {single[name]}, "
              f"float64 {double[name]}"
              f"{'  DIFFERS' if name in wrong else ''}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
