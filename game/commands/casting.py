"""Who plays: inputs and characters by their names, put on a scene."""

from game.characters.body_plan import BodyPlanError, load_body_plan
from game.commands import BadInput
from game.inputs.open_input import InputError, open_input
from game.scenes.fighter import NoBodyError
from game.scenes.registry import SCENES, PlayableScene
from game.tunables import Settings
from kinect.source import BodySource


class Casting:
    """Opens and reopens the input of a session; raises BadInput with one sentence where a name is not valid."""

    def __init__(self, spec: str, character: str, settings: Settings, seed: int) -> None:
        self.spec, self.character, self.seed = spec, character, seed
        self._settings = settings
        self.newest: BodySource | None = None
        try:
            self.plan = load_body_plan(character)
        except BodyPlanError as fault:
            raise BadInput(str(fault)) from fault
        self.open().close()

    def open(self) -> BodySource:
        """A fresh source with the sensor model's present settings."""
        settings = self._settings
        try:
            self.newest = open_input(
                self.spec,
                noise=settings.number("sensor.noise"),
                latency_s=settings.number("sensor.latency_s"),
                outliers=settings.number("sensor.outliers"),
                seed=self.seed,
            )
        except InputError as fault:
            raise BadInput(str(fault)) from fault
        return self.newest

    def default_scene(self) -> str:
        """`mirror` for a recording or a performer, else `duel`."""
        return "mirror" if self.spec.startswith(("clip:", "performer:")) else "duel"

    def scene(self, name: str) -> PlayableScene:
        """The scene, not yet entered; raises BadInput where the input shows nobody."""
        scene = SCENES[name](self.plan, self.open, self._settings, self.seed, self.spec)
        try:
            scene.enter()
        except NoBodyError as fault:
            raise BadInput(str(fault)) from fault
        return scene
