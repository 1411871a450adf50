"""Finds sticking control valves in recordings of controller output u and process output y.

>>> import stickband
>>> loop = stickband.simulate("stiction", seed=1)
>>> stickband.identify(loop).verdict
'stiction'

Start with :func:`identify`; :class:`Model` says what else is in the loop. Numbers are those
of the program ``stickband``, and ``to_dict()`` is its JSON.
"""
from ._core import __version__
from .answer import Estimate, Parameter, PerStroke
from .detector import OscillationReport, oscillation
from .device import Event, Monitor, MonitorRun, Summary, monitor
from .errors import BadInput, DataCannotAnswer, StickbandError, WrongUsage
from .explanation import (Candidate, Comparison, Explanation, Ladder, RecordingFit,
                          Searched, ValveVerdict)
from .identification import Identification, identify
from .model import Added, Effect, EffectInfo, Model, effects
from .recording import Recording
from .simulation import SimulatedLoop, Truth, scenarios, simulate

read = Recording.read

__all__ = [
    "Added", "BadInput", "Candidate", "Comparison", "DataCannotAnswer", "Effect",
    "EffectInfo", "Estimate", "Event", "Explanation", "Identification", "Ladder", "Model",
    "Monitor", "MonitorRun", "OscillationReport", "Parameter", "PerStroke", "Recording",
    "RecordingFit", "Searched", "SimulatedLoop", "StickbandError", "Summary", "Truth",
    "ValveVerdict", "WrongUsage", "__version__", "effects", "identify", "monitor",
    "oscillation", "read", "scenarios", "simulate",
]
