#!/usr/bin/env python3
"""Does a verdict stand when the same recording is cut, thinned or a little noisier?

usage: stability.py STICKBAND [-v] [DATA]     DATA: default ../shared/data beside the checkout
Each labelled recording is judged as it is and in variants that change nothing about its valve:
other units, the first and the last four fifths, every second sample, white noise of 2 % of y's
deviation. Prints, of each set and variant, how many sticking ones are found and how many others
are blamed, and how many verdicts are the opposite of that on the whole; -v: each recording.
"""
import csv
import json
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

SETS = ("isdb", "plant", "sacac")
VARIANTS = ("whole", "units", "first", "last", "thinned", "noisy")


def labels_of(folder):
    """Recordings with a label: name and whether the valve sticks."""
    told = json.loads((folder / "labels.json").read_text())
    for name, label in sorted(told.items()):
        sticks = label.get("stiction")
        if sticks is None and "cause" in label:
            sticks = label["cause"] == "stiction"
        if sticks is not None:
            yield name, bool(sticks)


def variant(rows, header, kind, seed):
    """`rows` of numbers, changed as `kind` says."""
    n = len(rows)
    if kind == "first":
        return rows[: n * 4 // 5]
    if kind == "last":
        return rows[n - n * 4 // 5:]
    if kind == "thinned":
        return rows[::2]
    u, y = header.index("u"), header.index("y")
    sp = header.index("sp") if "sp" in header else None
    out = [list(row) for row in rows]
    draw = random.Random(seed)
    noise = 0.02 * statistics.pstdev(row[y] for row in rows)
    for row in out:
        if kind == "units":
            row[u] = 3.7 * row[u] - 11
            for column in (y, sp):
                if column is not None:
                    row[column] = 0.29 * row[column] + 5
        elif kind == "noisy":
            row[y] += draw.gauss(0, noise)
    return out


def judged(program, path):
    run = subprocess.run([program, "identify", str(path), "--json"],
                         capture_output=True, text=True, check=False)
    return json.loads(run.stdout)["verdict"] if run.stdout else "none"


def main():
    arguments = [a for a in sys.argv[1:] if a != "-v"]
    if not arguments:
        sys.exit(__doc__)
    program = arguments[0]
    root = pathlib.Path(__file__).resolve().parents[2]
    data = pathlib.Path(arguments[1]) if len(arguments) > 1 else root.parent / "shared/data"
    if not data.is_dir():
        print(f"skipped: no recordings in {data}")
        return
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(2) as pool:
        for name in SETS:
            verdicts = {}
            jobs = []
            for recording, sticks in labels_of(data / name):
                with open(data / name / f"{recording}.csv", encoding="utf-8-sig") as file:
                    reader = csv.reader(file)
                    header = [cell.strip().lower() for cell in next(reader)]
                    rows = [[float(cell) for cell in row] for row in reader]
                for kind in VARIANTS:
                    path = pathlib.Path(scratch) / f"{name}-{recording}-{kind}.csv"
                    with open(path, "w", newline="", encoding="utf-8") as file:
                        writer = csv.writer(file)
                        writer.writerow(header)
                        writer.writerows(variant(rows, header, kind, recording))
                    jobs.append((recording, sticks, kind, pool.submit(judged, program, path)))
            for recording, sticks, kind, job in jobs:
                verdicts.setdefault((recording, sticks), {})[kind] = job.result()
            report(name, verdicts, "-v" in sys.argv)


def report(name, verdicts, each):
    sticking = [v for (_, sticks), v in verdicts.items() if sticks]
    others = [v for (_, sticks), v in verdicts.items() if not sticks]
    print(f"{name}: {len(sticking)} that stick, {len(others)} others")
    print(f"  {'':9} {'found':>6} {'blamed':>7} {'opposite of the whole':>22}")
    for kind in VARIANTS:
        found = sum(v[kind] == "stiction" for v in sticking)
        blamed = sum(v[kind] == "stiction" for v in others)
        opposite = sum({v[kind], v["whole"]} == {"stiction", "no_stiction"}
                       for v in sticking + others)
        print(f"  {kind:9} {found:6} {blamed:7} {opposite:22}")
    if each:
        for (recording, sticks), told in verdicts.items():
            print(f"    {recording:36} {'sticks' if sticks else 'other':7}",
                  *(told[kind][:4] for kind in VARIANTS))


if __name__ == "__main__":
    main()
