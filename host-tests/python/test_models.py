"""Model: fit, compare, explain, add, ladder; files; the program's numbers."""
import json

import numpy as np
import pytest
from conftest import program, program_json

import stickband
from stickband import BadInput, DataCannotAnswer, Model, WrongUsage


@pytest.fixture(scope="module")
def textbook(loop_csv):
    return Model.fit(loop_csv)


@pytest.fixture(scope="module")
def model_file(loop_csv, tmp_path_factory):
    path = tmp_path_factory.mktemp("models") / "m.json"
    program("model", loop_csv, "-o", path)
    return path


def test_fit_and_files_are_the_programs(textbook, model_file, loop_csv, tmp_path):
    textbook.save(tmp_path / "ours.json")
    assert (tmp_path / "ours.json").read_bytes() == model_file.read_bytes()
    again = Model.load(model_file)
    assert again == textbook
    assert Model.from_json(model_file.read_text()) == textbook
    assert textbook.to_dict() == json.loads(model_file.read_text())


def test_compare(textbook, model_file, loop_csv):
    comparison = textbook.compare()
    assert comparison.to_dict() == program_json("compare", loop_csv, "--model", model_file)
    assert np.allclose(comparison.measured - comparison.simulated, comparison.residual)
    assert comparison.failures[0].share_of_error >= comparison.failures[-1].share_of_error
    assert {view.view for view in comparison.views} >= {"time", "phase", "level", "travel"}
    assert f"{comparison.fit_percent:.1f} %" in str(comparison)
    assert Model.load(model_file).compare(loop_csv).to_dict() == comparison.to_dict()


def test_explain_and_add(textbook, model_file, loop_csv, tmp_path):
    explanation = textbook.explain()
    assert explanation.to_dict() == program_json("explain", loop_csv, "--model", model_file)
    assert explanation.identify.verdict == "stiction" and not explanation.identify.differs
    assert textbook.explain(identify=False).to_dict() == {**explanation.to_dict(),
                                                          "identify": None}
    assert explanation.best.effect == "valve.stiction"
    assert "What is missing: valve.stiction" in str(explanation)
    better = textbook.add("valve.stiction")
    assert better.added.to_dict() == program_json(
        "add", "valve.stiction", loop_csv, "--model", model_file, "-o", tmp_path / "m2.json")
    assert Model.load(tmp_path / "m2.json").added.parameters == better.added.parameters
    assert [one.effect for one in better.effects] == ["valve.stiction"]
    assert textbook.effects == [] and textbook.added is None
    assert better.added.parameters["deadband"].unit == "u"
    worse = better.remove("valve.stiction")
    assert worse.effects == [] and worse.added is None
    assert worse.history[-1].effect == "-valve.stiction"
    with pytest.raises(ValueError, match="the model has no valve.stiction"):
        worse.remove("valve.stiction")


def test_ladder(loop, loop_csv, tmp_path):
    ladder = Model.ladder(loop)
    told = program_json("ladder", loop_csv, "-o", tmp_path / "final.json")
    said = ladder.to_dict()
    # The recording's name is that of its file; all else is the same.
    for answer in (said, told):
        for recording in answer["recordings"]:
            recording.pop("file")
    assert said == told
    ours, theirs = ladder.model.to_dict(), json.loads((tmp_path / "final.json").read_text())
    for model in (ours, theirs):
        model["recording"].pop("name")
        for step in model["history"]:
            step.pop("recording")
    assert ours == theirs
    assert ladder.steps[0].rmse_validation > ladder.steps[-1].rmse_validation
    assert "Validation error after each step" in str(ladder)
    quick = Model.ladder(loop, within=0.05)
    assert not quick.complete and "Ended early" in quick.headline


def test_any_time_may_be_allowed(textbook):
    whole = textbook.explain(identify=False).to_dict()
    for within in (float("inf"), 1e300):
        assert textbook.explain(identify=False, within=within).to_dict() == whole


def test_frames_and_notebook(loop, textbook):
    pandas = pytest.importorskip("pandas")
    explanation = textbook.explain()
    frame = explanation.to_frame()
    assert isinstance(frame, pandas.DataFrame)
    assert frame["effect"][0] == "valve.stiction"
    assert textbook.to_frame().loc[("process", "first_lag"), "unit"] == "s"
    assert textbook.compare() == textbook.compare() != textbook.add("valve.stiction").compare()
    assert len(textbook.compare().to_frame()) == len(textbook.compare().failures)
    for shown in (textbook, explanation, textbook.compare()):
        assert "<table>" in shown._repr_html_()
    assert "valve.stiction" in explanation._repr_html_()


def test_plots(loop, textbook):
    pytest.importorskip("matplotlib")
    import matplotlib.pyplot as plt

    better = textbook.add("valve.stiction")
    comparison = better.compare()
    assert len(comparison.plot()) == 2
    assert len(comparison.plot_views()) == len(comparison.views)
    assert len(better.plot()) == 1
    plt.close("all")


def test_what_cannot_be_is_refused(loop, textbook, tmp_path, model_file):
    with pytest.raises(WrongUsage, match="no effect 'valve.rust'; known effects: valve"):
        textbook.add("valve.rust")
    with pytest.raises(WrongUsage, match="no effect"):
        Model.fit(loop, effects=["rust"])
    with pytest.raises(WrongUsage, match="already has"):
        textbook.add("valve.stiction").add("valve.stiction")
    with pytest.raises(WrongUsage, match="needs the recording"):
        Model.load(model_file).compare()
    with pytest.raises(WrongUsage, match="within must be above 0 s"):
        textbook.explain(within=float("nan"))
    with pytest.raises(BadInput, match="expected JSON"):
        Model.from_json("no model")
    (tmp_path / "other.json").write_text('{"kind":"bread"}')
    with pytest.raises(BadInput, match="other.json: expected a model"):
        Model.load(tmp_path / "other.json")
    with pytest.raises(DataCannotAnswer, match="samples"):
        Model.fit(np.arange(20.0), np.arange(20.0), ts=1)
    with pytest.raises(OSError, match="cannot write"):
        textbook.save(tmp_path / "no" / "such" / "folder.json")


def test_the_data_cannot_answer():
    """Nothing in a recording without steps in y tells of a lattice."""
    loop = stickband.simulate("healthy", seed=1)
    model = Model.fit(loop)
    with pytest.raises(DataCannotAnswer, match="^the data cannot answer: ") as told:
        model.add("sensor.quantisation")
    assert isinstance(told.value, ValueError)


def test_the_stem_can_be_modelled(loop):
    model = Model.fit(loop, output="x", effects=["valve.stiction"])
    assert model.output == "x"
    assert model.compare().fit_percent > 50


def test_effects_of_the_catalogue():
    codes = [one.code for one in stickband.effects()]
    assert "valve.stiction" in codes and "disturbance.sinusoid" in codes
    assert all(one.title and one.cure for one in stickband.effects())
