"""Models of a loop: a process and the physical effects in it."""
from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core, plots
from .answer import Answer, Parameter, fields_of, parameters_of, paragraph, table
from .errors import WrongUsage
from .explanation import (Comparison, Explanation, Ladder, RecordingFit, lines_of,
                          percent_down, recordings_of_fit)
from .recording import Path, Recording
from .sources import (Source, are_arrays, has_samples, recording_of, recordings_of,
                      refuse_path_twice, refuse_twice)

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True)
class Effect:
    """One physical effect of a model."""

    effect: str  #: its code, "valve.stiction"
    parameters: dict[str, Parameter]
    phenomenological: bool  #: helps only at the edge of its physical range
    kind: str | None = None  #: of a characteristic: "equal_percentage" …
    #: of a characteristic: its curve, the signal before and after it, units of u
    curve: list[list[float]] | None = None
    untold: bool = False  #: uncertain: its intervals reach to where it would be absent


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
    recordings: list[RecordingFit]  #: each for itself; empty for a model from a file

    def __str__(self) -> str:
        fall = percent_down(self.rmse_validation_before, self.rmse_validation_after)
        return "\n".join([f"Added {self.effect}: validation error "
                          f"{self.rmse_validation_before:.4g} to "
                          f"{self.rmse_validation_after:.4g}, {fall}",
                          *(f"  {name:<24} {one}" for name, one in self.parameters.items()),
                          *lines_of(self.recordings)])


@dataclass(frozen=True)
class EffectInfo:
    """An effect of the catalogue, in words."""

    code: str
    title: str
    signature: str  #: what is seen where a model lacks it, after "the residual "
    cure: str  #: what a technician does about it


#: One recording that judges, or several.
Judging = Union[Source, Sequence[Source]]


@dataclass(frozen=True)
class _Loop:
    """What a model is held against."""

    joined: Recording  # of all
    fitted: tuple[Recording, ...]
    judging: tuple[Recording, ...]

    def beside(self, identify: bool) -> list[_core.Recording]:
        return [one._held for one in self.fitted] if identify else []


@dataclass(frozen=True, repr=False)
class Model(Answer):
    """A model: it simulates the output from u alone. It does not change; what adds to it
    makes another one.

    A method takes recordings, several of one loop together: one valve and one process with
    an initial state for each. Where none is given it uses those that the model was fitted
    to. ``validate`` are recordings that judge: nothing is fitted to them but their initial
    states. All methods release the interpreter's lock; Ctrl-C ends them.
    They work on a copy of their own of the samples.

    Examples
    --------
    >>> import stickband
    >>> loop = stickband.simulate("stiction", seed=1)
    >>> textbook = Model.fit(loop)
    >>> textbook.explain().best.effect
    'valve.stiction'
    >>> print(textbook.add("valve.stiction").added)  # doctest: +ELLIPSIS
    Added valve.stiction: validation error 0.1407 to 0.03976, down 71.7 %
      deadband                 ... u
    ...
    """

    output: str  #: "y", or "x"
    process: dict[str, Parameter]
    effects: list[Effect]  #: in the order in which they were added
    initial_state: dict[str, Parameter]  #: belongs to the recording
    history: list[HistoryStep]
    fitted_to: str  #: name of the recording
    _loop: _Loop | None = field(default=None, repr=False, compare=False)
    _added: str = field(default="", repr=False, compare=False)

    @classmethod
    def from_json(cls, text: str) -> Model:
        """A model from the text of a model file. Raises BadInput where it is none."""
        return cls._of(_core.parse_model(text), None)

    @classmethod
    def _of(cls, text: str, loop: _Loop | None, added: str = "") -> Model:
        found = Answer(text).to_dict()
        return fields_of(
            cls, found, json=text, _loop=loop, _added=added,
            process=parameters_of(found["process"]),
            effects=[fields_of(Effect, one, parameters=parameters_of(one["parameters"]))
                     for one in found["effects"]],
            initial_state=parameters_of(found["initial_state"]),
            history=[fields_of(HistoryStep, one) for one in found["history"]],
            fitted_to=found["recording"]["name"])

    @classmethod
    def fit(cls, *data: Any, validate: Judging = (), effects: Sequence[str] = (),
            output: str = "y", t: npt.ArrayLike | None = None, ts: float | None = None,
            x: npt.ArrayLike | None = None, loads: Sequence[str] = (),
            threads: int = 0) -> Model:
        """Fits a first-order process behind a linear valve, and ``effects``.

        Parameters
        ----------
        *data
            Recordings, paths, frames or simulated loops, one or several of one loop; or the
            arrays u and y of shape (n,) with ``t`` (s) or ``ts`` (s).
        validate
            One of those, or a list: they judge and are not fitted.
        effects : list of str
            Effects of the start, as :func:`effects` names them.
        output : str
            What is modelled: "y", or "x", the measured valve position.
        loads : list of str
            Further measured signals of files and frames, by name.
        threads : int
            0: all cores. The answer is the same.
        """
        loop = cls._together(data, validate, output, effects, t=t, ts=ts, x=x, loads=loads)
        return cls._of(_core.fit(loop.joined._held, output, list(effects), threads), loop)

    @classmethod
    def ladder(cls, *data: Any, validate: Judging = (), effects: Sequence[str] = (),
               output: str = "y", within: float | None = None, identify: bool = True,
               t: npt.ArrayLike | None = None, ts: float | None = None,
               x: npt.ArrayLike | None = None, loads: Sequence[str] = (),
               threads: int = 0) -> Ladder:
        """Explains and adds until nothing more is accepted.

        As :meth:`fit`; ``within`` (s) ends the search with the best answer so far;
        ``identify``: the verdict on the valve of the fitted recordings is told beside a
        model of y. About a second for 2,000 samples and one effect, minutes where three or
        more are revised. The model is in ``.model``.
        """
        loop = cls._together(data, validate, output, effects, t=t, ts=ts, x=x, loads=loads)
        text, model = _core.ladder(loop.joined._held, loop.beside(identify), output,
                                   list(effects), threads, within)
        return Ladder._of(text, cls._of(model, loop))

    @classmethod
    def load(cls, path: Path) -> Model:
        """Reads a model file of ``stickband``. Raises BadInput where it is none."""
        return cls._of(_core.read_model(os.fsencode(path)), None)

    def save(self, path: Path) -> None:
        """Writes the model file that ``stickband`` writes."""
        _core.save_model(self.json, os.fsencode(path))

    def compare(self, *data: Any, validate: Judging = ()) -> Comparison:
        """Simulates freely and says where the error lies. On other recordings than those
        it was fitted to, only the initial states are estimated."""
        here = self._here(data, validate).joined
        return Comparison._of(*_core.compare(here._held, self.json), here, self.output)

    def explain(self, *data: Any, validate: Judging = (), within: float | None = None,
                identify: bool = True, threads: int = 0) -> Explanation:
        """Says which effect is missing, or that none is. ``within`` (s) ends the search
        with the best answer so far; ``identify``: the verdict on the valve of the fitted
        recordings is told beside a model of y."""
        here = self._here(data, validate)
        return Explanation._of(_core.explain(here.joined._held, here.beside(identify),
                                             self.json, threads, within))

    def add(self, effect: str, *data: Any, validate: Judging = (),
            threads: int = 0) -> Model:
        """The model with one more effect, everything fitted again; ``.added`` says what it
        brought. Raises DataCannotAnswer where the recordings have no start for it."""
        here = self._here(data, validate, effect)
        model, added = _core.add(here.joined._held, self.json, effect, threads)
        return self._of(model, here, added)

    def remove(self, effect: str, *data: Any, validate: Judging = (),
               threads: int = 0) -> Model:
        """The model without one of its effects, the rest fitted again. Raises ValueError
        where the model lacks it."""
        here = self._here(data, validate)
        return self._of(_core.removed(here.joined._held, self.json, effect, threads), here)

    @property
    def added(self) -> Added | None:
        """What the last effect brought; None for a model without one."""
        text = self._added or _core.added(self.json)
        if not text:
            return None
        found = Answer(text).to_dict()
        return fields_of(Added, found, json=text, recordings=recordings_of_fit(found),
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
        steps = [(one.effect, one.rmse_validation_after) for one in self.history]
        return plots.falling_error([name for name, _ in steps],
                                   [float("nan") if e is None else e for _, e in steps], None)

    @staticmethod
    def _together(data: Sequence[Any], validate: Judging, output: str,
                  effects: Sequence[str], **given: Any) -> _Loop:
        judges = list(validate) if isinstance(validate, (list, tuple)) else [validate]
        several = len(data) == 1 and isinstance(data[0], (list, tuple))
        refuse_path_twice([*(data[0] if several else data), *judges])
        required = ("u", output if output in ("y", "x") else "y")
        fitted = recordings_of(data, required=required, **given)
        # Of arrays, ts is theirs alone.
        ts = None if are_arrays(data) else given.get("ts")
        judging = [recording_of(one, None if has_samples(one) else ts, required,
                                given.get("loads", ())) for one in judges]
        refuse_twice(fitted, judging)
        joined = _core.joined([one._held for one in fitted], [one._held for one in judging],
                              output, list(effects))
        return _Loop(Recording._of(joined), tuple(fitted), tuple(judging))

    def _here(self, data: Sequence[Any], validate: Judging, added: str = "") -> _Loop:
        # Loads that are effects of the model stay, whatever they are made of.
        effects = [one.effect for one in self.effects] + [added] * bool(added)
        if data:
            return self._together(data, validate, self.output, effects)
        if self._loop is None:
            raise WrongUsage("a model from a file needs the recording: model.compare(path)")
        if isinstance(validate, (list, tuple)) and not validate:
            if not added.startswith("disturbance.measured:"):
                return self._loop
            validate = self._loop.judging
        return self._together(self._loop.fitted, validate, self.output, effects)

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
