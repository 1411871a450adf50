#!/usr/bin/env python3
"""A recording for the replay programs: CSV with columns t, u, y and perhaps sp to binary.

    pack_recording.py RECORDING.csv OUT

OUT: "SBR1", number of samples (u32), period in us (i64), then u, y, sp of each sample (f32),
sp not a number where it is unknown; little-endian.
"""
import csv
import math
import struct
import sys


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    with open(arguments[0], newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if len(rows) < 2 or not {"t", "u", "y"} <= rows[0].keys():
        print(f"{arguments[0]}: expected columns t, u, y and two samples or more",
              file=sys.stderr)
        return 3
    times = [float(row["t"]) for row in rows]
    period_us = round((times[-1] - times[0]) / (len(times) - 1) * 1e6)
    with open(arguments[1], "wb") as out:
        out.write(struct.pack("<4sIq", b"SBR1", len(rows), period_us))
        for row in rows:
            sp = row.get("sp") or ""
            out.write(struct.pack("<3f", float(row["u"]), float(row["y"]),
                                  float(sp) if sp else math.nan))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
