"""Monitor: the device's own object, sample by sample and from arrays."""
import json

import numpy as np
import pytest
from conftest import program, without_clock

import stickband


@pytest.fixture(scope="module")
def example(tmp_path_factory):
    loop = stickband.simulate("paper-example-1", seed=1)
    path = tmp_path_factory.mktemp("monitor") / "example.csv"
    loop.save(path)
    return loop, path


def test_a_recording_says_what_the_program_says(example):
    loop, path = example
    lines = [json.loads(line) for line in program("monitor", path, "--json").splitlines()]
    run = stickband.monitor(loop)
    assert [without_clock(one) for one in run.to_dicts()] == [
        without_clock(one) for one in lines]
    assert run.summary.verdict == "stiction"
    assert run.summary.ram_bytes == stickband.Monitor.ram_bytes
    assert "stiction raised, stick band" in str(run)
    assert "<table>" in run._repr_html_()
    pandas = pytest.importorskip("pandas")
    assert isinstance(run.to_frame(), pandas.DataFrame)


def test_push_and_step_are_feed(example):
    loop, _ = example
    span = (float(loop.u.min()), float(loop.u.max()))
    by_sample = stickband.Monitor(loop.period_s, span)
    for t, u, y, sp in zip(loop.t, loop.u, loop.y, loop.sp):
        assert by_sample.push(t, u, y, sp) == "accepted"
        while by_sample.step():
            pass
    by_array = stickband.Monitor(loop.period_s, span)
    by_array.feed(loop.t, loop.u, loop.y, loop.sp)
    assert by_array.events() == by_sample.events()
    assert by_array.events() == []
    assert without_clock(by_array.summary().to_dict()) == without_clock(
        by_sample.summary().to_dict())


def test_what_the_window_refuses_is_told():
    monitor = stickband.Monitor(ts=1)
    assert monitor.push(0, 1, 1) == "accepted"
    assert monitor.push(0, 1, 1) == "repeat"
    assert monitor.push(1, np.nan, 1) == "non_finite"
    assert monitor.push(np.nan, 1, 1) == "non_finite"
    assert monitor.push(9, 1, 1) == "gap"
    assert monitor.push(3, 1, 1) == "time_back"
    assert not monitor.busy


def test_wrong_settings_are_refused():
    with pytest.raises(stickband.WrongUsage, match="positive"):
        stickband.Monitor(ts=0)
    with pytest.raises(stickband.WrongUsage, match="span"):
        stickband.Monitor(ts=1, span=(5, 5))
    with pytest.raises(stickband.WrongUsage, match="settings are gain_sign"):
        stickband.Monitor(ts=1, gain=1)
    with pytest.raises(stickband.WrongUsage, match="as many samples"):
        stickband.Monitor(ts=1).feed(np.zeros(3), np.zeros(3), np.zeros(2))
