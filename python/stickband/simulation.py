"""Simulated loops to practise on, with their truth."""
from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

from . import _core
from .answer import Answer, fields_of
from .recording import Path, Recording, Samples


@dataclass(frozen=True)
class Truth(Answer):
    """What a simulated loop is known to contain; ``to_dict()`` has all of it."""

    scenario: str
    seed: int
    kind: str  #: what the verdict ought to be
    cause: str  #: what moves the loop
    stick_band: dict[str, float]  #: by stroke, units of u
    slip_jump: dict[str, float]  #: by stroke, units of u
    noise_std: float  #: of the measurement, units of y


@dataclass(frozen=True, repr=False)
class SimulatedLoop:
    """A recording with its truth; signals have the shape (n,)."""

    recording: Recording
    truth: Truth
    period_s: float  #: sample period, s
    t: Samples  #: times, s
    u: Samples  #: controller output, units of u
    y: Samples  #: measured process output, units of y
    sp: Samples  #: setpoint, units of y
    x: Samples  #: true valve position, units of u
    y_clean: Samples  #: y from the stem alone: no noise, no load; units of y
    _held: _core.Simulated = field(repr=False, compare=False)

    def save(self, path: Path, with_position: bool = True) -> None:
        """Writes the CSV file of ``stickband simulate``; ``with_position``: column x, too."""
        self._held.save(os.fsencode(path), with_position)

    def __str__(self) -> str:
        return f"{self.recording}\nTruth: {self.truth.kind}, moved by {self.truth.cause}"

    def __repr__(self) -> str:
        return f"<SimulatedLoop {self.recording.name}: {self.truth.kind}>"


def simulate(scenario: str, seed: int = 1) -> SimulatedLoop:
    """Simulates a control loop with a known valve.

    Parameters
    ----------
    scenario : str
        One of :func:`scenarios`.
    seed : int
        From 0 on; the same scenario and seed make the same loop.

    Examples
    --------
    >>> loop = simulate("stiction", seed=1)
    >>> print(loop)
    stiction-1: 602 samples of u, y, sp and x, one every 3.1 s
    Truth: stiction, moved by stiction
    """
    core = _core.Simulated(scenario, seed)
    truth: dict[str, Any] = Answer(core.truth).to_dict()
    columns = {key: getattr(core, key) for key in ("t", "u", "y", "sp", "x")}
    recording = Recording(**columns, name=f"{scenario}-{seed}")
    return SimulatedLoop(recording, fields_of(Truth, truth, json=core.truth),
                         core.period_s, **columns, y_clean=core.y_clean, _held=core)


def scenarios() -> dict[str, str]:
    """Names of the scenarios, with one line each.

    >>> "paper-example-1" in scenarios()
    True
    """
    return dict(_core.scenarios())
