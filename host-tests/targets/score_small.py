#!/usr/bin/env python3
"""What the small sizes of lib/ident cost: the last samples of simulated loops.

    score_small.py BUILD SEEDS [FIRST_SEED]
    score_small.py BUILD SEEDS --check     fails where the least one is far off, for the tests

Each loop goes through a monitor with the small sizes and through one with the room of the
others, windows of 512 samples, and through the least one, a window of 384; prints a table of
all. BUILD is the host's build folder; seeds from FIRST_SEED
on, 1000 unless told.
"""
import json
import pathlib
import statistics
import subprocess
import sys

import board

MONITORS = {"room of the others, 512": "replay_roomy", "small sizes, 512": "replay_small",
            "least, 384": "replay_least"}
STICKING = ("stiction", "stiction-one-sided", "stiction-mixed", "stiction-integrating",
            "stiction-setpoint")
FINE = ("external-sinusoid", "tight-tuning", "random-load", "load-and-noise", "healthy-positioner")
BUDGET = 1000
# Of the least one on a few loops, far from what it does on many: found at least, false at
# most, median error of the stick band at most, %.
LEAST = "least, 384"
FEWEST_FOUND, MOST_FALSE, MOST_ERROR = 70, 5, 3


def errors_of_bands(figures, truth):
    """Relative error of each stick band that is known and true."""
    for stroke in ("ascending", "descending"):
        value, true = figures[f"stick_band_{stroke}"], truth["stick_band"][stroke]
        if value != "-" and true > 0:
            yield abs(float(value) - true) / true


def score(build, scenarios, seeds):
    """Monitor -> the verdicts and the errors of the bands, over all loops."""
    verdicts = {name: [] for name in MONITORS}
    errors = {name: [] for name in MONITORS}
    stickband = build / "bin" / "stickband"
    with board.folder() as folder:
        truth_file = pathlib.Path(folder) / "truth.json"
        for scenario in scenarios:
            for seed in seeds:
                packed = board.recording(stickband, scenario, seed, folder)
                subprocess.run([stickband, "simulate", scenario, "--seed", str(seed), "-o",
                                pathlib.Path(folder) / "again.csv", "--truth", truth_file],
                               check=True, capture_output=True)
                truth = json.loads(truth_file.read_text())
                for name, program in MONITORS.items():
                    figures = board.on_host(build / "bin" / program, "f32", "last", BUDGET,
                                            packed)
                    verdicts[name].append(figures["verdict"])
                    errors[name].extend(errors_of_bands(figures, truth))
    return verdicts, errors


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    checks = arguments[2:] == ["--check"]
    if checks:
        arguments = arguments[:2]
    build, count = pathlib.Path(arguments[0]), int(arguments[1])
    first = int(arguments[2]) if len(arguments) > 2 else 1000
    seeds = range(first, first + count)
    found, errors = score(build, STICKING, seeds)
    false, _ = score(build, FINE, seeds)
    share = lambda list_of: 100 * list_of.count("stiction") / len(list_of)
    rows = {
        f"found, % of {len(STICKING) * count}": lambda name: share(found[name]),
        f"false, % of {len(FINE) * count}": lambda name: share(false[name]),
        "stick band, median error, %": lambda name: 100 * statistics.median(errors[name]),
        "stick band, 90th percentile, %":
            lambda name: 100 * statistics.quantiles(errors[name], n=10)[-1],
    }
    print("| sizes, samples | " + " | ".join(MONITORS) + " |")
    print("|:--|" + "--:|" * len(MONITORS))
    for title, figure in rows.items():
        print(f"| {title} | " + " | ".join(f"{figure(name):.1f}" for name in MONITORS) + " |")
    far_off = (share(found[LEAST]) < FEWEST_FOUND or share(false[LEAST]) > MOST_FALSE or
               100 * statistics.median(errors[LEAST]) > MOST_ERROR)
    return 1 if checks and far_off else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
