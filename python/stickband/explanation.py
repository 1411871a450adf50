"""Where a model fails, which effect it lacks, and how its error falls."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import plots
from .answer import Answer, Parameter, fields_of, paragraph, parameters_of, table
from .recording import Recording, Samples

if TYPE_CHECKING:
    import pandas as pd

    from .model import Model


def percent_down(before: float, after: float) -> str:
    """"down 69.3 %" from one error to another."""
    if not before > 0:
        return ""
    fall = 100 * (1 - after / before)
    return f"down {fall:.1f} %" if fall >= 0 else f"up {-fall:.1f} %"


@dataclass(frozen=True)
class RecordingFit:
    """What a model makes of one of several recordings; errors in units of the output."""

    file: str  #: name of the recording
    fit_percent: float
    rmse: float
    rmse_validation: float | None  #: None where all of its samples were fitted
    judges: bool  #: nothing was fitted to it but its initial state

    def __str__(self) -> str:
        text = f"{self.file}: fit {self.fit_percent:.1f} %, error {self.rmse:.4g}"
        if self.judges:
            return f"{text}, not fitted"
        # Where others judge, none of its samples does.
        if self.rmse_validation is None:
            return text
        return f"{text}, validation {self.rmse_validation:.4g}"


def recordings_of_fit(found: dict[str, Any]) -> list[RecordingFit]:
    return [fields_of(RecordingFit, one) for one in found.get("recordings", [])]


def lines_of(recordings: list[RecordingFit]) -> list[str]:
    """One for each of several; none for a single one."""
    return [f"  {one}" for one in recordings] if len(recordings) > 1 else []


@dataclass(frozen=True)
class ValveVerdict:
    """The verdict of :func:`identify` on the same recordings, beside a model of y."""

    verdict: str
    differs: str | None  #: how both are meant where they seem to contradict each other
    #: it names a stem that neither is in the model nor missing from it
    lacks_stem: bool = False

    @classmethod
    def of(cls, found: dict[str, Any]) -> ValveVerdict | None:
        return None if found["identify"] is None else cls(**found["identify"])

    def lines(self) -> list[str]:
        """A line of text where both seem to contradict each other, else none."""
        return [f"stickband identify says {self.verdict}. {self.differs}"] if self.differs else []


def _noise_is_left(said: str, identify: ValveVerdict | None) -> str:
    if identify is None or not identify.lacks_stem:
        return f"{said}: what is left looks like noise."
    return ("Open: what is left looks like noise, but stickband identify finds a stem that "
            "does not follow u, and the model has none.")


@dataclass(frozen=True)
class Failure:
    """A place where more of the squared error lies than of the samples."""

    where: str
    view: str  #: time, phase, level, direction, speed, travel, frequency or lag
    share_of_error: float  #: 0 to 1
    share_of_samples: float  #: 0 to 1
    mean_residual: float  #: y less the model there, units of the output
    t: tuple[float, float]  #: its worst stretch, s
    recording: str = ""  #: whose time that is; "": there is only one


@dataclass(frozen=True)
class Whiteness:
    """The residual against white noise."""

    white: bool
    bound: float  #: autocorrelations of white noise lie within it in 19 of 20 cases
    autocorrelation: list[float]  #: at lags 1 to 20
    effective_samples: float
    follows_u: bool  #: what is left still depends on u


@dataclass(frozen=True, eq=False)
class View:
    """The residual over one coordinate, in bins; shape (k,) each."""

    view: str
    coordinate: str  #: with its unit
    position: Samples  #: middle of each bin
    mean: Samples  #: mean residual in it, units of the output
    error_share: Samples  #: of the squared error, 0 to 1
    sample_share: Samples


@dataclass(frozen=True, repr=False, eq=False)  # by its JSON
class Comparison(Answer):
    """A model against a recording, simulated freely from u alone."""

    effects: list[str]
    fit_percent: float  #: 100 (1 - |y - simulated| / |y - mean(y)|), %
    rmse: float  #: all samples, units of the output
    rmse_validation: float  #: samples that were not fitted
    residual_test: Whiteness
    failures: list[Failure]  #: largest share of the error first
    t: Samples  #: s, shape (n,)
    measured: Samples  #: the output, shape (n,)
    simulated: Samples  #: free simulation, shape (n,)
    residual: Samples  #: measured less simulated, shape (n,)
    recordings: list[RecordingFit]  #: each for itself; of several, t runs on without pause
    views: list[View] = field(repr=False)

    @classmethod
    def _of(cls, text: str, arrays: dict[str, Samples], views: list[dict[str, Any]],
            recording: Recording, output: str) -> Comparison:
        found = Answer(text).to_dict()
        measured = recording.column(output)
        assert measured is not None
        return fields_of(
            cls, found, json=text, t=recording.t, measured=measured, **arrays,
            residual_test=fields_of(Whiteness, found["residual"]),
            recordings=recordings_of_fit(found),
            failures=[fields_of(Failure, one, t=tuple(one["t"]))
                      for one in found["failures"]],
            views=[fields_of(View, view) for view in views])

    def to_frame(self) -> pd.DataFrame:
        """The failures, one row each."""
        import pandas as pd

        return pd.DataFrame(
            [(one.view, one.where, one.share_of_error, one.share_of_samples,
              one.mean_residual, *one.t) for one in self.failures],
            columns=["view", "where", "share_of_error", "share_of_samples",
                     "mean_residual", "t_from", "t_to"])

    def plot(self) -> npt.NDArray[np.object_]:
        """Measured and simulated output above the residual. Returns the axes."""
        return plots.comparison(self)

    def plot_views(self) -> npt.NDArray[np.object_]:
        """The mean residual over each coordinate, and where the error lies. Returns the
        axes."""
        return plots.views(self)

    def __str__(self) -> str:
        test = self.residual_test
        lines = [f"Fit {self.fit_percent:.1f} %, error {self.rmse:.4g} (validation "
                 f"{self.rmse_validation:.4g})",
                 "Effects: " + (", ".join(self.effects) or "none"),
                 "Residual: " + ("white" if test.white else
                                 "not white: neighbouring errors are alike")
                 + ("; it still follows u" if test.follows_u else "; it does not follow u"),
                 *lines_of(self.recordings)]
        if not self.failures:
            lines.append("No place where the model fails more than elsewhere.")
        for one in self.failures:
            lines.append(f"  {100 * one.share_of_error:3.0f} % of the squared error in "
                         f"{100 * one.share_of_samples:.0f} % of the samples: {one.where}")
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Comparison fit {self.fit_percent:.1f} %, error {self.rmse:.4g}>"

    def _repr_html_(self) -> str:
        rows = [(one.view, one.where, f"{100 * one.share_of_error:.0f} %",
                 f"{100 * one.share_of_samples:.0f} %") for one in self.failures]
        heads = ("view", "where it fails", "of the squared error", "of the samples")
        return "".join(map(paragraph, str(self).splitlines()[:3])) + (
            table(heads, rows) if rows else "")


@dataclass(frozen=True)
class Candidate:
    """What one effect, or a pair, would do for a model."""

    effect: str
    status: str  #: accepted, rejected, not_excited or undecided
    rmse_validation_before: float  #: units of the output
    rmse_validation_after: float
    error_reduction_percent: float  #: of the squared validation error, %
    p_value: float
    indistinguishable_from: list[str]
    would_split: str | None  #: the measurement that would tell them apart
    evidence: str  #: one sentence
    parameters: dict[str, Parameter]
    with_effects: list[str]  #: the partner, where only the pair helps
    phenomenological: bool
    kind: str | None = None  #: of a characteristic: "equal_percentage" …
    #: of a characteristic: its curve, the signal before and after it, units of u
    curve: list[list[float]] | None = None
    #: of the partners of the pair that is named, by effect
    partner_parameters: dict[str, dict[str, Parameter]] = field(default_factory=dict)

    @classmethod
    def of(cls, found: dict[str, Any]) -> Candidate:
        partners = {one["effect"]: parameters_of(one["parameters"])
                    for one in found.get("partners", [])}
        return fields_of(cls, found, parameters=parameters_of(found["parameters"]),
                         with_effects=found["with"], partner_parameters=partners)

    @property
    def name(self) -> str:
        """Its effect, with its partner."""
        return " with ".join([self.effect, *self.with_effects])

    def __str__(self) -> str:
        text = f"{self.status:<12} {self.name}: {self.evidence}"
        if self.status == "accepted":
            text += (" Validation error "
                     f"{percent_down(self.rmse_validation_before, self.rmse_validation_after)}.")
        if self.indistinguishable_from:
            text += (" This recording cannot tell it from "
                     + ", ".join(self.indistinguishable_from) + ".")
        if self.would_split and self.indistinguishable_from:
            text += f" What would: {self.would_split}."
        return text


def _frame(candidates: list[Candidate]) -> pd.DataFrame:
    import pandas as pd

    return pd.DataFrame(
        [(one.name, one.status, one.rmse_validation_before, one.rmse_validation_after,
          one.error_reduction_percent, one.p_value, ", ".join(one.indistinguishable_from),
          one.evidence) for one in candidates],
        columns=["effect", "status", "rmse_validation_before", "rmse_validation_after",
                 "error_reduction_percent", "p_value", "indistinguishable_from",
                 "evidence"])


def _table(candidates: list[Candidate]) -> str:
    return table(("effect", "status", "evidence"),
                 [(one.name, one.status, str(one).split(": ", 1)[1]) for one in candidates])


@dataclass(frozen=True)
class Searched:
    """Where a long recording was searched."""

    samples: int
    sample_period_s: float
    from_s: float  #: time of the first of them
    excerpt: bool  #: the stretch, of each recording, where u moves most

    @classmethod
    def of(cls, found: dict[str, Any]) -> Searched | None:
        """None where it was searched in all samples."""
        return fields_of(cls, found["searched"]) if found["searched"] else None


@dataclass(frozen=True, repr=False)
class Explanation(Answer):
    """Which effect a model lacks, or that none is missing."""

    complete: bool  #: False: the time or the search's own limit was up
    explained: bool  #: nothing is accepted, and what is left looks like noise
    rmse: float  #: units of the output
    rmse_validation: float
    noise_rmse: float  #: the part of the error that no model could explain
    candidates: list[Candidate]  #: best first
    recordings: list[RecordingFit]  #: what the model as it is makes of each
    searched: Searched | None  #: None: in all samples
    identify: ValveVerdict | None  #: None: of the stem, not asked for, or the time was up

    @classmethod
    def _of(cls, text: str) -> Explanation:
        found = Answer(text).to_dict()
        return fields_of(cls, found, json=text, recordings=recordings_of_fit(found),
                         searched=Searched.of(found), identify=ValveVerdict.of(found),
                         candidates=[Candidate.of(one) for one in found["candidates"]])

    @property
    def best(self) -> Candidate | None:
        """The accepted candidate that explains most."""
        accepted = self.candidates and self.candidates[0].status == "accepted"
        return self.candidates[0] if accepted else None

    @property
    def headline(self) -> str:
        """What is missing, in one sentence."""
        text = "" if self.complete else "Ended early: this is the best answer so far. "
        if self.best:
            return f"{text}What is missing: {self.best.name}."
        if self.explained:
            return text + _noise_is_left("Nothing is missing", self.identify)
        return (f"{text}More than noise is left, but no effect of the catalogue explains it "
                "beyond doubt.")

    def to_frame(self) -> pd.DataFrame:
        """The candidates, one row each, best first."""
        return _frame(self.candidates)

    def __str__(self) -> str:
        return "\n".join([self.headline, *(self.identify.lines() if self.identify else []),
                          f"Error {self.rmse:.4g}, validation {self.rmse_validation:.4g}, of "
                          f"which noise at most {self.noise_rmse:.4g}",
                          *lines_of(self.recordings),
                          *(f"  {one}" for one in self.candidates)])

    def __repr__(self) -> str:
        return f"<Explanation {self.headline}>"

    def _repr_html_(self) -> str:
        return paragraph(self.headline, strong=True) + _table(self.candidates)


@dataclass(frozen=True)
class LadderStep:
    """One step of the ladder; errors in units of the output."""

    effect: str  #: "process" for the first
    removed: bool  #: an earlier effect that a later one made superfluous
    on_the_way: bool  #: part of an exchange, which the steps after it complete
    rmse: float
    rmse_validation: float
    indistinguishable_from: list[str]

    @property
    def name(self) -> str:
        return ("without " if self.removed else "") + self.effect


def _told(steps: list[LadderStep]) -> list[tuple[str, LadderStep]]:
    """Names and steps; an exchange is one, whatever the errors on the way."""
    told: list[tuple[str, LadderStep]] = []
    came: list[str] = []
    gone: list[str] = []
    for step in steps:
        (gone if step.removed else came).append(step.effect)
        if step.on_the_way:
            continue
        name = ", ".join(came) or f"without {', '.join(gone)}"
        told.append((f"{name} instead of {', '.join(gone)}" if came and gone else name, step))
        came, gone = [], []
    return told


@dataclass(frozen=True, repr=False)
class Ladder(Answer):
    """Effects added until nothing more is accepted."""

    steps: list[LadderStep]  #: the start, then one for each effect
    effects: list[str]
    complete: bool  #: False: the time or the search's own limit was up
    explained: bool  #: what is left looks like noise
    rmse: float  #: units of the output
    rmse_validation: float
    fit_percent: float
    noise_rmse: float  #: the part of the error that no model could explain
    left: list[Candidate]  #: what the other effects would still do
    recordings: list[RecordingFit]  #: each for itself
    searched: Searched | None  #: None: in all samples; the fit is that of all of them
    identify: ValveVerdict | None  #: None: of the stem, not asked for, or the time was up
    model: Model

    @classmethod
    def _of(cls, text: str, model: Model) -> Ladder:
        found = Answer(text).to_dict()
        return fields_of(cls, found, json=text, model=model, searched=Searched.of(found),
                         recordings=recordings_of_fit(found), identify=ValveVerdict.of(found),
                         steps=[fields_of(LadderStep, one) for one in found["steps"]],
                         left=[Candidate.of(one) for one in found["left"]])

    def to_frame(self) -> pd.DataFrame:
        """The steps, one row each."""
        import pandas as pd

        return pd.DataFrame(
            [(one.name, one.rmse, one.rmse_validation,
              ", ".join(one.indistinguishable_from)) for one in self.steps],
            columns=["step", "rmse", "rmse_validation", "indistinguishable_from"])

    def plot(self) -> npt.NDArray[np.object_]:
        """The falling error above the noise. Returns the axes."""
        told = _told(self.steps)
        return plots.falling_error([name for name, _ in told],
                                   [one.rmse_validation for _, one in told],
                                   self.noise_rmse)

    @property
    def headline(self) -> str:
        """How it ended, in one sentence."""
        if not self.complete:
            return "Ended early: the best model so far."
        return (_noise_is_left("Explained", self.identify) if self.explained else
                "Not explained: what is left is more than noise, or an effect is in doubt.")

    def __str__(self) -> str:
        lines, before = [], 0.0
        for name, step in _told(self.steps):
            lines.append(f"  {name:<28} {step.rmse_validation:<10.4g} "
                         f"{percent_down(before, step.rmse_validation)}".rstrip())
            lines += [f"      or {other}: this recording cannot tell"
                      for other in step.indistinguishable_from]
            before = step.rmse_validation
        return "\n".join(["Validation error after each step", *lines,
                          f"Fit {self.fit_percent:.1f} %; noise about {self.noise_rmse:.4g}",
                          *lines_of(self.recordings), self.headline,
                          *(self.identify.lines() if self.identify else [])])

    def __repr__(self) -> str:
        return f"<Ladder {', '.join(self.effects) or 'no effects'}: {self.headline}>"

    def _repr_html_(self) -> str:
        rows = [(name, f"{one.rmse_validation:.4g}",
                 ", ".join(one.indistinguishable_from)) for name, one in _told(self.steps)]
        return paragraph(self.headline, strong=True) + table(
            ("step", "validation error", "cannot be told from"), rows)
