#!/usr/bin/env python3
"""The recordings of the data folder as one plant: how a screening ranks the loops whose
valves stick above the others.

    screen_recordings.py STICKBAND [DATA]

Prints the ranking and the area under its curve (1: every sticking loop above every other).
Exits with 77 where the recordings are absent.
"""
import json
import pathlib
import subprocess
import sys

stickband = sys.argv[1]
here = pathlib.Path(__file__).resolve()
data = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else here.parents[3] / "shared" / "data")
if not (data / "isdb" / "labels.json").exists():
    print(f"screen_recordings: skipped: no recordings in {data}")
    sys.exit(77)


def labels(folder):
    return json.loads((data / folder / "labels.json").read_text())


truth = {}
for name, label in labels("isdb").items():
    if label.get("standard_set") and label.get("stiction") is not None:
        truth["isdb", name] = label["stiction"]
for name, label in labels("plant").items():
    truth["plant", label["loop"]] = label["stiction"]
for name, label in labels("sacac").items():
    truth["sacac", name] = label["cause"] == "stiction"

out = subprocess.run([stickband, "screen", *(str(data / f) for f in ("isdb", "plant", "sacac")),
                      "--json"], capture_output=True, text=True, check=True).stdout
ranked = []
for line in out.splitlines():
    loop = json.loads(line)
    folder = pathlib.Path(loop["files"][0]).parent.name
    key = folder, loop["loop"].split("/")[-1]
    if key in truth and loop["error"] is None:
        ranked.append((loop["cost"], truth[key], key, loop))
ranked.sort(key=lambda r: -r[0])
missing = set(truth) - {r[2] for r in ranked}
for cost, sticks, key, loop in ranked:
    nats, stem = loop["evidence"]["nats"], loop["evidence"]["stem_nats"]
    print(f"{cost:5.1f}  {'sticks' if sticks else 'other ':6}  {loop['verdict']:11}  "
          f"{'–' if nats is None else round(nats):>5}  {'–' if stem is None else round(stem):>5}  "
          f"{loop['oscillating_share']:.2f}  {'/'.join(key)}")
if missing:
    print("not ranked:", ", ".join("/".join(key) for key in sorted(missing)))
sticking = [r[0] for r in ranked if r[1]]
others = [r[0] for r in ranked if not r[1]]
above = sum((s > o) + 0.5 * (s == o) for s in sticking for o in others)
print(f"{len(sticking)} sticking, {len(others)} other loops: "
      f"AUC {above / (len(sticking) * len(others)):.3f}")
