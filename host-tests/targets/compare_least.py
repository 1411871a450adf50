#!/usr/bin/env python3
"""What the least configuration leaves out decides nothing: the same answers.

    compare_least.py REPLAY_SMALL REPLAY_LEAST STICKBAND SCENARIO...
"""
import sys

import board

OWN = {"slices", "ram_bytes"}  # of each configuration
BUDGET = 1000


def main(small, least, stickband, *scenarios):
    differing = 0
    with board.folder() as folder:
        for scenario in scenarios:
            packed = board.recording(stickband, scenario, 1, folder)
            found = [{name: value for name, value in
                      board.on_host(program, "f32", "last", BUDGET, packed).items()
                      if name not in OWN} for program in (small, least)]
            differing += found[0] != found[1]
            print(f"{scenario}: {found[0]['verdict']}, "
                  f"{'the same' if found[0] == found[1] else 'not the same'}")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
