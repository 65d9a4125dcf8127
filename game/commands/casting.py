"""Who plays: inputs and characters by their names, put on a scene."""

from game.characters.body_plan import BodyPlan, BodyPlanError, load_body_plan
from game.commands import BadInput
from game.inputs.open_input import InputError, open_input
from game.inputs.puppet import puppet_of
from game.inputs.puppet_controls import PuppetControls
from game.scenes.registry import SCENES, PlayableScene
from game.tunables import Settings
from kinect.source import BodySource


def body_plan(name: str) -> BodyPlan:
    """A character's plan by name; BadInput where it is not valid."""
    try:
        return load_body_plan(name)
    except BodyPlanError as fault:
        raise BadInput(str(fault)) from fault


class Casting:
    """Opens and reopens the input of a session; raises BadInput with one sentence where a name is not valid."""

    def __init__(self, spec: str, character: str, settings: Settings, seed: int) -> None:
        self.spec, self.character, self.seed = spec, character, seed
        self.settings = settings
        self._newest: BodySource | None = None
        self.plan = body_plan(character)
        self.open().close()

    def open(self) -> BodySource:
        """A fresh source with the sensor model's present settings."""
        settings = self.settings
        try:
            self._newest = open_input(
                self.spec,
                noise=settings.number("sensor.noise"),
                latency_s=settings.number("sensor.latency_s"),
                outliers=settings.number("sensor.outliers"),
                seed=self.seed,
            )
        except InputError as fault:
            raise BadInput(str(fault)) from fault
        return self._newest

    @property
    def controls(self) -> PuppetControls | None:
        """What keys and gamepad steer: the controls of the newest puppet, None where the input is none."""
        puppet = puppet_of(self._newest) if self._newest is not None else None
        return None if puppet is None else puppet.controls

    @controls.setter
    def controls(self, wanted: PuppetControls) -> None:
        puppet = puppet_of(self._newest) if self._newest is not None else None
        if puppet is not None:
            puppet.controls = wanted

    def default_scene(self) -> str:
        """`mirror` for a recording or a performer, else `duel`."""
        return "mirror" if self.spec.startswith(("clip:", "performer:", "kinect")) else "duel"

    def scene(self, name: str) -> PlayableScene:
        """The scene, not yet entered; entering raises NoBodyError where the input shows nobody."""
        return SCENES[name](self.plan, self.open, self.settings, self.seed, self.spec)
