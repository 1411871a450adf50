"""Recordings of one control loop: from arrays, frames and files."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Hashable, Iterable, Mapping, NoReturn, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core, plots
from .errors import BadInput, WrongUsage

if TYPE_CHECKING:
    import pandas as pd

Samples = npt.NDArray[np.float64]
Path = Union[str, "os.PathLike[str]"]

_COLUMNS = ("t", "u", "y", "sp", "x")
# The contract's words for columns, as files have them.
_ALIASES = {"t": ("t",), "u": ("u", "op"), "y": ("y", "pv"), "sp": ("sp",),
            "x": ("x", "mv", "pos")}


def samples_of(name: str, values: npt.ArrayLike) -> Samples:
    """Doubles side by side: the very array where it is such."""
    if getattr(getattr(values, "dtype", None), "kind", None) in ("m", "M"):
        raise BadInput(f"array {name}: expected numbers, found dates or spans of time; take "
                       "seconds since the first one", f"array {name}", 0, 0, "numbers",
                       "dates or spans of time", "take seconds since the first one")
    try:
        if isinstance(values, np.ma.MaskedArray):  # what is masked is no number
            found: Samples = np.where(values.mask, np.nan,
                                      np.asarray(values, dtype=np.float64))
            return found
        return np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        kind = getattr(values, "dtype", type(values).__name__)
        raise BadInput(f"array {name}: expected numbers, found {kind}; convert them first, "
                       "as pandas.to_numeric() does", f"array {name}", 0, 0, "numbers",
                       str(kind), "convert them first") from error


def _require(frame: pd.DataFrame, column: Hashable) -> None:
    if column not in frame.columns:
        raise WrongUsage(f"no column '{column}' in the frame: it has "
                         + ", ".join(map(str, frame.columns)))


def _refuse_ambiguous(frame: str, key: str, fitting: Sequence[object]) -> NoReturn:
    found = "both " + " and ".join(f"'{column}'" for column in fitting[:2])
    advice = ("rename or remove one of them, or name the right one with "
              f"{key}='{fitting[0]}'")
    raise BadInput(f"{frame}: expected one column for {key}, found {found}; {advice}", frame,
                   0, 0, f"one column for {key}", found, advice)


class Recording:
    """Equally spaced samples of one loop.

    Parameters
    ----------
    u : array of shape (n,), units of u
        Controller output (OP).
    y : array of shape (n,), units of y
        Process output (PV).
    t : array of shape (n,), s
        Times, rising. What is not equally spaced is resampled by zero-order hold, and
        ``notes`` says so.
    ts : float, s
        Sample period, instead of ``t``.
    sp : array of shape (n,), units of y
        Setpoint.
    x : array of shape (n,), units of u
        Measured valve position.
    loads : mapping of name to array of shape (n,)
        Further measured signals. One that is made of the loop's own, as u in another unit,
        is no load: it is left out, and ``notes`` says so.

    Arrays of doubles that lie side by side are not copied: :attr:`u` is the very array
    that was passed. They have to stay as they are while the recording is used.

    Raises
    ------
    BadInput
        Values that are not finite, lengths that differ, times that do not rise.

    Examples
    --------
    >>> import numpy as np
    >>> u = np.sin(np.arange(200) / 10)
    >>> recording = Recording(u, 2 * u, ts=0.5)
    >>> recording.u is u
    True
    >>> print(recording)
    recording: 200 samples of u and y, one every 0.5 s
    """

    __slots__ = ("_held",)
    _held: _core.Recording

    def __init__(self, u: npt.ArrayLike | None = None, y: npt.ArrayLike | None = None, *,
                 t: npt.ArrayLike | None = None, ts: float | None = None,
                 sp: npt.ArrayLike | None = None, x: npt.ArrayLike | None = None,
                 loads: Mapping[str, npt.ArrayLike] | None = None,
                 name: str = "recording", units: Mapping[str, str] | None = None,
                 start: str = "") -> None:
        if (t is None) == (ts is None):
            raise WrongUsage("give either t, the times in seconds, or ts, the sample period")
        if ts is not None and not (np.isfinite(ts) and ts > 0):
            raise WrongUsage("the sample period must be a positive number of seconds")
        given = {"t": t, "u": u, "y": y, "sp": sp, "x": x}
        columns = [(key, samples_of(key, values)) for key, values in given.items()
                   if values is not None]
        self._held = _core.Recording(
            columns, [(key, samples_of(key, values)) for key, values in (loads or {}).items()],
            name, ts, list((units or {}).items()), start)

    @classmethod
    def _of(cls, core: _core.Recording) -> Recording:
        made = cls.__new__(cls)
        made._held = core
        return made

    @classmethod
    def read(cls, path: Path, *, ts: float | None = None, u: str = "", y: str = "",
             sp: str = "", x: str = "", time: str = "", loads: Sequence[str] = (),
             date_order: str = "", decimal: str = "", sheet: str = "",
             dbc: Path = "", config: Path = "", loop: int | None = None,
             u_before: float | None = None,
             required: Sequence[str] = ("u", "y")) -> Recording:
        """Reads what ``stickband`` reads: CSV, exports of historians, candump logs.

        Parameters
        ----------
        path : path
            The file.
        ts : float, s
            Sample period; replaces the column of times.
        u, y, sp, x, time : str
            Columns or tags by name, or ``"#3"`` for the third; with ``dbc``
            ``"MESSAGE.SIGNAL"``.
        loads : list of str
            Further measured signals; ``["all"]``: every one.
        date_order : str
            ``"dmy"``, ``"mdy"`` or ``"ymd"``: which number of 03/04/2026 is the day.
        decimal : str
            ``"point"`` or ``"comma"``: the decimal mark of numbers as 1.234; the other one
            groups thousands.
        sheet : str
            The sheet of a workbook, where several hold the columns.
        dbc, config, loop
            The file is a candump log, explained by a DBC file or by the gateway's own
            configuration.
        u_before : float, units of u
            Where u rested before the first row: for a step test that begins with its step.
        required : list of str
            Columns that it must have.

        Raises
        ------
        BadInput
            Names file, line and column, what was expected and found, and what to do.
        WrongUsage
            Arguments that do not go together, or name no column.

        The interpreter's lock is released; Ctrl-C ends it.
        """
        if u_before is not None and not np.isfinite(u_before):
            raise WrongUsage("u_before must be a finite number")
        options: dict[str, str | bytes] = {
            "u": u, "y": y, "sp": sp, "x": x, "time": time, "date_order": date_order,
            "decimal": decimal, "sheet": sheet, "dbc": os.fsencode(dbc),
            "config": os.fsencode(config)}
        return cls._of(_core.read(os.fsencode(path),
                                  [(key, text) for key, text in options.items() if text],
                                  ts, loop, list(loads), u_before, list(required)))

    @classmethod
    def from_frame(cls, frame: pd.DataFrame, *, u: Hashable = "", y: Hashable = "",
                   sp: Hashable = "", x: Hashable = "", t: Hashable = "",
                   ts: float | None = None, loads: Iterable[Hashable] = (),
                   name: str = "frame") -> Recording:
        """Columns of a pandas frame, without copies where they are doubles.

        Columns are taken by the names given, else by those of the contract: u or OP, y or
        PV, sp, x, MV or POS, t (s, or dates), without regard to case. Without t and ts the
        index must be dates. ``loads=["all"]``: every other column of numbers. Raises
        BadInput where two columns may be the one that is meant.
        """
        def called(key: str) -> list[Any]:
            return [column for column in frame.columns
                    if str(column).lower() in _ALIASES[key]]

        def column(key: str, given: Hashable) -> Any:
            if given != "":
                _require(frame, given)
                return given
            fitting = called(key)
            if len(fitting) > 1:
                _refuse_ambiguous(name, key, fitting)
            return fitting[0] if fitting else None

        taken: dict[str, Any] = {}
        used = []
        for key, given in (("u", u), ("y", y), ("sp", sp), ("x", x)):
            found = column(key, given)
            if found is not None:
                taken[key] = frame[found].to_numpy()
                used.append(found)
        time = None if ts is not None else column("t", t)
        start = ""
        kind = "" if time is None else getattr(frame[time].dtype, "kind", "")
        if kind == "m":
            taken["t"] = frame[time].dt.total_seconds().to_numpy()
        elif time is not None and kind != "M":
            taken["t"] = frame[time].to_numpy()
        elif ts is None:
            import pandas as pd

            index: Any = frame.index if time is None else pd.DatetimeIndex(frame[time])
            if not hasattr(index, "tz"):
                raise WrongUsage("no times: give t, a column in seconds, or ts, the sample "
                                 "period, or an index of dates")
            if len(index) > 0:
                taken["t"] = np.asarray((index - index[0]).total_seconds())
                start = index[0].isoformat()
            else:
                taken["t"] = np.empty(0)
        wanted = [*loads]
        if wanted == ["all"]:
            times = called("t") if time is None else [time]
            wanted = [other for other in frame.columns if other not in (*used, *times)
                      and getattr(frame[other].dtype, "kind", "") in "biuf"]
        for load in wanted:
            _require(frame, load)
        return cls(**taken, ts=ts, name=name, start=start,
                   loads={str(load): frame[load].to_numpy() for load in wanted})

    @property
    def t(self) -> Samples:
        """Times, s; shape (n,)."""
        return self._held.t

    @property
    def u(self) -> Samples | None:
        """Controller output, units of u; shape (n,)."""
        return self._held.u

    @property
    def y(self) -> Samples | None:
        """Process output, units of y; shape (n,)."""
        return self._held.y

    @property
    def sp(self) -> Samples | None:
        """Setpoint, units of y; shape (n,); None: not recorded."""
        return self._held.sp

    @property
    def x(self) -> Samples | None:
        """Valve position, units of u; shape (n,); None: not recorded."""
        return self._held.x

    @property
    def loads(self) -> dict[str, Samples]:
        """Further measured signals by name; shape (n,) each."""
        return self._held.loads

    @property
    def units(self) -> dict[str, str]:
        """Units of u, y, sp and x, as far as they are known."""
        return self._held.units

    @property
    def name(self) -> str:
        """File name without folders."""
        return self._held.name

    @property
    def period_s(self) -> float:
        """Sample period, s."""
        return self._held.period_s

    @property
    def start(self) -> str:
        """Clock time of the first sample, ISO 8601; "": unknown."""
        return self._held.start

    @property
    def notes(self) -> list[str]:
        """What was repaired while reading, one sentence each."""
        return self._held.notes

    def __len__(self) -> int:
        return len(self._held)

    def column(self, name: str) -> Samples | None:
        """``u``, ``y``, ``sp``, ``x`` or ``t`` by name."""
        if name not in _COLUMNS:
            raise WrongUsage(f"no column '{name}'")
        found: Samples | None = getattr(self._held, name)
        return found

    def part(self, from_s: float, to_s: float, name: str | None = None) -> Recording:
        """The samples from one time to another, s, both included. Arrays that were passed are
        not copied; what was read keeps its notes, and what was held in its gaps stays out of
        fits. ``name``: of the part; None: that of the whole.

        >>> import numpy as np
        >>> day = Recording(np.arange(100.0), np.arange(100.0), ts=2)
        >>> part = day.part(50, 99)
        >>> len(part), float(part.t[0]), np.shares_memory(part.u, day.u)
        (25, 50.0, True)
        """
        inside = slice(int(np.searchsorted(self.t, from_s)),
                       int(np.searchsorted(self.t, to_s, side="right")))
        called = self.name if name is None else name
        if inside.stop > inside.start + 1:
            held = self._held.part(inside.start, inside.stop - inside.start, called)
            if held is not None:
                return Recording._of(held)
        given: dict[str, Any] = {key: values[inside] for key in _COLUMNS
                                 if (values := self.column(key)) is not None}
        return Recording(**given, name=called, units=self.units,
                         loads={key: values[inside] for key, values in
                                (self.loads | self._held.own_readings).items()})

    def to_frame(self) -> pd.DataFrame:
        """A column each, with the times in s as index."""
        import pandas as pd

        columns = {key: self.column(key) for key in _COLUMNS[1:]}
        found = {key: values for key, values in columns.items() if values is not None}
        return pd.DataFrame({**found, **self.loads}, index=pd.Index(self.t, name="t"))

    def plot(self) -> npt.NDArray[np.object_]:
        """y with the setpoint above u, over time. Returns the axes."""
        return plots.recording(self)

    def __str__(self) -> str:
        names = [key for key in _COLUMNS[1:] if self.column(key) is not None]
        names += list(self.loads)
        told = " and ".join([", ".join(names[:-1])] * (len(names) > 1) + names[-1:])
        text = f"{self.name}: {len(self)} samples of {told}, one every {self.period_s:.6g} s"
        return "\n".join([text + (f", from {self.start}" if self.start else ""),
                          *(f"Note: {note}" for note in self.notes)])

    def __repr__(self) -> str:
        return f"<Recording {str(self).splitlines()[0]}>"
