#!/usr/bin/env python3
"""The board must say of a recording what the host says, in float32 and in float64.

    compare_replay.py IMAGE REPLAY_HOST STICKBAND SCENARIO SEED [APART]

Same verdict and the same quantities known, stick bands within APART of the host's, 0.01
unless told.
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
    wrong = {name for name in SAME for host in here.values() if there[name] != host[name]}
    wrong |= {name for name in BANDS for host in here.values()
              if apart(there[name], host[name], most)}
    for name in (*SAME, *BANDS):
        print(f"{name}: board {there[name]}, host float32 {here['f32'][name]}, "
              f"float64 {here['f64'][name]}"
              f"{'  DIFFERS' if name in wrong else ''}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
