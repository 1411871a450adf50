"""What the tests share: the program, simulated loops, recordings."""
import json
import os
import pathlib
import subprocess

import pytest

import stickband

PROGRAM = os.environ["STICKBAND_BIN"]
RECORDINGS = pathlib.Path(os.environ["STICKBAND_RECORDINGS"])


def program(*arguments, codes=(0, 4)):
    """Standard output of the program."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert run.returncode in codes, run.stderr
    return run.stdout


def program_json(*arguments):
    return json.loads(program(*arguments, "--json"))


def without_clock(answer):
    """All but what depends on how fast this machine is."""
    return {key: value for key, value in answer.items()
            if key not in ("runtime_ms", "worst_step_us")}


@pytest.fixture(scope="session")
def loop():
    """A loop whose valve sticks."""
    return stickband.simulate("stiction", seed=1)


@pytest.fixture(scope="session")
def loop_csv(loop, tmp_path_factory):
    path = tmp_path_factory.mktemp("loop") / "loop.csv"
    loop.save(path)
    return path
