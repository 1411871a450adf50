"""Models of several recordings of one loop: the program's numbers, and what is refused."""
import json

import numpy as np
import pytest
from conftest import program, program_json

import stickband
from stickband import BadInput, Model, Recording, WrongUsage


@pytest.fixture(scope="module")
def days(tmp_path_factory):
    """Three recordings of one loop, the last one left to judge, and the second with a
    pause in it."""
    folder = tmp_path_factory.mktemp("days")
    loop = stickband.simulate("stiction", seed=1)
    third = len(loop.t) // 3
    paths = [folder / f"{name}.csv" for name in ("monday", "tuesday", "friday")]
    for k, path in enumerate(paths):
        rows = range(k * third, (k + 1) * third)
        lines = ["t,u,y,flow"]
        for row in rows:
            if k == 1 and 100 <= row - rows[0] < 140:
                continue
            lines.append(f"{float(loop.t[row])!r},{float(loop.u[row])!r},"
                         f"{float(loop.y[row])!r},{float(np.sin(row / 7))!r}")
        path.write_text("\n".join(lines) + "\n")
    return paths


@pytest.fixture(scope="module")
def week(days, tmp_path_factory):
    """The program's model of two recordings, judged on the third."""
    path = tmp_path_factory.mktemp("models") / "week.json"
    program("model", *days[:2], "--validate", days[2], "-o", path)
    return path


def test_fit_is_the_programs(days, week):
    monday, tuesday, friday = days
    model = Model.fit(monday, tuesday, validate=friday)
    assert model.to_dict() == json.loads(week.read_text())
    assert Model.fit([monday, tuesday], validate=[friday]) == model
    assert model.fitted_to == "monday.csv, tuesday.csv"
    read = [Recording.read(path) for path in days]
    assert Model.fit(*read[:2], validate=read[2]) == model


def test_a_pause_begins_a_new_piece(days, tmp_path):
    program("model", days[1], "-o", tmp_path / "m.json")
    model = Model.fit(days[1])
    assert any("each of the 2 pieces" in note for note in model._loop.joined.notes)
    assert model.to_dict() == json.loads((tmp_path / "m.json").read_text())
    assert model.compare().to_dict() == program_json("compare", days[1], "--model",
                                                     tmp_path / "m.json")


def test_compare(days, week):
    told = program_json("compare", *days[:2], "--validate", days[2], "--model", week)
    model = Model.fit(*days[:2], validate=days[2])
    comparison = model.compare()
    assert comparison.to_dict() == told
    assert Model.load(week).compare(*days[:2], validate=days[2]).to_dict() == told
    assert [(one.file, one.judges) for one in comparison.recordings] == [
        ("monday.csv", False), ("tuesday.csv", False), ("friday.csv", True)]
    assert "friday.csv: fit" in str(comparison) and "not fitted" in str(comparison)
    assert {one.recording for one in comparison.failures} <= {"", *(path.name for path in days)}
    assert len(comparison.t) == len(comparison.measured) == len(comparison.residual)
    assert np.allclose(comparison.measured - comparison.simulated, comparison.residual)
    alone = Model.load(week).compare(days[2])
    assert alone.to_dict() == program_json("compare", days[2], "--model", week)
    assert model.compare(days[2]).to_dict() == alone.to_dict()


def test_explain_and_add(days, week, tmp_path):
    together = [*days[:2], "--validate", days[2], "--model", week]
    model = Model.fit(*days[:2], validate=days[2])
    explanation = model.explain()
    assert explanation.to_dict() == program_json("explain", *together)
    assert explanation.identify.verdict == "stiction"
    better = model.add("valve.stiction")
    assert better.added.to_dict() == program_json(
        "add", "valve.stiction", *together, "-o", tmp_path / "more.json")
    assert better.to_dict() == json.loads((tmp_path / "more.json").read_text())
    assert better.added.recordings[-1].judges and "friday.csv" in str(better.added)
    # Held against all of them again without being told.
    assert len(better.compare().recordings) == 3


def test_recordings_that_judge_may_come_later(days, tmp_path):
    program("model", *days[:2], "-o", tmp_path / "m.json")
    model = Model.fit(*days[:2])
    told = program_json("explain", *days[:2], "--validate", days[2], "--model",
                        tmp_path / "m.json")
    assert model.explain(validate=days[2]).to_dict() == told


def test_ladder(days, tmp_path):
    ladder = Model.ladder(*days[:2], validate=days[2])
    told = program_json("ladder", *days[:2], "--validate", days[2], "-o",
                        tmp_path / "final.json")
    assert ladder.to_dict() == told
    assert ladder.model.to_dict() == json.loads((tmp_path / "final.json").read_text())
    assert [one.judges for one in ladder.recordings] == [False, False, True]
    assert ladder.identify.verdict == "stiction"
    assert Model.ladder(days[0], within=0.05, identify=False).identify is None


def test_loads(days, tmp_path):
    told = program_json("ladder", *days[:2], "--load", "flow", "--within", "300")
    assert Model.ladder(*days[:2], loads=["flow"], within=300).to_dict() == told
    with pytest.raises(WrongUsage, match="loads are named where a recording is made"):
        Model.fit(Recording.read(days[0]), loads=["flow"])


def test_the_stem_has_no_verdict_beside_it(loop):
    model = Model.fit(loop, output="x")
    explanation = model.explain()
    assert explanation.identify is None and explanation.to_dict()["identify"] is None


def test_what_cannot_be_is_refused(days, loop):
    monday, tuesday, friday = days
    for call in (lambda: Model.fit(monday, monday), lambda: Model.fit([loop, loop]),
                 lambda: Model.fit(monday, tuesday, validate=monday),
                 lambda: Model.fit(monday).explain(tuesday, validate=[friday, friday])):
        with pytest.raises(WrongUsage, match="named twice"):
            call()
    u, y = np.sin(np.arange(400) / 9), np.cos(np.arange(400) / 9)
    bars = Recording(u, y, ts=1.0, name="bars", units={"y": "bar"})
    kelvins = Recording(u + 0.1, y, ts=1.0, name="kelvins", units={"y": "K"})
    with pytest.raises(BadInput, match="kelvins: expected y in 'bar', as bars has it"):
        Model.fit(bars, kelvins)
    odd = Recording(u, y, ts=0.7, name="odd")
    with pytest.raises(BadInput, match="odd: expected a sample period that divides"):
        Model.fit(bars, odd)
    with pytest.raises(BadInput, match="expected the column x, found no x"):
        Model.fit(bars, odd, output="x")
    with pytest.raises(WrongUsage, match="give a recording"):
        Model.fit()


def test_the_sample_period_of_arrays_is_theirs_alone(tmp_path):
    """A file that judges has its own times."""
    loop = stickband.simulate("stiction", seed=1)
    every_other = tmp_path / "slower.csv"
    np.savetxt(every_other, np.c_[loop.t[::2], loop.u[::2], loop.y[::2]], delimiter=",",
               header="t,u,y", comments="")
    by_t, by_ts = (Model.fit(loop.u, loop.y, validate=every_other, **given)
                   for given in ({"t": loop.t}, {"ts": loop.period_s}))
    assert by_ts.compare().recordings == by_t.compare().recordings


def test_a_sample_period_is_not_taken_twice(days, loop):
    for call in (lambda: stickband.identify(loop, ts=99), lambda: Model.fit(loop, ts=99),
                 lambda: stickband.oscillation(loop.recording, ts=99)):
        with pytest.raises(WrongUsage, match="has its sample period"):
            call()
    judged = Model.fit(days[0], ts=3.1, validate=Recording.read(days[2]))
    assert len(judged.compare().recordings) == 2


def test_a_load_of_a_model_stays_whatever_it_is_made_of(tmp_path):
    """As in the program: only where none is asked for is an own reading no load."""
    loop = stickband.simulate("stiction", seed=1)
    path, file = tmp_path / "own.csv", tmp_path / "m.json"
    np.savetxt(path, np.c_[loop.t, loop.u, loop.y, loop.sp - loop.y], delimiter=",",
               header="t,u,y,deviation", comments="", fmt="%.17g")
    effect = "disturbance.measured:deviation"
    program("model", path, "--load", "deviation", "--with", effect, "-o", file)
    told = program_json("compare", path, "--model", file)
    read = Recording.read(path, loads=["deviation"])
    arrays = Recording(loop.u, loop.y, t=loop.t, name="own.csv",
                       loads={"deviation": loop.sp - loop.y})
    for recording in (read, arrays):
        assert not recording.loads
        assert Model.load(file).compare(recording).to_dict() == told
        assert Model.fit(recording, effects=[effect]).compare().to_dict() == told
        assert not Model.fit(recording)._loop.joined.loads
    assert Model.load(file).compare(read.part(0, 900)).effects == [effect]
    assert Model.load(file).compare(arrays.part(0, 900)).effects == [effect]
    added = Model.fit(read).add(effect)
    assert [one.effect for one in added.effects] == [effect]
