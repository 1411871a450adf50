#!/usr/bin/env python3
"""Simulated plants: whether the valve that shakes its neighbours comes first.

    screen_plants.py STICKBAND [PLANTS [FIRST_SEED]]

Each plant has 20 loops. In half of them one valve sticks and shakes five neighbours: counted is
whether it leads the group that it is in. In the others all valves follow: counted are groups.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

stickband = sys.argv[1]
plants = int(sys.argv[2]) if len(sys.argv) > 2 else 20
first = int(sys.argv[3]) if len(sys.argv) > 3 else 1


def screened(seed, *options):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([stickband, "simulate", "plant", "--loops", "20", "--seed", str(seed),
                        *options, "-o", folder], check=True, capture_output=True)
        truth = json.loads((pathlib.Path(folder) / "truth.json").read_text())["loops"]
        out = subprocess.run([stickband, "screen", folder, "--json"], check=True,
                             capture_output=True, text=True).stdout
    return truth, [json.loads(line) for line in out.splitlines()]


def sticking_plant(seed):
    truth, loops = screened(seed)
    valve = next(t["loop"] for t in truth if t["kind"] == "stiction")
    shaken = {t["loop"] for t in truth if t["leader"] == valve}
    by_name = {loop["loop"]: loop for loop in loops}
    group = by_name[valve]["group"]
    members = {loop["loop"] for loop in loops if group and loop["group"] == group}
    leader = next((loop["loop"] for loop in loops if loop["group"] == group and loop["leads"]),
                  None) if group else None
    said = "" if leader == valve and by_name[valve]["group_is"] == "valve" else \
        f"  led by {leader or 'none'}" + (f" ({by_name[leader]['group_is']})" if leader else "")
    print(f"seed {seed}: {valve} {by_name[valve]['verdict']}, "
          f"{len(members & shaken)} of {len(shaken)} neighbours in its group, "
          f"{len(members - shaken - {valve})} strangers, rank "
          f"{1 + [loop['loop'] for loop in loops].index(valve)}{said}", flush=True)
    return not said, len(members & shaken) / max(len(shaken), 1)


def healthy_plant(seed):
    _, loops = screened(seed, "--sticking", "0")
    groups = max((loop["group"] or 0) for loop in loops)
    blamed = sum(loop["verdict"] in ("stiction", "backlash") for loop in loops)
    print(f"seed {seed}, all healthy: {groups} groups, {blamed} valves blamed", flush=True)
    return groups == 0


led = [sticking_plant(seed) for seed in range(first, first + plants)]
quiet = [healthy_plant(seed) for seed in range(first, first + plants)]
print(f"the valve leads: {100 * sum(ok for ok, _ in led) / len(led):.0f} % of {len(led)} plants, "
      f"with {100 * sum(share for _, share in led) / len(led):.0f} % of its neighbours")
print(f"without a false group: {100 * sum(quiet) / len(quiet):.0f} % of {len(quiet)} healthy plants")
