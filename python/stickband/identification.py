"""Does the valve stick, and by how much?"""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, plots
from .answer import Answer, PerStroke, fields_of, paragraph, table
from .recording import Samples
from .sources import recordings_of

if TYPE_CHECKING:
    import pandas as pd

#: Verdicts that say what the valve does; the others are ``undecided`` and ``bad_data``.
DECIDED = ("stiction", "backlash", "no_stiction")


@dataclass(frozen=True)
class Oscillation:
    """What the detector saw in u."""

    detected: bool
    period_s: float | None  #: s; None: no oscillation
    regularity: float  #: above 1 it oscillates
    cycles: float  #: in the window


@dataclass(frozen=True)
class DetectableBand:
    """The smallest stick band that the recording would have shown; None: none at all."""

    value: float | None  #: units of u
    percent_of_span: float | None  #: %, of the range of u


@dataclass(frozen=True)
class Window:
    """What one window of the recording says."""

    recording: int  #: from 1 on
    t: tuple[float, float]  #: its first and last sample, s
    verdict: str
    nats: float | None  #: closed-loop evidence; None: too short


@dataclass(frozen=True, eq=False)
class Path:
    """One stroke of the two-path model: valve position over u, piecewise linear."""

    knots: Samples  #: units of u, shape (k,)
    x: Samples  #: shape (k,)

    @classmethod
    def of(cls, found: dict[str, Any]) -> Path:
        return cls(np.asarray(found["knots"], float), np.asarray(found["x"], float))


@dataclass(frozen=True)
class TwoPathModel:
    """The paper's model: an ARX process behind one path for each stroke.

    Orders are None and lists empty where no process could be fitted.
    """

    na: int | None
    nb: int | None
    nk: int | None
    a: list[float]
    b: list[float]
    d: float | None
    ascending: Path
    descending: Path


@dataclass(frozen=True, eq=False)
class Signals:
    """The window that stands for the recording, and what the models make of it.

    Shape (n,) each, None where there is no such signal; times in s, u, x and stem in units
    of u, the others in those of y.
    """

    t: Samples
    u: Samples
    y: Samples
    sp: Samples | None = None
    x: Samples | None = None  #: recorded valve position
    y_two_path: Samples | None = None  #: free simulation of the two-path model
    y_valve: Samples | None = None  #: of the physical valve
    stem: Samples | None = None  #: its stem


@dataclass(frozen=True, repr=False, eq=False)  # by its JSON
class Identification(Answer):
    """What :func:`identify` says. ``print()`` it, or show it in a notebook."""

    verdict: str  #: stiction, backlash, no_stiction, undecided or bad_data
    reason: str  #: one sentence a technician understands
    cause: str | None  #: what moves the loop, where that can be told
    stick_band: PerStroke  #: travel of u after a reversal until the valve moves, units of u
    slip_jump: PerStroke  #: sudden travel when it breaks free, units of u
    oscillation: Oscillation
    detectable_band: DetectableBand
    evidence_nats: float | None  #: closed-loop evidence of all windows together
    windows: list[Window]
    fit_percent: float | None  #: free simulation of the two-path model, %
    fit_linear_percent: float | None  #: behind a valve that follows its signal, %
    fit_valve_percent: float | None  #: behind the physical valve, %
    aic: float | None
    aic_linear: float | None
    model: TwoPathModel
    notes: list[str]  #: what was done to the recording
    runtime_ms: float
    _held: _core.Identified = field(repr=False, compare=False)

    @classmethod
    def _of(cls, core: _core.Identified) -> Identification:
        found = Answer(core.json).to_dict()
        model = found["model"]
        return fields_of(
            cls, found, json=core.json, _held=core,
            stick_band=PerStroke.of(found["stick_band"]),
            slip_jump=PerStroke.of(found["slip_jump"]),
            oscillation=fields_of(Oscillation, found["oscillation"]),
            detectable_band=fields_of(DetectableBand, found["detectable_band"]),
            evidence_nats=found["evidence"]["nats"],
            windows=[fields_of(Window, one, t=tuple(one["t"]))
                     for one in found["evidence"]["windows"]],
            model=fields_of(TwoPathModel, model, ascending=Path.of(model["ascending"]),
                            descending=Path.of(model["descending"])))

    @property
    def decided(self) -> bool:
        """False where the data cannot answer: undecided, or bad_data."""
        return self.verdict in DECIDED

    @property
    def headline(self) -> str:
        """The verdict as one short sentence."""
        return self._held.headline

    @property
    def advice(self) -> str:
        """What to do next; "" where the reason itself says what data would tell."""
        return self._held.advice

    @property
    def signals(self) -> Signals:
        """The judged window with the models' simulations; computed when asked for."""
        return fields_of(Signals, self._held.simulate())

    def to_frame(self) -> pd.DataFrame:
        """Stick band and slip jump, a row for each stroke: value, low, high (95 %), in
        units of u, and the value in percent of the span of u."""
        import pandas as pd

        rows = {}
        for name, strokes in (("stick_band", self.stick_band),
                              ("slip_jump", self.slip_jump)):
            for stroke in ("ascending", "descending"):
                one = getattr(strokes, stroke)
                rows[name, stroke] = (one.value, one.low, one.high)
        frame = pd.DataFrame.from_dict(rows, orient="index", dtype=float,
                                       columns=["value", "low", "high"])
        frame.index = pd.MultiIndex.from_tuples(frame.index, names=["quantity", "stroke"])
        frame["percent_of_span"] = 100 * frame["value"] / self._held.span
        return frame

    def plot(self) -> npt.NDArray[np.object_]:
        """u with the stem, y with the simulations, and the residual, over time. Returns
        the axes."""
        return plots.identification(self)

    def plot_valve(self) -> npt.NDArray[np.object_]:
        """The stem over u, and y over u. Returns the axes."""
        return plots.valve(self)

    def __str__(self) -> str:
        return self._held.text.rstrip("\n")

    def __repr__(self) -> str:
        band = f", stick band {self.stick_band}" if self.stick_band.known else ""
        return f"<Identification {self.verdict}{band}>"

    def _repr_html_(self) -> str:
        rows = [(f"{name}, {stroke}", getattr(strokes, stroke))
                for name, strokes in (("stick band", self.stick_band),
                                      ("slip jump", self.slip_jump))
                for stroke in ("ascending", "descending") if strokes.known]
        numbers = table(("units of u", "value (95 % interval)"), rows) if rows else ""
        return "".join([paragraph(self.headline, strong=True), numbers,
                        paragraph(self.reason),
                        paragraph(self.advice) if self.advice else "",
                        *(paragraph("Note: " + note) for note in self.notes)])


def identify(*data: Any, t: npt.ArrayLike | None = None, ts: float | None = None,
             sp: npt.ArrayLike | None = None,
             x: npt.ArrayLike | None = None) -> Identification:
    """Tells whether the valve sticks, and how much, from u and y.

    Parameters
    ----------
    *data
        The arrays u (controller output) and y (process output), of shape (n,), with ``t``
        or ``ts``; or one recording or several of one loop, which are judged together: a
        :class:`Recording`, a path, a frame with the columns u and y, a simulated loop.
    t : array of shape (n,), s
        Times of the samples.
    ts : float, s
        Sample period, instead of times.
    sp, x : arrays of shape (n,)
        Setpoint (units of y), measured valve position (units of u).

    Returns
    -------
    Identification
        ``undecided`` is an answer, with its reason and what to record next.

    Raises
    ------
    BadInput
        A file or array that cannot be read; says where and what to do.

    Arrays of doubles are read where they lie; the interpreter's lock is released; Ctrl-C
    ends it. Some 0.2 s for 2,800 samples on one core.

    Examples
    --------
    >>> import stickband
    >>> loop = stickband.simulate("stiction", seed=1)
    >>> result = stickband.identify(loop.u, loop.y, ts=loop.period_s)
    >>> result.verdict
    'stiction'
    >>> loop.truth.stick_band["ascending"] in result.stick_band.ascending
    True
    >>> print(result.stick_band)
    144.23 (143.56 to 144.89) ascending, 144.2 (141.0 to 147.2) descending
    """
    recordings = recordings_of(data, t=t, ts=ts, sp=sp, x=x)
    return Identification._of(_core.Identified([one._held for one in recordings]))
