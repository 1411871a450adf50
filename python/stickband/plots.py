"""Plots by matplotlib, in the colours of the report. Each returns the axes that it drew."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .explanation import Comparison
    from .identification import Identification
    from .recording import Recording

Drawn = npt.NDArray[np.object_]

MEASURED, SETPOINT, TWO_PATH, VALVE = "#7b8592", "#a3abb6", "#2563eb", "#d9480f"
TRUTH, BAD, GRID, INK = "#2b8a3e", "#c92a2a", "#e2e5ea", "#1a1f26"
_PANEL_HEIGHT = 2.1  # inches


def _panels(count: int, height: float = _PANEL_HEIGHT, columns: int = 1,
            width: float = 9.0, **options: Any) -> Drawn:
    import matplotlib.pyplot as plt

    rows = -(-count // columns)
    _, axes = plt.subplots(rows, columns, figsize=(width, height * rows + 0.4),
                           squeeze=False, layout="constrained", **options)
    drawn: Drawn = axes.ravel()
    for axis in drawn:
        axis.grid(color=GRID, linewidth=0.8)
        axis.set_axisbelow(True)
        axis.spines[["top", "right"]].set_visible(False)
        axis.tick_params(colors=INK, labelsize=9)
    for axis in drawn[count:]:
        axis.set_visible(False)
    return drawn[:count]


def _time(seconds: float) -> tuple[str, float]:
    """A unit that suits the length, and its seconds."""
    for name, unit in (("s", 1.0), ("min", 60.0), ("h", 3600.0), ("days", 86400.0)):
        if seconds < 600 * unit or name == "days":
            return name, unit
    return "s", 1.0


def _over_time(axes: Drawn, t: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    name, unit = _time(float(t[-1] - t[0]))
    axes[-1].set_xlabel(f"time, {name}")
    axes[-1].margins(x=0.01)
    return t / unit


def _legend(axis: Axes) -> None:
    """Above the plot, where no line is."""
    handles, _ = axis.get_legend_handles_labels()
    if len(handles) > 1:
        axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(handles),
                    frameon=False, fontsize=9, borderaxespad=0.1)


def _named(name: str, unit: str | None) -> str:
    return f"{name}, {unit}" if unit else name


def recording(data: Recording) -> Drawn:
    """y with the setpoint above u with the valve position."""
    axes = _panels(2, sharex=True)
    t = _over_time(axes, data.t)
    for axis, name, beside, label in ((axes[0], "y", "sp", "setpoint"),
                                      (axes[1], "u", "x", "valve position x")):
        values, other = data.column(name), data.column(beside)
        if values is not None:
            axis.plot(t, values, color=MEASURED, linewidth=1.3, label=name)
        if other is not None:
            axis.plot(t, other, linewidth=1.0, label=label,
                      color=SETPOINT if beside == "sp" else TRUTH,
                      linestyle="--" if beside == "sp" else "-")
        axis.set_ylabel(_named(name, data.units.get(name)))
        _legend(axis)
    axes[0].set_title(data.name, loc="left", fontsize=11)
    return axes


def identification(result: Identification) -> Drawn:
    """u with the stem, y with the simulations, and what they leave."""
    s = result.signals
    models = [(label, values, ink) for label, values, ink in
              (("two-path model", s.y_two_path, TWO_PATH),
               ("physical valve", s.y_valve, VALVE)) if values is not None]
    axes = _panels(3 if models else 2, sharex=True)
    t = _over_time(axes, s.t)
    axes[0].plot(t, s.u, color=MEASURED, linewidth=1.3, label="controller output u")
    if s.stem is not None:
        axes[0].plot(t, s.stem, color=VALVE, linewidth=1.1, label="identified stem")
    axes[0].set_ylabel("u")
    axes[0].set_title(result.headline, loc="left", fontsize=11)
    if s.sp is not None:
        axes[1].plot(t, s.sp, color=SETPOINT, linewidth=1.0, linestyle="--",
                     label="setpoint")
    axes[1].plot(t, s.y, color=MEASURED, linewidth=2.0, alpha=0.7, label="measured y")
    for label, values, ink in models:
        axes[1].plot(t, values, color=ink, linewidth=1.1, label=label)
    axes[1].set_ylabel("y")
    if models:
        for label, values, ink in models:
            axes[2].plot(t, s.y - values, color=ink, linewidth=0.8, label=label)
        axes[2].axhline(0, color=INK, linewidth=0.8)
        axes[2].set_ylabel("residual")
    for axis in axes[:2]:
        _legend(axis)
    return axes


def valve(result: Identification) -> Drawn:
    """The identified stem over u, and y over u."""
    s = result.signals
    axes = _panels(2, height=4.0, columns=2)
    if s.stem is not None:
        low, high = float(s.u.min()), float(s.u.max())
        axes[0].plot([low, high], [low, high], color=SETPOINT, linestyle="--",
                     linewidth=1.0, label="a valve that follows")
        axes[0].plot(s.u, s.stem, color=VALVE, linewidth=0.9, label="identified stem")
        axes[0].set_ylabel("stem, units of u")
        _legend(axes[0])
    else:
        axes[0].text(0.5, 0.5, "no stem was identified", ha="center", color=MEASURED,
                     transform=axes[0].transAxes)
    axes[1].plot(s.u, s.y, color=MEASURED, linewidth=0.8)
    axes[1].set_ylabel("y")
    for axis in axes:
        axis.set_xlabel("u")
    return axes


def comparison(found: Comparison) -> Drawn:
    """Measured and simulated output above the residual."""
    axes = _panels(2, sharex=True)
    t = _over_time(axes, found.t)
    axes[0].plot(t, found.measured, color=MEASURED, linewidth=2.0, alpha=0.7,
                 label="measured")
    axes[0].plot(t, found.simulated, color=TWO_PATH, linewidth=1.1,
                 label="simulated from u alone")
    axes[0].set_ylabel("output")
    axes[0].set_title(f"fit {found.fit_percent:.1f} %", loc="left", fontsize=11)
    axes[1].plot(t, found.residual, color=TWO_PATH, linewidth=0.8)
    axes[1].axhline(0, color=INK, linewidth=0.8)
    axes[1].set_ylabel("residual")
    _legend(axes[0])
    return axes


def views(found: Comparison) -> Drawn:
    """Share of the squared error over each coordinate, beside that of the samples, and the
    mean residual; the views with the largest failures first."""
    order = [one.view for one in found.failures]
    shown = sorted((view for view in found.views if view.position.size > 1),
                   key=lambda view: order.index(view.view) if view.view in order else 99)
    axes = _panels(len(shown), columns=2, height=2.4)
    told: list[Any] = []
    for axis, view in zip(axes, shown):
        axis.set_title(view.view, loc="left", fontsize=10,
                       color=BAD if view.view in order else INK)
        axis.set_xlabel(view.coordinate, fontsize=9)
        if view.view == "frequency":
            axis.set_xscale("log")
            axis.plot(view.position, 100 * view.error_share, "o-", color=TWO_PATH,
                      linewidth=1.0, markersize=4)
            axis.set_ylabel("% of the squared error", fontsize=9)
            continue
        if view.view == "lag":
            bound = 1.96 * np.sqrt(view.sample_share[0])
            axis.axhspan(-bound, bound, color=GRID)
            axis.vlines(view.position, 0, view.mean, color=TWO_PATH, linewidth=2.0)
            axis.set_ylabel("correlation with u", fontsize=9)
            continue
        wide = float(np.min(np.diff(view.position)))
        axis.bar(view.position, 100 * view.error_share, 0.9 * wide, color=TWO_PATH,
                 alpha=0.35, label="share of the squared error")
        axis.step(view.position, 100 * view.sample_share, where="mid", color=MEASURED,
                  linewidth=1.0, label="share of the samples")
        axis.set_ylabel("%", fontsize=9)
        seen = np.where(view.sample_share > 0, view.mean, np.nan)
        beside = axis.twinx()
        beside.plot(view.position, seen, "o-", color=VALVE, linewidth=1.0, markersize=3,
                    label="mean residual")
        most = 1.1 * float(np.max(np.abs(view.mean))) or 1.0
        beside.set_ylim(-most, most)
        beside.set_ylabel("mean residual", fontsize=9, color=VALVE)
        beside.spines[["top"]].set_visible(False)
        beside.tick_params(labelsize=8, colors=VALVE)
        if view.view == "direction":
            axis.set_xticks([-1, 1], ["falling", "rising"])
        if not told:
            told = [*axis.get_legend_handles_labels()[0],
                    *beside.get_legend_handles_labels()[0]]
    if told:
        figure = axes[0].figure
        above = 0.35 / figure.get_figheight()  # inches of the legend
        figure.get_layout_engine().set(rect=(0, 0, 1, 1 - above))
        figure.legend(handles=told, loc="upper right", ncols=len(told), frameon=False,
                      fontsize=9)
    return axes


def falling_error(names: Sequence[str], errors: Sequence[float],
                  noise: float | None) -> Drawn:
    """The validation error after each step, with the part that is noise."""
    axes = _panels(1, height=3.0)
    axis = axes[0]
    places = np.arange(len(names))
    axis.bar(places, errors, 0.55, color=TWO_PATH, alpha=0.8)
    for place, error in zip(places, errors):
        axis.annotate(f"{error:.4g}", (place, error), ha="center", va="bottom", fontsize=9,
                      xytext=(0, 2), textcoords="offset points")
    if noise is not None and noise > 0:
        axis.axhline(noise, color=BAD, linewidth=1.2, linestyle="--",
                     label=f"of which noise, about {noise:.3g}")
        axis.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), frameon=False, fontsize=9)
    axis.set_xticks(places, [name.replace(" ", "\n").replace(":", ":\n") for name in names])
    axis.set_ylabel("validation error")
    axis.set_xlim(-0.5, len(names) - 0.5)
    axis.grid(visible=False, axis="x")
    axis.margins(y=0.12)
    return axes
