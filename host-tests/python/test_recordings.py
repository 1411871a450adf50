"""Recordings from arrays, frames and files, and what is refused."""
import os
import pathlib

import numpy as np
import pytest
from conftest import program

import stickband
from stickband import BadInput, Recording, WrongUsage

U = np.sin(np.arange(300) / 10)
Y = np.cos(np.arange(300) / 10)


def test_wrong_arrays_are_refused_by_name():
    with pytest.raises(BadInput, match="array y: expected 300 samples, found 299"):
        Recording(U, Y[1:], ts=1)
    with pytest.raises(BadInput, match="array u: expected one axis, found 2 axes"):
        Recording(np.zeros((10, 2)), Y, ts=1)
    with pytest.raises(BadInput, match="at least 2 samples"):
        Recording(U[:1], Y[:1], ts=1)
    with pytest.raises(BadInput, match="array u: expected numbers"):
        Recording(["a", "b"], Y[:2], ts=1)
    holed = U.copy()
    holed[7] = np.nan
    with pytest.raises(BadInput, match="array u: expected finite numbers, found nan at index 7"):
        Recording(holed, Y, ts=1)
    with pytest.raises(WrongUsage, match="positive"):
        Recording(U, Y, ts=-1)
    with pytest.raises(WrongUsage, match="either t"):
        Recording(U, Y, t=np.arange(300), ts=1)


def test_times_have_to_rise():
    t = np.arange(300.0)
    t[5] = 4
    with pytest.raises(BadInput, match="array t: expected times .* at index 5"):
        Recording(U, Y, t=t)


def test_uneven_times_are_resampled_and_told():
    t = np.delete(np.arange(300.0), [50, 51])
    recording = Recording(np.delete(U, [50, 51]), np.delete(Y, [50, 51]), t=t)
    assert len(recording) == 300
    assert recording.u[50] == recording.u[51] == U[49]
    assert "2 samples are missing (longest gap 3 s before sample 50)" in recording.notes[0]
    assert "Note: 2 samples are missing" in str(recording)


def test_other_types_are_taken_with_a_copy():
    single = Recording(U.astype(np.float32), list(Y), ts=1)
    assert single.u.dtype == np.float64
    assert Recording(np.column_stack([U, Y])[:, 0], Y, ts=1).u.tolist() == U.tolist()


def test_a_file_says_where_it_is_wrong(tmp_path):
    path = tmp_path / "bad.csv"
    path.write_text("t,u,y\n0,1,2\n1,abc,3\n")
    with pytest.raises(BadInput) as told:
        stickband.read(path)
    error = told.value
    assert isinstance(error, ValueError)
    assert (error.line, error.column) == (3, 3)
    assert error.file == str(path)
    assert error.found == "'abc'"
    assert error.advice and error.expected
    assert str(error).startswith(f"{path}:3:3: expected ")
    with pytest.raises(BadInput, match="absent.csv"):
        stickband.identify(tmp_path / "absent.csv")


def test_an_export_by_the_names_of_its_columns(tmp_path):
    path = tmp_path / "export.csv"
    rows = "\n".join(f"2026-05-03 14:{i // 60:02}:{i % 60:02};{u};{y};{u + y}"
                     for i, (u, y) in enumerate(zip(U, Y)))
    path.write_text(f"time;FIC101.OP;FIC101.PV;FI7.PV\n{rows}\n")
    recording = stickband.read(path, u="FIC101.OP", y="FIC101.PV", loads=["FI7.PV"])
    assert recording.u.tolist() == U.tolist()
    assert list(recording.loads) == ["FI7.PV"]
    assert recording.start.startswith("2026-05-03T14:00:00")
    with pytest.raises(WrongUsage, match="FIC9"):
        stickband.read(path, u="FIC9.OP", y="FIC101.PV")


def test_a_step_test_that_begins_with_its_step(tmp_path):
    path = tmp_path / "step.csv"
    path.write_text("t,u,y\n" + "".join(
        f"{k},50,{25 - 25 * np.exp(-k / 30):.4f}\n" for k in range(200)))
    loop = stickband.Recording.read(path, u_before=10)
    assert loop.u[0] == 10 and loop.u[-1] == 50 and len(loop) > 200
    gain = stickband.Model.fit(loop).process["gain"].value
    assert abs(gain - 25 / 40) < 0.02


def test_frames():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"OP": U, "PV": Y})
    recording = Recording.from_frame(frame, ts=2)
    assert np.shares_memory(recording.u, frame["OP"].to_numpy())
    assert recording.period_s == 2
    with pytest.raises(WrongUsage, match="no times"):
        Recording.from_frame(frame)
    with pytest.raises(WrongUsage, match="no column 'CV'"):
        Recording.from_frame(frame, u="CV", ts=1)
    dated = frame.set_index(pandas.date_range("2026-05-03 14:30", periods=300, freq="5s"))
    recording = Recording.from_frame(dated)
    assert recording.period_s == 5
    assert recording.start == "2026-05-03T14:30:00"
    back = recording.to_frame()
    assert back["u"].tolist() == U.tolist() and back.index[1] == 5


def test_simulated_loops_are_the_programs(tmp_path):
    loop = stickband.simulate("stiction-one-sided", seed=4)
    loop.save(tmp_path / "ours.csv")
    program("simulate", "stiction-one-sided", "--seed", "4", "-o", tmp_path / "theirs.csv",
            "--truth", tmp_path / "truth.json")
    read = (pathlib.Path(tmp_path) / "theirs.csv").read_text
    assert (tmp_path / "ours.csv").read_text() == read()
    import json
    assert loop.truth.to_dict() == json.loads((tmp_path / "truth.json").read_text())
    with pytest.raises(WrongUsage, match="no scenario"):
        stickband.simulate("nothing", seed=1)
    # A plant is a folder of many loops, not a scenario of one.
    assert list(stickband.scenarios()) == [
        line.split()[0] for line in program("simulate", "--list").splitlines()
        if line and line[0] != " " and line.split()[0] != "plant"]


def test_times_may_be_dates_or_spans():
    import pandas as pd

    dates = pd.date_range("2026-05-03 10:00", periods=300, freq="3100ms")
    for t in (dates, dates - dates[0]):
        recording = Recording.from_frame(pd.DataFrame({"t": t, "u": U, "y": Y}))
        assert recording.period_s == pytest.approx(3.1)
    with pytest.raises(BadInput, match="dates or spans"):
        Recording(U, Y, t=dates.to_numpy())
    with pytest.raises(BadInput, match="at least 2 samples"):
        Recording.from_frame(pd.DataFrame({"u": [], "y": []}, index=pd.DatetimeIndex([])))


def test_loads_of_a_frame_are_its_other_numbers():
    import pandas as pd

    frame = pd.DataFrame({"t": np.arange(300.0), "u": U, "y": Y, "feed": U * Y, "word": "x"})
    assert list(Recording.from_frame(frame, loads=["all"]).loads) == ["feed"]
    with pytest.raises(WrongUsage, match="no column 'steam'"):
        Recording.from_frame(frame, loads=["steam"])


def test_a_part_leaves_out_what_the_whole_does(tmp_path):
    rows = [f"{k},{U[k % 300]},{Y[k % 300]}" for k in range(600) if not 200 <= k < 260]
    path = tmp_path / "gap.csv"
    path.write_text("t,u,y\n" + "\n".join(rows) + "\n")
    whole = stickband.read(path)
    part = whole.part(0, 1e9, "part")
    assert part.notes == whole.notes and part.name == "part"
    assert str(stickband.Model.fit(part).process) == str(stickband.Model.fit(whole).process)
    assert len(whole.part(100, 150)) == 51


def test_what_cannot_answer_says_so():
    with pytest.raises(stickband.DataCannotAnswer):
        stickband.Model.fit(Recording(U[:30], Y[:30], ts=1))


def test_what_is_masked_is_no_number():
    masked = np.ma.masked_array(U, mask=np.arange(300) % 50 == 7)
    with pytest.raises(BadInput, match="array u: expected finite numbers, found nan at index 7"):
        Recording(masked, Y, ts=1)
    assert Recording(np.ma.masked_array(U), Y, ts=1).u.tolist() == U.tolist()


def test_of_two_columns_for_one_none_is_taken():
    pd = pytest.importorskip("pandas")
    for other in ("U", "OP"):
        frame = pd.DataFrame({"u": U, other: Y, "y": Y})
        with pytest.raises(BadInput, match=f"one column for u, found both 'u' and '{other}'"):
            Recording.from_frame(frame, ts=1)
        assert Recording.from_frame(frame, u="u", ts=1).u.tolist() == U.tolist()


def test_columns_may_have_numbers_for_names():
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame({0: U, 1: Y, 2: np.sin(np.arange(300) / 3)})
    recording = Recording.from_frame(frame, u=0, y=1, ts=1, loads=["all"])
    assert recording.u.tolist() == U.tolist() and list(recording.loads) == ["2"]


def test_times_are_no_load_beside_a_sample_period():
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame({"T": np.arange(300.0), "u": U, "y": Y, "feed": U * Y})
    assert list(Recording.from_frame(frame, ts=2, loads=["all"]).loads) == ["feed"]


def test_own_readings_are_no_loads(tmp_path):
    """From arrays and frames as from files."""
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame({"t": np.arange(300.0), "u": U, "y": Y, "sp": np.sign(Y),
                          "fahrenheit": 1.8 * Y + 32, "feed": U * Y})
    frame["deviation"] = frame.sp - frame.y
    path = tmp_path / "own.csv"
    frame.to_csv(path, index=False)
    loads = {name: frame[name].to_numpy() for name in ("fahrenheit", "feed", "deviation")}
    uneven = np.arange(300.0)
    uneven[200:] += 3
    for recording in (stickband.read(path, loads=["all"]),
                      Recording.from_frame(frame, loads=["all"]),
                      Recording(U, Y, ts=1, sp=frame.sp, loads=loads),
                      Recording(U, Y, t=uneven, sp=frame.sp, loads=loads)):
        for one in (recording, recording.part(0, 250)):
            assert list(one.loads) == ["feed"]
            told = [note for note in one.notes if "no load of its own, left out" in note]
            assert [note.split()[1] for note in told] == ["fahrenheit", "deviation"]
    assert Recording.from_frame(frame, loads=["feed"]).loads["feed"] is not None


def test_u_before_is_a_number(tmp_path):
    for value in (float("nan"), float("inf")):
        with pytest.raises(WrongUsage, match="u_before must be a finite number"):
            stickband.read(tmp_path / "step.csv", u_before=value)


def test_names_of_files_in_another_encoding(tmp_path):
    path = pathlib.Path(os.fsdecode(os.fsencode(tmp_path) + b"/caf\xe9.csv"))
    with pytest.raises(BadInput, match="caf. ?"):
        stickband.read(path)
    path.write_text("t,u,y\n" + "".join(f"{k},{u},{y}\n" for k, (u, y) in
                                        enumerate(zip(U, Y))))
    recording = stickband.read(path)
    assert recording.name == "caf\ufffd.csv" and recording.name in str(recording)
    assert "caf" in str(stickband.identify(path))
    model = stickband.Model.fit(path)
    file = path.with_suffix(".json")
    model.save(file)
    assert stickband.Model.load(file) == model
