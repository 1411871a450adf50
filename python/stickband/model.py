"""Models of a loop: a process and the physical effects in it."""
from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _core
from .answer import Answer, Parameter, fields_of, parameters_of, paragraph, table
from .errors import WrongUsage
from .explanation import Comparison, Explanation, Ladder, percent_down
from .recording import Path, Recording, Source, recording_of, recordings_of

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Effect:
    """One physical effect of a model."""

    effect: str  #: its code, "valve.stiction"
    parameters: dict[str, Parameter]
    phenomenological: bool  #: helps only at the edge of its physical range


@dataclass(frozen=True)
class HistoryStep:
    """How the error fell; free simulation, units of the output, None: not known."""

    effect: str  #: "process" for the start
    recording: str
    rmse_before: float | None
    rmse_after: float | None
    rmse_validation_before: float | None
    rmse_validation_after: float | None


@dataclass(frozen=True)
class Added(Answer):
    """What the last effect of a model brought, as ``stickband add`` says it."""

    effect: str
    rmse_before: float
    rmse_after: float
    rmse_validation_before: float
    rmse_validation_after: float
    parameters: dict[str, Parameter]

    def __str__(self) -> str:
        fall = percent_down(self.rmse_validation_before, self.rmse_validation_after)
        return "\n".join([f"Added {self.effect}: validation error "
                          f"{self.rmse_validation_before:.4g} to "
                          f"{self.rmse_validation_after:.4g}, {fall}",
                          *(f"  {name:<24} {one}" for name, one in self.parameters.items())])


@dataclass(frozen=True)
class EffectInfo:
    """An effect of the catalogue, in words."""

    code: str
    title: str
    signature: str  #: what is seen where a model lacks it, after "the residual "
    cure: str  #: what a technician does about it


@dataclass(frozen=True, repr=False)
class Model(Answer):
    """A model: it simulates the output from u alone. It does not change; what adds to it
    makes another one.

    A method that takes a recording uses the one that the model was fitted to where none is
    given. All of them release the interpreter's lock, and Ctrl-C ends them. Fits work on a
    copy of their own of the samples.

    Examples
    --------
    >>> import stickband
    >>> loop = stickband.simulate("stiction", seed=1)
    >>> textbook = Model.fit(loop)
    >>> textbook.explain().best.effect
    'valve.stiction'
    >>> print(textbook.add("valve.stiction").added)  # doctest: +ELLIPSIS
    Added valve.stiction: validation error 0.1294 to 0.03967, down 69.3 %
      deadband                 ... u
    ...
    """

    output: str  #: "y", or "x"
    process: dict[str, Parameter]
    effects: list[Effect]  #: in the order in which they were added
    initial_state: dict[str, Parameter]  #: belongs to the recording
    history: list[HistoryStep]
    fitted_to: str  #: name of the recording
    _recording: Recording | None = field(default=None, repr=False, compare=False)

    @classmethod
    def from_json(cls, text: str) -> Model:
        """A model from the text of a model file. Raises BadInput where it is none."""
        return cls._of(_core.parse_model(text), None)

    @classmethod
    def _of(cls, text: str, recording: Recording | None) -> Model:
        found = Answer(text).to_dict()
        return fields_of(
            cls, found, json=text, _recording=recording,
            process=parameters_of(found["process"]),
            effects=[fields_of(Effect, one, parameters=parameters_of(one["parameters"]))
                     for one in found["effects"]],
            initial_state=parameters_of(found["initial_state"]),
            history=[fields_of(HistoryStep, one) for one in found["history"]],
            fitted_to=found["recording"]["name"])

    @classmethod
    def fit(cls, *data: Any, effects: Sequence[str] = (), output: str = "y",
            t: npt.ArrayLike | None = None, ts: float | None = None,
            x: npt.ArrayLike | None = None, threads: int = 0) -> Model:
        """Fits a first-order process behind a linear valve, and ``effects``.

        Parameters
        ----------
        *data
            One recording, path, frame or simulated loop, or the arrays u and y of shape
            (n,) with ``t`` (s) or ``ts`` (s).
        effects : list of str
            Effects of the start, as :func:`effects` names them.
        output : str
            What is modelled: "y", or "x", the measured valve position.
        threads : int
            0: all cores. The answer is the same.
        """
        recording = cls._one(data, output, t=t, ts=ts, x=x)
        return cls._of(_core.fit(recording._held, output, list(effects), threads), recording)

    @classmethod
    def ladder(cls, *data: Any, effects: Sequence[str] = (), output: str = "y",
               within: float | None = None, t: npt.ArrayLike | None = None,
               ts: float | None = None, x: npt.ArrayLike | None = None,
               threads: int = 0) -> Ladder:
        """Explains and adds until nothing more is accepted.

        As :meth:`fit`; ``within`` (s) ends the search with the best answer so far. About a
        second for 2,000 samples and one effect, minutes where three or more are revised.
        The model is in ``.model``.
        """
        recording = cls._one(data, output, t=t, ts=ts, x=x)
        text, model = _core.ladder(recording._held, output, list(effects), threads, within)
        return Ladder._of(text, cls._of(model, recording))

    @classmethod
    def load(cls, path: Path) -> Model:
        """Reads a model file of ``stickband``. Raises BadInput where it is none."""
        return cls._of(_core.read_model(os.fspath(path)), None)

    def save(self, path: Path) -> None:
        """Writes the model file that ``stickband`` writes."""
        _core.save_model(self.json, os.fspath(path))

    def compare(self, recording: Source | None = None) -> Comparison:
        """Simulates freely and says where the error lies. On another recording than the
        one it was fitted to, only the initial state is estimated."""
        here = self._here(recording)
        return Comparison._of(*_core.compare(here._held, self.json), here, self.output)

    def explain(self, recording: Source | None = None, *, within: float | None = None,
                threads: int = 0) -> Explanation:
        """Says which effect is missing, or that none is. ``within`` (s) ends the search
        with the best answer so far."""
        here = self._here(recording)
        return Explanation._of(_core.explain(here._held, self.json, threads, within))

    def add(self, effect: str, recording: Source | None = None, *,
            threads: int = 0) -> Model:
        """The model with one more effect, everything fitted again; ``.added`` says what it
        brought. Raises DataCannotAnswer where the recording has no start for it."""
        here = self._here(recording)
        return self._of(_core.add(here._held, self.json, effect, threads), here)

    @property
    def added(self) -> Added | None:
        """What the last effect brought; None for a model without one."""
        text = _core.added(self.json)
        if not text:
            return None
        found = Answer(text).to_dict()
        return fields_of(Added, found, json=text,
                         parameters=parameters_of(found["parameters"]))

    def to_frame(self) -> pd.DataFrame:
        """All parameters: value, low, high (95 %), unit; by part and name."""
        import pandas as pd

        rows = [(part, name, one.value, one.low, one.high, one.unit)
                for part, name, one in self._parameters()]
        frame = pd.DataFrame(rows, columns=["part", "parameter", "value", "low", "high",
                                            "unit"])
        return frame.set_index(["part", "parameter"])

    def plot(self) -> npt.NDArray[np.object_]:
        """How the error fell, step by step. Returns the axes."""
        from . import plots

        steps = [(one.effect, one.rmse_validation_after) for one in self.history]
        return plots.falling_error([name for name, _ in steps],
                                   [float("nan") if e is None else e for _, e in steps], None)

    @staticmethod
    def _one(data: Sequence[Any], output: str, **given: Any) -> Recording:
        required = ("u", output if output in ("y", "x") else "y")
        found = recordings_of(data, required=required, **given)
        if len(found) != 1:
            raise WrongUsage(f"a model is fitted to one recording, found {len(found)}")
        return found[0]

    def _here(self, recording: Source | None) -> Recording:
        if recording is not None:
            return recording_of(recording, required=("u", self.output))
        if self._recording is None:
            raise WrongUsage("a model from a file needs the recording: model.compare(path)")
        return self._recording

    def _parameters(self) -> list[tuple[str, str, Parameter]]:
        found = [("process", name, one) for name, one in self.process.items()]
        for effect in self.effects:
            found += [(effect.effect, name, one) for name, one in effect.parameters.items()]
        return found

    def __str__(self) -> str:
        lines = [f"Model of {self.output} from u, {self.fitted_to}"]
        part = ""
        for here, name, one in self._parameters():
            if here != part:
                lines.append(f"  {here}")
                part = here
            lines.append(f"    {name:<24} {one}")
        return "\n".join(lines)

    def __repr__(self) -> str:
        codes = ", ".join(one.effect for one in self.effects) or "no effects"
        return f"<Model of {self.output} from u: {codes}>"

    def _repr_html_(self) -> str:
        return paragraph(f"Model of {self.output} from u, {self.fitted_to}", strong=True) + (
            table(("part", "parameter", "value (95 % interval)"), self._parameters()))


def effects() -> list[EffectInfo]:
    """The catalogue of physical effects.

    >>> [one.title for one in effects() if one.code == "valve.stiction"]
    ['stiction']
    """
    return [EffectInfo(*one) for one in _core.effects()]
