"""What all answers share: the program's JSON behind them, and estimates with intervals."""
from __future__ import annotations

import dataclasses
import html
import json
from dataclasses import dataclass, field
from typing import Any, Iterable, Mapping, TypeVar

from . import _core

T = TypeVar("T")


def fields_of(kind: type[T], found: Mapping[str, Any], **given: Any) -> T:
    """A dataclass of the keys it knows; the others are in ``to_dict()``."""
    known = {f.name for f in dataclasses.fields(kind)}
    taken = {key: value for key, value in found.items() if key in known}
    return kind(**{**taken, **given})


@dataclass(frozen=True)
class Answer:
    """An answer of the program, with names for what its JSON says."""

    json: str = field(repr=False)  #: the program's line of JSON

    def to_dict(self) -> dict[str, Any]:
        """Exactly what the program's ``--json`` says."""
        found: dict[str, Any] = json.loads(self.json)
        return found

    def to_json(self) -> str:
        """The same as one line of text, without a line feed."""
        return self.json.rstrip("\n")


@dataclass(frozen=True)
class Estimate:
    """A number with its 95 % interval; all None where the data cannot tell."""

    value: float | None
    low: float | None
    high: float | None

    @property
    def known(self) -> bool:
        """True where the data tell."""
        return self.value is not None

    def __str__(self) -> str:
        if self.value is None or self.low is None or self.high is None:
            return "unknown"
        value, interval = _core.estimate_text(self.value, self.low, self.high)
        return f"{value} ({interval})"

    def __contains__(self, value: float) -> bool:
        """True where the interval holds ``value``.

        >>> 5.1 in Estimate(5.0, 4.8, 5.2)
        True
        """
        if self.low is None or self.high is None:
            return False
        return self.low <= value <= self.high


@dataclass(frozen=True)
class PerStroke:
    """An estimate for each stroke.

    ``ascending``: before the valve moves with rising u; ``descending``: with falling u.
    """

    ascending: Estimate
    descending: Estimate

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> PerStroke:
        return cls(Estimate(**found["ascending"]), Estimate(**found["descending"]))

    @property
    def known(self) -> bool:
        """True where one stroke is known at least."""
        return self.ascending.known or self.descending.known

    def __str__(self) -> str:
        return f"{self.ascending} ascending, {self.descending} descending"


@dataclass(frozen=True)
class Parameter:
    """One number of a model: value, 95 % interval, unit, physical bounds."""

    value: float
    low: float | None
    high: float | None
    unit: str  #: "s", "u", "y", "y/u", or "1"
    bounds: tuple[float | None, float | None] = (None, None)  #: None: no bound

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> Parameter:
        return fields_of(cls, found, bounds=tuple(found["bounds"]))

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        if self.low is None or self.high is None or not self.low < self.high:
            return f"{self.value:.4g}{unit}"
        return f"{self.value:.4g} ({self.low:.4g} to {self.high:.4g}){unit}"


def parameters_of(found: Mapping[str, Any]) -> dict[str, Parameter]:
    return {name: Parameter.of(one) for name, one in found.items()}


def table(heads: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    """An HTML table; everything in it is escaped."""
    def row(tag: str, cells: Iterable[object]) -> str:
        inside = "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in cells)
        return f"<tr>{inside}</tr>"

    body = "".join(row("td", cells) for cells in rows)
    return f"<table><thead>{row('th', heads)}</thead><tbody>{body}</tbody></table>"


def paragraph(text: str, strong: bool = False) -> str:
    inside = html.escape(text)
    return f"<p><b>{inside}</b></p>" if strong else f"<p>{inside}</p>"
