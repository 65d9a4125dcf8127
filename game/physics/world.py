"""The physical world: characters on a floor, stepped with stable PD torques, metered, guarded and repeatable."""

import hashlib
from collections.abc import Sequence

import mujoco as mj
import numpy as np
from numpy.typing import NDArray

from game.characters.body_plan import BodyPlan
from game.characters.skeleton import PARTS
from game.control.joint_command import JointCommand
from game.physics.actuation import Actuation, settle_torque
from game.physics.dynamics import BodyDynamics
from game.physics.floor_skin import FloorSkin
from game.physics.guard import command_is_sound, unsound_characters
from game.physics.honesty import HonestyMeter, Push
from game.physics.model import build_model
from game.physics.state_ring import StateRing
from game.physics.step_close import note_state
from game.tunables import Settings

Floats = NDArray[np.float64]

FRAME_HZ = 60

TRAIL_STEPS = 64
"""So many states are hashed at a time."""

LIMP_S = 0.5
"""How long a character whose step failed takes no commands."""


def steps_per_frame(step_s: float) -> int:
    """Whole physics steps in a 60 Hz frame; the step is rounded so that they fill it exactly."""
    return max(1, round(1.0 / (FRAME_HZ * step_s)))


class World:
    """One MuJoCo world with its characters. `step` is the only way time passes."""

    def __init__(self, plans: Sequence[BodyPlan], settings: Settings) -> None:
        self._settings = settings
        self.steps_per_frame = steps_per_frame(settings.number("physics.step_s"))
        integrator = settings.choice("physics.integrator")
        self.model = build_model(
            plans,
            step_s=1.0 / (FRAME_HZ * self.steps_per_frame),
            integrator=integrator,
            friction=settings.number("physics.friction"),
            self_collision=settings.switch("physics.self_collision"),
        )
        self.data = mj.MjData(self.model)
        mj.mj_forward(self.model, self.data)
        # views: MuJoCo steps in place
        self._position, self._velocity = self.data.qpos, self.data.qvel
        self.characters = [BodyDynamics(self.model, self.data, plan, index) for index, plan in enumerate(plans)]
        self.actuation = Actuation(self.model, self.data, self.characters, explicit=integrator == "explicit")
        self.meter = HonestyMeter(self.model, self.data, self.characters)
        self.ring = StateRing(self.model, self.data)
        self._skin = FloorSkin(self.model, self.data, self.characters)
        self.step_count = 0
        self.guard_actions = 0
        self.faults: list[str] = []
        self._refreshed_at = -1
        self._pushes: list[tuple[int, Push]] = []
        self.stated_pushes: list[dict[str, object]] = []
        """Every push a scene stated: step, character, part, force (N), steps."""
        self._limp_until = [0] * len(plans)
        self._digest = hashlib.sha256()
        self._trail, self._trail_rows = np.empty((TRAIL_STEPS, self.model.nq + self.model.nv)), 0
        self._friction, self._settings_seen = settings.number("physics.friction"), settings.version
        self._rub_share = self.model.geom_friction[:, 0] / self._friction

    @property
    def step_s(self) -> float:
        return float(self.model.opt.timestep)

    def place(self, index: int, root_position: Floats, root_orientation: Floats, joint_rotation: Floats) -> None:
        """Put character `index` into a pose at rest; stated, so the meter goes on from there."""
        body = self.characters[index]
        self.data.qpos[body.coordinates] = np.concatenate((root_position, root_orientation, joint_rotation.reshape(-1)))
        self.data.qvel[body.dofs] = 0.0
        mj.mj_forward(self.model, self.data)
        self.meter.accept_state()
        self.refresh()

    def refresh(self) -> None:
        """Bring kinematics up to the present state, for control and drawing."""
        ends = self.meter.ends
        if self._refreshed_at == ends and self.meter.continues():
            return
        self._refreshed_at = ends if self.meter.continues() else -1
        mj.mj_kinematics(self.model, self.data)
        mj.mj_comPos(self.model, self.data)
        for body in self.characters:
            body.refresh()

    def command(self, index: int, command: JointCommand) -> None:
        """The joint command of character `index` from the next step on; an unsound one makes it limp until a sound one comes.

        After a step that failed it stays limp for a while: a body whose gains tear it apart falls, instead of hanging in the air.
        """
        if not command_is_sound(command):
            self._fault(index, "its joint command is not finite or not a rotation")
            self.actuation.relax(index)
        elif self.step_count >= self._limp_until[index]:
            self.actuation.set(index, command)

    def push(self, index: int, part: int, force: Floats, steps: int) -> None:
        """State a push: `force` (3,) N in the world at the centre of part `part`, for `steps` steps from now on."""
        body = self.characters[index].root_body + part
        force = np.asarray(force, dtype=np.float64)
        if force.shape != (3,) or not np.isfinite(force).all():
            raise ValueError(f"a push must be three finite numbers of newtons, not {force}.")
        self._pushes.append((self.step_count + steps, Push(index, body, force, np.zeros(3))))
        row = {"step": self.step_count, "character": index, "part": PARTS[part], "force_n": force.tolist(), "steps": steps}
        self.stated_pushes.append(row)

    def step(self) -> None:
        """Advance by one physics step."""
        meter = self.meter
        if self._settings.version != self._settings_seen:
            self._set_friction()
        if not meter.continues():
            self._mend(unsound_characters(self.characters, self._position, self._velocity))
            meter.record_written_state()
        pushes = self._apply_pushes() if self._pushes else []
        # after the pushes: a repeated step is to feel them too
        self.ring.push()
        self.actuation.apply()
        mj.mj_step(self.model, self.data)
        if not meter.close_step(self.actuation, pushes, self._trail, self._trail_rows):
            self._save_step(pushes)
        self._skin.thicken()
        self.step_count += 1
        self._trail_rows += 1
        if self._trail_rows == TRAIL_STEPS:
            self._hash_trail()

    def _save_step(self, pushes: list[Push]) -> None:
        """What is left of a step that the guard has to see to."""
        failed = unsound_characters(self.characters, self._position, self._velocity)
        if failed and not self._repeat(failed):
            settle_torque(*self.actuation.books[:2], self._velocity, *self.actuation.books[2:])
            self.meter.accept_state()
            note_state(self._position, self._velocity, self._trail, self._trail_rows)
        else:
            self.meter.close_step(self.actuation, pushes, self._trail, self._trail_rows, found_sound=True)

    @property
    def peak_torque(self) -> Floats:
        """(nv,) N m, the largest torque of each axis so far."""
        return self.actuation.peak_torque

    @property
    def state_sha256(self) -> str:
        """Over the float64 qpos and qvel of every step so far."""
        self._hash_trail()
        return self._digest.hexdigest()

    @property
    def warnings(self) -> int:
        """MuJoCo's own warnings so far."""
        return int(sum(w.number for w in self.data.warning))

    def _hash_trail(self) -> None:
        self._digest.update(self._trail[: self._trail_rows].data)
        self._trail_rows = 0

    def _set_friction(self) -> None:
        self._settings_seen = self._settings.version
        wanted = self._settings.number("physics.friction")
        if wanted != self._friction:
            self._friction = wanted
            self.model.geom_friction[:, 0] = wanted * self._rub_share
            self.model.pair_friction[:, :2] = wanted

    def _apply_pushes(self) -> list[Push]:
        """Write the pushes that still last; the point is the part's centre at the start of this step."""
        for _, push in self._pushes:
            self.data.xfrc_applied[push.body] = 0.0
        self._pushes = [(until, push) for until, push in self._pushes if until > self.step_count]
        mj.mj_kinematics(self.model, self.data)
        active = []
        for _, push in self._pushes:
            self.data.xfrc_applied[push.body, :3] += push.force
            active.append(Push(push.character, push.body, push.force, self.data.xipos[push.body].copy()))
        return active

    def _fault(self, index: int, what: str) -> None:
        self.guard_actions += 1
        if len(self.faults) < 100:
            self.faults.append(f"step {self.step_count}: character {index} goes limp, {what}")

    def _mend(self, broken: list[int]) -> None:
        """A state that somebody wrote and that is none: those characters go on, limp, from where the last step ended."""
        for index in broken:
            self._fault(index, "its state was not finite or out of all bounds; it goes on from the last sound one")
            self.meter.take_back(self.characters[index])
            self.actuation.relax(index)

    def _repeat(self, failed: list[int]) -> bool:
        """Roll the step back and take it again with the offenders limp, then at rest too; False where they could only be kept still."""
        for index in failed:
            self._fault(index, "its step failed and was repeated")
            self._limp_until[index] = self.step_count + round(LIMP_S / self.step_s)
            self.actuation.relax(index)
        limp_failed = self._take_again([])
        if not limp_failed:
            return True
        still_failing = self._take_again(limp_failed)
        for index in still_failing:
            body = self.characters[index]
            self.meter.take_back(body)
            self.data.qacc_warmstart[body.dofs] = 0.0
        return not still_failing

    def _take_again(self, at_rest: list[int]) -> list[int]:
        """The last step once more, some characters from rest; whom it fails for."""
        self.ring.restore()
        for index in at_rest:
            self.actuation.relax(index)
            self._velocity[self.characters[index].dofs] = 0.0
        self.meter.accept_state()
        self.actuation.apply()
        mj.mj_step(self.model, self.data)
        return unsound_characters(self.characters, self._position, self._velocity)
