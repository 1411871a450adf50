"""Python against the program on real recordings: identical JSON.

One recording of each folder; with STICKBAND_ALL=1 every one. Skipped where the folder of
recordings is absent.
"""
import csv
import json
import os

import pytest
from conftest import PROGRAM, RECORDINGS, program, without_clock

import stickband

ALL = os.environ.get("STICKBAND_ALL") == "1"
FIRST = 1  # of a folder
LONGEST = 200_000  # bytes of a file in the short form


def has_columns(path):
    """t, u and y, or with an export what the program asks for."""
    with open(path, newline="", errors="replace") as file:
        head = {cell.strip().lower() for cell in next(csv.reader(file), [])}
    return head


def recordings():
    if not RECORDINGS.is_dir():
        return []
    found = []
    for folder in sorted(one for one in RECORDINGS.iterdir() if one.is_dir()):
        files = sorted(folder.glob("*.csv"))
        if not ALL:
            files = [one for one in files if one.stat().st_size < LONGEST][:FIRST]
        found += files
    return found


@pytest.mark.skipif(not RECORDINGS.is_dir(), reason=f"no recordings in {RECORDINGS}")
def test_there_are_recordings():
    assert recordings()


def answer(function):
    """What Python says, or how it refuses."""
    try:
        return function()
    except (stickband.BadInput, stickband.WrongUsage) as error:
        return str(error)


def told(*arguments):
    """What the program says, or how it refuses."""
    import subprocess

    run = subprocess.run([PROGRAM, *map(str, arguments), "--json"], capture_output=True,
                         text=True)
    if run.returncode in (2, 3):
        return run.stderr.strip().removeprefix("stickband: ")
    assert run.returncode in (0, 4), run.stderr
    return [without_clock(json.loads(line)) for line in run.stdout.splitlines()]


@pytest.mark.parametrize("path", recordings(),
                         ids=[f"{path.parent.name}/{path.stem}" for path in recordings()])
def test_identical(path, tmp_path):
    assert answer(lambda: [without_clock(stickband.identify(path).to_dict())]) == told(
        "identify", path)
    column = "u" if "u" in has_columns(path) else "y"
    assert answer(lambda: [stickband.oscillation(path, column=column).to_dict()]) == told(
        "oscillation", path, "--column", column)
    try:
        recording = stickband.read(path)
    except (stickband.BadInput, stickband.WrongUsage):
        return
    # The same samples from arrays instead of the file.
    if not recording.notes:
        arrays = stickband.identify(recording.u, recording.y, t=recording.t, sp=recording.sp)
        assert [without_clock(arrays.to_dict())] == told("identify", path)
    if not ALL and len(recording) > 4096:
        return
    assert [without_clock(one) for one in stickband.monitor(recording).to_dicts()] == told(
        "monitor", path)
    program("model", path, "-o", tmp_path / "m.json")
    model = stickband.Model.fit(recording)
    assert model.to_dict() == json.loads((tmp_path / "m.json").read_text())
    assert [model.compare().to_dict()] == told("compare", path, "--model", tmp_path / "m.json")
    if ALL and len(recording) <= 4096:
        assert [model.explain().to_dict()] == told("explain", path, "--model",
                                                   tmp_path / "m.json")
