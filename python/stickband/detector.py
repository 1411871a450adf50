"""Does a signal oscillate?"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from . import _core
from .answer import Answer, fields_of
from .errors import WrongUsage
from .recording import Recording, samples_of
from .sources import is_signal, recording_of


@dataclass(frozen=True)
class OscillationReport(Answer):
    """What :func:`oscillation` says."""

    detected: bool
    regularity: float  #: above 1 the signal oscillates
    cycles: int  #: of the present oscillation, or of the last one
    period_s: float | None  #: s; None: no oscillation
    amplitude: float | None  #: of the fundamental wave, units of the signal

    def __str__(self) -> str:
        if not self.detected:
            return (f"No oscillation. Regularity {self.regularity:.2f}; above 1 it would be "
                    "one.")
        return (f"It oscillates: period {self.period_s:.4g} s, amplitude "
                f"{self.amplitude:.3g}, regularity {self.regularity:.1f} (above 1 is an "
                f"oscillation), {self.cycles} cycles.")


def oscillation(data: Any, *, ts: float | None = None, column: str = "u",
                t: npt.ArrayLike | None = None) -> OscillationReport:
    """Tells whether one signal oscillates.

    Parameters
    ----------
    data
        The signal, an array of shape (n,) with ``ts``; or a recording, path or frame of
        which ``column`` is taken.
    ts : float, s
        Sample period.
    column : str
        u, y, sp or x.
    t : array of shape (n,), s
        Times of the signal, instead of ``ts``.

    Periods of 4 to 500 samples are seen. The array is read where it lies.

    Examples
    --------
    >>> import numpy as np
    >>> report = oscillation(np.sin(np.arange(1000) * 2 * np.pi / 40), ts=0.5)
    >>> report.detected, report.period_s
    (True, 20.0)
    """
    if is_signal(data) and t is None:
        if ts is None or not ts > 0:
            raise WrongUsage("give ts, the sample period in seconds, or t, the times")
        values, period_s = samples_of("values", data), float(ts)
    else:
        if t is not None and not is_signal(data):
            raise WrongUsage("t goes with an array")
        recording = (Recording(data, t=t, ts=ts) if is_signal(data)
                     else recording_of(data, ts, (column,)))
        found = recording.column("u" if is_signal(data) else column)
        if found is None:
            raise WrongUsage(f"no column '{column}' in {recording.name}")
        values, period_s = found, recording.period_s
    text = _core.oscillation(values, period_s)
    return fields_of(OscillationReport, Answer(text).to_dict(), json=text)
