"""identify and oscillation: numbers, texts, arrays that are not copied, Ctrl-C."""
import dataclasses
import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import program, program_json, without_clock

import stickband


def test_arrays_say_what_the_file_says(loop, loop_csv):
    by_arrays = stickband.identify(loop.u, loop.y, t=loop.t, sp=loop.sp)
    by_path = stickband.identify(loop_csv)
    by_program = program_json("identify", loop_csv)
    assert without_clock(by_arrays.to_dict()) == without_clock(by_program)
    assert without_clock(by_path.to_dict()) == without_clock(by_program)
    assert json.loads(by_path.to_json()) == by_path.to_dict()


def test_text_is_the_programs(loop_csv):
    assert str(stickband.identify(loop_csv)) == program("identify", loop_csv).rstrip("\n")


def test_verdict_band_and_truth(loop):
    result = stickband.identify(loop)
    assert result.verdict == loop.truth.kind == "stiction"
    assert result.decided
    assert loop.truth.stick_band["ascending"] in result.stick_band.ascending
    assert dataclasses.is_dataclass(result)
    assert repr(result).startswith("<Identification stiction, stick band ")


def test_undecided_is_an_answer():
    noise = np.random.default_rng(1).normal(size=(2, 600))
    result = stickband.identify(noise[0], noise[1], ts=1)
    assert result.verdict in ("undecided", "no_stiction", "bad_data")
    assert result.reason
    assert str(result.stick_band) == "unknown ascending, unknown descending"


def test_several_recordings_are_judged_together(tmp_path):
    whole = tmp_path / "whole.csv"
    stickband.simulate("stiction-setpoint", seed=2).save(whole)
    header, *rows = whole.read_text().splitlines(keepends=True)
    paths = [tmp_path / "a.csv", tmp_path / "b.csv"]
    for path, half in zip(paths, (rows[:len(rows) // 2], rows[len(rows) // 2:])):
        path.write_text(header + "".join(half))
    loops = [stickband.read(path) for path in paths]
    together = stickband.identify(*paths)
    assert len(together.windows) == 2
    assert without_clock(together.to_dict()) == without_clock(
        program_json("identify", *paths))
    assert without_clock(stickband.identify(loops).to_dict()) == without_clock(
        together.to_dict())


def test_what_is_not_a_pair_of_arrays_is_refused(loop):
    with pytest.raises(stickband.WrongUsage, match="recording"):
        stickband.identify()
    with pytest.raises(stickband.WrongUsage, match="found int"):
        stickband.identify(3)
    with pytest.raises(stickband.WrongUsage, match="either t"):
        stickband.identify(loop.u, loop.y)
    with pytest.raises(stickband.BadInput, match="expected the columns u and y, found no y"):
        stickband.identify(stickband.Recording(loop.u, ts=1))


def test_signals_and_frame(loop):
    result = stickband.identify(loop)
    signals = result.signals
    assert signals.t.shape == signals.y.shape == signals.y_valve.shape == signals.stem.shape
    pandas = pytest.importorskip("pandas")
    frame = result.to_frame()
    assert isinstance(frame, pandas.DataFrame)
    assert frame.loc[("stick_band", "ascending"), "value"] == result.stick_band.ascending.value
    assert frame.shape == (4, 4)


def test_notebook_shows_verdict_and_interval(loop):
    html = stickband.identify(loop)._repr_html_()
    assert "The valve sticks." in html
    assert "143.56 to 144.89" in html


def test_oscillation(loop, loop_csv):
    by_array = stickband.oscillation(loop.u, ts=loop.period_s)
    assert by_array.detected
    for column in ("u", "y"):
        assert stickband.oscillation(loop_csv, column=column).to_dict() == program_json(
            "oscillation", loop_csv, "--column", column)
    assert "No oscillation" in str(stickband.oscillation(np.arange(100.0), ts=1))
    with pytest.raises(stickband.WrongUsage, match="ts"):
        stickband.oscillation(loop.u)
    with pytest.raises(stickband.WrongUsage, match="t goes with an array"):
        stickband.oscillation(loop_csv, t=loop.t)
    holed = np.where(np.arange(len(loop.u)) % 2, np.nan, loop.u)
    with pytest.raises(stickband.BadInput, match="values: expected finite numbers, found nan"):
        stickband.oscillation(holed, ts=loop.period_s)


def test_arrays_in_are_not_copied():
    """What the call takes more than its arrays is far less than one of them."""
    code = """
import resource, numpy as np, stickband
n = 8_000_000
u = np.zeros(n); y = np.zeros(n)
u[:] = np.sin(np.arange(n) * 0.01); y[:] = u
peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
stickband.oscillation(u[:1000], ts=1)
before = peak()
stickband.oscillation(u, ts=1)
print(peak() - before, u.nbytes)
"""
    more, size = map(int, subprocess.run([sys.executable, "-c", code], check=True, text=True,
                                         capture_output=True).stdout.split())
    assert more < size / 8


def test_the_array_that_was_passed_is_the_recordings():
    u = np.sin(np.arange(500) / 9)
    y = np.cos(np.arange(500) / 9)
    recording = stickband.Recording(u, y, ts=2.0)
    assert recording.u is u
    assert recording.y.__array_interface__["data"] == y.__array_interface__["data"]
    times = 2.0 * np.arange(500)
    assert stickband.Recording(u, y, t=times).t is times


def test_arrays_out_are_not_copied(loop_csv):
    recording = stickband.read(loop_csv)
    first, second = recording.u, recording.u
    assert first is not second and np.shares_memory(first, second)
    assert not first.flags.writeable
    del recording  # the arrays keep it
    assert np.isfinite(first).all()


LONG = """
import time, sys, threading
import stickband
loop = stickband.simulate("stiction-mixed", seed=3)
print("begun", flush=True)
begin = time.monotonic()
try:
    while True:
        {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.parametrize("call", [
    "stickband.identify(loop)",
    "stickband.Model.ladder(loop)",
    "stickband.monitor(loop)",
    "stickband.simulate('stiction-mixed', seed=1102)",
])
def test_ctrl_c_ends_long_work(call):
    run = subprocess.Popen([sys.executable, "-c", LONG.format(call=call)],
                           stdout=subprocess.PIPE, text=True)
    assert run.stdout.readline() == "begun\n"
    time.sleep(0.4)
    run.send_signal(signal.SIGINT)
    out, _ = run.communicate(timeout=60)
    assert out == "interrupted\n"
    assert run.returncode == 0


def long_read(folder):
    path = folder / "long.csv"
    rows = "".join(f"{50 + k % 97 / 10},{k % 89 / 10}\n" for k in range(10_000))
    with path.open("w") as file:
        file.write("u,y\n")
        for _ in range(500):
            file.write(rows)
    return lambda: stickband.read(path, ts=1)


def long_comparison(_):
    model = stickband.Model.fit(stickband.simulate("stiction", seed=1),
                                effects=["valve.stiction"])
    u = np.cumsum(np.random.default_rng(1).normal(size=1_000_000))
    recording = stickband.Recording(u, u[::-1].copy(), ts=1)
    return lambda: model.compare(recording)


@pytest.mark.parametrize("prepared", [long_read, long_comparison])
def test_ctrl_c_ends_a_long_call(prepared, tmp_path):
    """It comes a quarter into the call."""
    call = prepared(tmp_path)
    begin = time.monotonic()
    call()
    whole = time.monotonic() - begin
    timer = threading.Timer(whole / 4, os.kill, (os.getpid(), signal.SIGINT))
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        call()
        timer.join()
    assert time.monotonic() - begin < 0.75 * whole


def test_other_threads_run_meanwhile(loop):
    """Without the interpreter's lock released, the counter would stand still."""
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    stickband.Model.fit(loop).explain(threads=1)
    after = counted
    done.set()
    thread.join()
    assert after - before > 5


def test_two_threads_get_the_same_answer(loop):
    answers = []
    threads = [threading.Thread(
        target=lambda: answers.append(without_clock(stickband.identify(loop).to_dict())))
        for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers[0] == answers[1]


def test_threads_share_an_answer():
    """Its signals are those of a window that is identified again where others came after."""
    loop = stickband.simulate("stiction-setpoint", seed=3)
    noise = np.random.default_rng(0)
    parts = [stickband.Recording(*(values + noise.normal(0, values.std() * share, len(values))
                                   for values in (loop.u, loop.y)), ts=loop.period_s)
             for share in (0.02, 0.04, 0.06)]
    alone = stickband.identify(parts).signals
    for _ in range(3):
        shared, seen = stickband.identify(parts), []
        begin = threading.Barrier(4)

        def look():
            begin.wait()
            seen.append(shared.signals)

        threads = [threading.Thread(target=look) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert [one.stem.tolist() == alone.stem.tolist() for one in seen] == [True] * 4


def test_plots(loop):
    pytest.importorskip("matplotlib")
    import matplotlib.pyplot as plt

    result = stickband.identify(loop)
    assert len(result.plot()) == 3
    assert len(result.plot_valve()) == 2
    assert len(loop.recording.plot()) == 2
    nothing = stickband.identify(np.zeros(100), np.zeros(100), ts=1)
    assert len(nothing.plot()) == 2
    nothing.plot_valve()
    plt.close("all")
    assert os.environ["MPLBACKEND"] == "Agg"
