"""One door to every input: `open_input("clip:walk.npz")` gives a source of body frames.

Adding an input is one module with a class that meets `BodySource` and one line in `INPUTS`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from game.inputs.sensor_noise import SensorNoise
from kinect.source import BodySource


class InputError(ValueError):
    """An input that cannot be opened; the message is one sentence that names the valid forms."""


@dataclass(frozen=True)
class Input:
    """One kind of input.

    form: how to ask for it. opens: makes the source from what follows the colon and a seed. synthetic: the sensor model applies.
    """

    form: str
    opens: Callable[[str, int], BodySource]
    synthetic: bool = True


def open_input(spec: str, *, noise: float = 0.0, latency_s: float = 0.0, outliers: float = 0.0, seed: int = 0) -> BodySource:
    """The source that `spec` names; a synthetic one comes inside a `SensorNoise`, whose settings may change while it plays.

    Raises InputError where the spec is not valid or the recording cannot be read.
    """
    kind, _, argument = spec.partition(":")
    entry = INPUTS.get(kind)
    if entry is None:
        raise InputError(f"there is no input {spec!r}; valid: {valid_forms()}.")
    if bool(argument) != (":" in entry.form):
        raise InputError(f"the input {spec!r} does not have the form {entry.form}; valid: {valid_forms()}.")
    source = entry.opens(argument, seed)
    return SensorNoise(source, noise, latency_s, outliers, seed) if entry.synthetic else source


def valid_forms() -> str:
    """The forms a spec can take, as a list in words."""
    return ", ".join(entry.form for entry in INPUTS.values())


def _clip(argument: str, _seed: int) -> BodySource:
    from kinect.clip import ClipError, ClipSource

    try:
        return ClipSource(argument)
    except ClipError as fault:
        raise InputError(str(fault)) from fault


def _performer(argument: str, _seed: int) -> BodySource:
    from game.inputs.performer import Performer  # the motions take a moment to import; a recording needs none of it

    try:
        return Performer(argument)
    except ValueError as fault:
        raise InputError(str(fault)) from fault


def _puppet(_argument: str, _seed: int) -> BodySource:
    from game.inputs.puppet import Puppet

    return Puppet()


def _script(_argument: str, seed: int) -> BodySource:
    from game.inputs.puppet_script import ScriptedPuppet

    return ScriptedPuppet(seed)


def _auto(_argument: str, _seed: int) -> BodySource:
    from game.inputs.attached import greeting
    from game.inputs.puppet import Puppet

    return Puppet(greeting=greeting())


def _replay(argument: str, _seed: int) -> BodySource:
    from game.inputs.kinect_replay import replay

    return _depth(lambda: replay(argument))


def _wire(argument: str, _seed: int) -> BodySource:
    from game.inputs.kinect_replay import replay_through_driver

    return _depth(lambda: replay_through_driver(argument))


def _kinect(_argument: str, _seed: int) -> BodySource:
    from game.inputs.kinect_live import LiveKinect

    return LiveKinect()


def _depth(opens: Callable[[], BodySource]) -> BodySource:
    from kinect.depth.recording_format import DepthRecordingError

    try:
        return opens()
    except DepthRecordingError as fault:
        raise InputError(str(fault)) from fault


INPUTS: Final[Mapping[str, Input]] = {
    "clip": Input("clip:PATH", _clip, synthetic=False),
    "performer": Input("performer:NAME", _performer),
    "puppet": Input("puppet", _puppet),
    "script": Input("script", _script),
    "auto": Input("auto", _auto),
    "kinect": Input("kinect", _kinect, synthetic=False),
    "kinect-replay": Input("kinect-replay:PATH", _replay, synthetic=False),
    "kinect-wire": Input("kinect-wire:PATH", _wire, synthetic=False),
}
