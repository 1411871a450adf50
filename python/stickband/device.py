"""The monitor of the device: sample by sample."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from .answer import Answer, PerStroke, fields_of, paragraph, table
from .errors import WrongUsage
from .recording import Recording, samples_of
from .sources import recordings_of

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Event(Answer):
    """Something that the monitor tells. What does not belong to its kind is None."""

    t: float  #: s, on the clock of the samples
    event: str  #: oscillation_started, oscillation_ended, stiction_raised,
    #: stiction_cleared, undecided, input_fault or input_restored
    period_s: float | None = None  #: of an oscillation, s
    verdict: str | None = None
    reason: str | None = None
    stick_band: PerStroke | None = None  #: units of u
    slip_jump: PerStroke | None = None  #: units of u
    fault: str | None = None

    @classmethod
    def of(cls, text: str) -> Event:
        found = Answer(text).to_dict()
        strokes = {key: PerStroke.of(found[key]) for key in ("stick_band", "slip_jump")
                   if key in found}
        return fields_of(cls, found, json=text, **strokes)

    def __str__(self) -> str:
        told = f"{self.t:12.1f} s  {self.event.replace('_', ' ')}"
        if self.event == "stiction_raised":
            return f"{told}, stick band {self.stick_band}"
        if self.event.startswith("oscillation"):
            return f"{told}, period {self.period_s:.4g} s"
        return told + "".join(f": {text}" for text in (self.reason, self.fault) if text)


@dataclass(frozen=True)
class Summary(Answer):
    """How things stand with the monitor."""

    verdict: str
    reason: str
    stiction_raised: bool  #: the alarm
    stick_band: PerStroke  #: of the last window, units of u
    slip_jump: PerStroke
    samples: int  #: pushed
    evaluations: int  #: of windows
    ram_bytes: int  #: of the monitor
    worst_step_us: float  #: longest step on this machine
    model_gap: dict[str, Any]  #: what its model lacks

    @classmethod
    def of(cls, text: str) -> Summary:
        found = Answer(text).to_dict()
        return fields_of(cls, found, json=text,
                         stick_band=PerStroke.of(found["stick_band"]),
                         slip_jump=PerStroke.of(found["slip_jump"]))

    def __str__(self) -> str:
        band = f"\nStick band {self.stick_band} (units of u)" if self.stick_band.known else ""
        return (f"{self.verdict}: {self.reason}{band}\n{self.samples} samples, "
                f"{self.evaluations} windows evaluated; the flag is "
                + ("raised." if self.stiction_raised else "down."))


class Monitor:
    """The object that runs on the device: single precision, a window of 2048 samples.

    Parameters
    ----------
    ts : float, s
        Nominal sample period.
    span : (float, float), units of u
        Span of u, for the limit of the alarm.
    gain_sign : int
        1 or -1: known sign of the process gain.
    longest_hold : int
        Missing samples that are filled.
    evaluate_every_pct : int, %
        New samples until the window is evaluated again, of the window.
    memory_pct : int, %
        Share of what earlier windows said that counts a window later.
    first_cycles : int
        Cycles until the first evaluation.

    ``push`` a sample, ``step`` as long as there is work and time, read ``events``; or
    ``feed`` arrays, which does all of it. One thread at a time.

    Examples
    --------
    >>> import stickband
    >>> loop = stickband.simulate("paper-example-1", seed=1)
    >>> monitor = stickband.Monitor(ts=loop.period_s)
    >>> monitor.feed(loop.t, loop.u, loop.y, loop.sp)
    >>> [event.event for event in monitor.events()]
    ['oscillation_started', 'stiction_raised']
    """

    #: Memory of one monitor of the device, bytes.
    ram_bytes: int = _core.Monitor.ram_bytes

    def __init__(self, ts: float, span: tuple[float, float] = (0, 100),
                 **settings: int) -> None:
        if not (np.isfinite(ts) and ts > 0):
            raise WrongUsage("the sample period must be a positive number of seconds")
        if not span[0] < span[1]:
            raise WrongUsage("span: the low end must be below the high one")
        try:
            self._held = _core.Monitor(ts, span, **settings)
        except TypeError as error:
            raise WrongUsage("settings are gain_sign, longest_hold, evaluate_every_pct, "
                             "memory_pct and first_cycles, whole numbers; found "
                             + ", ".join(map(str, settings))) from error

    def push(self, t: float, u: float, y: float, sp: float | None = None) -> str:
        """Takes a sample at ``t`` (s). Says what the window did with it: accepted, gap,
        repeat, non_finite or time_back."""
        return self._held.push(t, u, y, sp)

    def step(self, budget: int = 20) -> bool:
        """Goes on with the evaluation by ``budget`` units of some 100,000 instructions of
        the device. True while there is work."""
        return self._held.step(budget)

    def feed(self, t: npt.ArrayLike, u: npt.ArrayLike, y: npt.ArrayLike,
             sp: npt.ArrayLike | None = None) -> None:
        """Pushes arrays of shape (n,), t in s, each sample with all the work that it makes
        due. Arrays of doubles are read where they lie."""
        self._held.feed(samples_of("t", t), samples_of("u", u), samples_of("y", y),
                        None if sp is None else samples_of("sp", sp))

    def end_recording(self) -> None:
        """A recording ends here: what is left is evaluated where it is enough."""
        self._held.end_recording()

    def events(self) -> list[Event]:
        """Events that have not been read, oldest first."""
        return [Event.of(text) for text in self._held.events()]

    def summary(self) -> Summary:
        """How things stand."""
        return Summary.of(self._held.summary())

    @property
    def busy(self) -> bool:
        """True while an evaluation is due or going on."""
        return self._held.busy

    def __repr__(self) -> str:
        return f"<Monitor {self.summary().verdict}, {self.ram_bytes} bytes>"


@dataclass(frozen=True, repr=False)
class MonitorRun:
    """A recording fed to the monitor."""

    events: list[Event]
    summary: Summary

    def to_dicts(self) -> list[dict[str, Any]]:
        """Exactly the lines of ``stickband monitor --json``."""
        return [*(event.to_dict() for event in self.events), self.summary.to_dict()]

    def to_frame(self) -> pd.DataFrame:
        """The events, one row each."""
        import pandas as pd

        return pd.DataFrame([(one.t, one.event, one.verdict, one.period_s,
                              one.reason or one.fault) for one in self.events],
                            columns=["t", "event", "verdict", "period_s", "reason"])

    def __str__(self) -> str:
        return "\n".join([*map(str, self.events), str(self.summary)])

    def __repr__(self) -> str:
        return f"<MonitorRun {len(self.events)} events, {self.summary.verdict}>"

    def _repr_html_(self) -> str:
        rows = [(f"{one.t:.1f} s", str(one).split("s  ", 1)[1]) for one in self.events]
        return paragraph(str(self.summary), strong=True) + table(("time", "event"), rows)


def monitor(*data: Any, t: npt.ArrayLike | None = None, ts: float | None = None,
            sp: npt.ArrayLike | None = None,
            span: tuple[float, float] | None = None) -> MonitorRun:
    """Feeds a recording to the monitor of the device, as ``stickband monitor``.

    Parameters
    ----------
    *data
        One recording, path, frame or simulated loop, or the arrays u and y of shape (n,)
        with ``t`` (s) or ``ts`` (s).
    span : (float, float), units of u
        Span of u for the limit of the alarm; its range in the recording by default.

    Examples
    --------
    >>> import stickband
    >>> run = stickband.monitor(stickband.simulate("paper-example-1", seed=1))
    >>> run.summary.verdict
    'stiction'
    """
    found = recordings_of(data, t=t, ts=ts, sp=sp)
    if len(found) != 1:
        raise WrongUsage(f"the monitor is fed with one recording, found {len(found)}")
    return _run(found[0], span)


def _run(recording: Recording, span: tuple[float, float] | None) -> MonitorRun:
    u, y = recording.u, recording.y
    if u is None or y is None:
        raise WrongUsage(f"{recording.name} lacks u or y")
    low, high = span or (float(u.min()), float(u.max()))
    if span is not None and not low < high:
        raise WrongUsage("span: the low end must be below the high one")
    device = Monitor.__new__(Monitor)
    device._held = _core.Monitor(recording.period_s, (low, high))
    device.feed(recording.t, u, y, recording.sp)
    device.end_recording()
    return MonitorRun(device.events(), device.summary())
