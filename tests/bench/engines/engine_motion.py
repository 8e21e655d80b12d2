"""What every engine is asked to simulate."""

from dataclasses import dataclass, field
from typing import Callable, Optional

import numpy as np


@dataclass
class Motion:
    """`start`, `velocity`: n x 3, metres and metres per second; `step` in seconds."""

    start: np.ndarray
    velocity: np.ndarray
    step: float
    frames: int
    steps_per_frame: int = 1
    pins: np.ndarray = field(default_factory=lambda: np.zeros(0, int))
    # (time, masses) -> forces n x 3 in newtons
    force: Optional[Callable] = None
    # the acceleration, m/s2, where that is all that `force` does
    gravity: Optional[np.ndarray] = None


def frequency_of(signal, step):
    """The frequency (Hz) of a slowly decaying sine that starts at its largest value, from its zero crossings."""
    signal = np.asarray(signal) - 0.0
    at = np.flatnonzero(np.sign(signal[1:]) != np.sign(signal[:-1]))
    crossing = (at + signal[at] / (signal[at] - signal[at + 1])) * step
    if len(crossing) < 3:
        return float("nan")
    return (len(crossing) - 1) / (2 * (crossing[-1] - crossing[0]))
