"""What functions are called with, as recordings."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Sequence, Union

import numpy.typing as npt

from . import _core
from .errors import WrongUsage
from .recording import Path, Recording

if TYPE_CHECKING:
    import pandas as pd

    from .simulation import SimulatedLoop

#: What stands for a recording: one, a path, a frame, a simulated loop.
Source = Union[Recording, Path, "pd.DataFrame", "SimulatedLoop"]


def is_signal(item: object) -> bool:
    """Whether it is one array of numbers."""
    if isinstance(item, (list, tuple)):
        return len(item) > 0 and all(isinstance(value, (int, float)) for value in item)
    return hasattr(item, "__array__") and getattr(item, "ndim", 1) == 1


def are_arrays(data: Sequence[Any]) -> bool:
    """Whether a function was called with u and y."""
    return len(data) == 2 and is_signal(data[0]) and is_signal(data[1])


def has_samples(item: object) -> bool:
    """Whether it is a recording already, at a sample period of its own."""
    return isinstance(item, Recording) or isinstance(getattr(item, "recording", None),
                                                     Recording)


def recording_of(item: Source, ts: float | None = None,
                 required: Sequence[str] = ("u", "y"),
                 loads: Sequence[str] = ()) -> Recording:
    """A recording of whatever stands for one."""
    if isinstance(item, (str, os.PathLike)):
        return Recording.read(item, ts=ts, required=required, loads=loads)
    if hasattr(item, "columns"):
        return Recording.from_frame(item, ts=ts, loads=loads)
    held = item if isinstance(item, Recording) else getattr(item, "recording", None)
    if isinstance(held, Recording):
        if ts is not None:
            raise WrongUsage("ts goes with arrays, files and frames: "
                             f"{held.name} has its sample period")
        if loads and not all(load in held.loads for load in loads):
            raise WrongUsage("loads are named where a recording is made: "
                             "Recording.read(path, loads=…)")
        return held
    raise WrongUsage("expected a recording, a path, a frame, or the arrays u and y, found "
                     + type(item).__name__)


def recordings_of(data: Sequence[Any], *, t: npt.ArrayLike | None = None,
                  ts: float | None = None, sp: npt.ArrayLike | None = None,
                  x: npt.ArrayLike | None = None,
                  required: Sequence[str] = ("u", "y"),
                  loads: Sequence[str] = ()) -> list[Recording]:
    """Recordings of what a function was called with: two arrays, or sources."""
    if are_arrays(data):
        return [Recording(data[0], data[1], t=t, ts=ts, sp=sp, x=x)]
    if len(data) == 1 and isinstance(data[0], (list, tuple)):
        data = data[0]
    if not data:
        raise WrongUsage("give a recording, a path, a frame, or the arrays u and y")
    if t is not None or sp is not None or x is not None:
        raise WrongUsage("t, sp and x go with the arrays u and y")
    return [recording_of(item, ts, required, loads) for item in data]


def refuse_twice(fitted: Sequence[Recording], judging: Sequence[Recording]) -> None:
    """What is given twice would count twice, or judge what was fitted to it."""
    seen: list[_core.Recording] = []
    for one in (*fitted, *judging):
        if any(held is one._held for held in seen):
            raise WrongUsage(f"{one.name} is named twice: it would count twice, or judge what "
                             "was fitted to it")
        seen.append(one._held)


def refuse_path_twice(data: Sequence[Any]) -> None:
    """The same for files, before they are read."""
    paths = [item for item in data
             if isinstance(item, (str, os.PathLike)) and os.path.exists(item)]
    for k, path in enumerate(paths):
        if any(os.path.samefile(path, other) for other in paths[:k]):
            raise WrongUsage(f"{os.fspath(path)} is named twice: it would count twice, or "
                             "judge what was fitted to it")
