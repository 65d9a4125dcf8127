"""Every number a player may turn: one declaration makes the slider, the settings file, `--set` and the docs."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

Value = float | bool | str


class TunableError(ValueError):
    """A name or value that no tunable accepts; the message says what would be valid."""


@dataclass(frozen=True)
class Tunable:
    """One number, switch or choice of the method.

    name: `group.what_unit`; default; low and high bound a number; unit; meaning in one sentence with its equation;
    choices: the valid words of a choice; log: the slider is logarithmic; restart: takes effect at the next start of the scene.
    """

    name: str
    default: Value
    meaning: str
    low: float = 0.0
    high: float = 1.0
    unit: str = ""
    choices: tuple[str, ...] = ()
    log: bool = False
    restart: bool = False

    @property
    def group(self) -> str:
        return self.name.split(".", 1)[0]

    @property
    def _in_unit(self) -> str:
        return f" {self.unit}" if self.unit else ""

    def parse(self, value: object) -> Value:
        """The value in this tunable's type; raises TunableError with one sentence that names what is valid."""
        if isinstance(self.default, bool):
            words = {"true": True, "on": True, "1": True, "yes": True, "false": False, "off": False, "0": False, "no": False}
            word = str(value).strip().lower()
            if word in words:
                return words[word]
            raise TunableError(f"{self.name} is a switch: {value!r} is not one of true, false.")
        if self.choices:
            if str(value) in self.choices:
                return str(value)
            raise TunableError(f"{self.name} cannot be {value!r}; valid: {', '.join(self.choices)}.")
        try:
            number = float(str(value))
        except ValueError:
            number = math.nan
        if not math.isfinite(number) or isinstance(value, bool):
            raise TunableError(f"{self.name} needs a number from {self.low:g} to {self.high:g}{self._in_unit}, not {value!r}.")
        if not self.low <= number <= self.high:
            raise TunableError(f"{self.name} must lie between {self.low:g} and {self.high:g}{self._in_unit}, not {number:g}.")
        return number


def _table(rows: Iterable[Tunable]) -> dict[str, Tunable]:
    table: dict[str, Tunable] = {}
    for row in rows:
        if row.name in table:
            raise ValueError(f"tunable {row.name} is declared twice")
        table[row.name] = row
    return table


# fmt: off
TUNABLES: Mapping[str, Tunable] = _table(
    [
        # input and intake
        Tunable("sensor.noise", 0.0, "scale of the Kinect v1 sensor model laid over a performer or puppet; 1 is a real sensor", 0.0, 2.0),
        Tunable("sensor.latency_s", 0.0, "delay of the sensor model between a pose and its frame", 0.0, 0.5, "s"),
        Tunable("sensor.outliers", 0.0, "scale of the sensor model's violent outliers; 1 is a real sensor", 0.0, 2.0),
        Tunable("intake.smoothing", 1.0, "strength of the Kinect SDK's joint smoothing; 1 is the SDK's default parameters, 0 off", 0.0, 2.0),
        Tunable("intake.mirror", True, "mirror left and right, so that the character faces you like a mirror image"),
        Tunable("intake.jump_limit_m", 0.35, "a root that moves farther between two frames is held as a sensor fault", 0.05, 2.0, "m"),
        # input gate: what the player can really have done
        Tunable("gate.on", True, "check what the player can have done: foot contacts, jumps, pelvis height, planted feet"),
        Tunable("gate.buffer_s", 0.0, "wait before a change of foot contact is believed; delays everything by as much", 0.0, 0.1, "s"),
        Tunable("gate.up_m", 0.04, "a foot this far above its rest is off the floor", 0.01, 0.15, "m"),
        Tunable("gate.down_m", 0.022, "a foot that was off the floor is back on it below this height", 0.005, 0.1, "m"),
        Tunable("gate.foot_speed_m_s", 0.6, "a foot faster than this lifts sooner and is not down yet", 0.1, 3.0, "m/s"),
        Tunable("gate.jumps", True, "both feet leave the floor only after a push-off, and not for long; off: whenever they seem to"),
        Tunable("gate.push_off_m_s", 0.5, "upward speed of the pelvis over standing feet that makes a jump possible", 0.0, 2.0, "m/s"),
        Tunable("gate.flight_limit_s", 0.6, "longest flight of a jump; after that the feet are back on the floor", 0.1, 1.5, "s"),
        Tunable("gate.floor_time_s", 1.0, "how slowly the height of a standing foot becomes its resting height", 0.05, 10.0, "s"),
        Tunable("gate.lock", True, "a planted foot stays where it is, on the floor"),
        Tunable("gate.plant_time_s", 0.33, "how slowly a planted foot drifts with the sensor", 0.0, 5.0, "s"),
        Tunable("gate.fade_time_s", 0.06, "how fast the lock lets go of a foot that lifts and brings one that lands to the floor", 0.0, 0.5, "s"),
        Tunable("gate.flat", True, "the sole of a planted foot is flat, however the sensor tilts it"),
        Tunable("gate.pelvis", True, "the pelvis is as high as ankles and leg lengths say, where the sensor lets it sink (a bow) or rise"),
        Tunable("gate.knees", True, "knees bend forward and lean no farther to the side than a thigh turns, however the sensor shows them"),
        Tunable("gate.leg_slack", 0.04, "share of a leg's length that may be missing before the pelvis is raised", 0.0, 0.3),
        Tunable("gate.tilt_rad_s", 4.0, "fastest tilt of pelvis and trunk; a deep bow makes the sensor flip between poses", 0.5, 50.0, "rad/s"),
        Tunable("gate.turn_rad_s", 5.0, "fastest turn of pelvis and shoulders; seen from the side their lines jump", 0.5, 50.0, "rad/s"),
        Tunable("gate.twist_rad", 0.6, "largest turn of the shoulders against the pelvis; where more is seen one of the two is wrong", 0.1, 3.2, "rad"),
        # kinematic target
        Tunable("ik.method", "dls", "inverse of the Jacobian: pseudoinverse (Eq. 3.2), dls (Eq. 3.3), sdls (Buss & Kim 2005), none", choices=("none", "pseudoinverse", "dls", "sdls")),
        Tunable("ik.damping", 0.4, "lambda of damped least squares, Eq. 3.3", 0.0, 1.2),
        Tunable("ik.pose_weight", 1.0, "w of null-space pose tracking, Eq. 3.5", 0.0, 1.0),
        Tunable("ik.target_clamp_m", 0.15, "longest step of an end-effector towards its target in one frame (Buss & Kim 2005)", 0.01, 1.0, "m"),
        # PD control
        Tunable("pd.kp_hat", 800.0, "stiffness of the first spine axis; all others follow by their ratio, Eq. 3.7 and 3.8 (not in whole-body)", 100.0, 3000.0, "N m/rad"),
        Tunable("pd.ratio", "dynamic", "gain ratios between the axes: dynamic (Eq. 3.8, from the pose) or manual (fixed) (not in whole-body)", choices=("dynamic", "manual")),
        Tunable("pd.gravity_feedforward", True, "add the torque that holds each joint against gravity, ankles left out (not in whole-body)"),
        # balance
        Tunable(
            "balance.strategy",
            "whole-body",
            "how the character keeps its feet: none, ankle (thesis 3.4.3), virtual-actuation: ankles helped by hips and knees, or whole-body: steps planned by the capture point, torques by optimisation",
            choices=("none", "ankle", "virtual-actuation", "whole-body"),
        ),
        Tunable("balance.w_com", 0.0, "COM target between above the COS (0) and the kinematic target's offset (1), Eq. 3.9 (not in whole-body)", 0.0, 1.0),
        Tunable("balance.w_vel", 0.4, "weight of the COM velocity compensation, Eq. 3.10 and 3.11 (not in whole-body)", 0.0, 1.0, "s"),
        Tunable("balance.ankle_clamp_rad", 0.1, "largest ankle error handed to the PD law, thesis 3.4.3 (not in whole-body)", 0.005, 0.5, "rad"),
        Tunable("balance.com_stiffness", 20.0, "acceleration of the COM per metre off its place over the COS (virtual-actuation)", 0.0, 100.0, "1/s^2"),
        Tunable("balance.com_damping", 8.0, "acceleration of the COM against its velocity (virtual-actuation)", 0.0, 30.0, "1/s"),
        Tunable("balance.pelvis_stiffness", 600.0, "torque of the standing hips per radian the pelvis is off its target (virtual-actuation)", 0.0, 3000.0, "N m/rad"),
        Tunable("balance.pelvis_damping", 60.0, "torque of the standing hips against the pelvis's spin (virtual-actuation)", 0.0, 300.0, "N m s/rad"),
        Tunable("whole_body.delay_s", 0.067, "how far behind the newest frame the pose is taken; the frames in between foretell where the weight goes", 0.0, 0.15, "s"),
        Tunable("whole_body.capture_rate", 5.0, "how fast the capture point is brought to where it should be", 1.0, 20.0, "1/s"),
        Tunable("whole_body.pose_stiffness", 400.0, "acceleration of a joint per radian off its target", 20.0, 1000.0, "1/s^2"),
        Tunable("whole_body.pose_damping", 35.4, "acceleration of a joint against its velocity error", 2.0, 100.0, "1/s"),
        Tunable("whole_body.pelvis_weight", 15.0, "weight of the pelvis's orientation among the tasks", 0.01, 100.0, log=True),
        Tunable("whole_body.spin_weight", 1.0, "weight of keeping angular momentum small", 0.0, 30.0),
        Tunable("whole_body.strength", 2.0, "scale of the torque limits; 1 is a young man of the body's mass (game/characters/strength.py), enough for the performers; what a sensor sees asks for more", 0.2, 5.0),
        Tunable("whole_body.hold", 0.2, "share of a joint's inertia that damps it towards the planned velocity between control ticks", 0.0, 1.0),
        Tunable("whole_body.get_up", True, "who has fallen gets up again; off: stays where it lies"),
        Tunable("control.rate_hz", "60", "how often gains, gravity torque and balance are computed anew", unit="Hz", choices=("60", "120", "240", "480")),
        # physics
        Tunable("physics.step_s", 1.0 / 480.0, "physics time step; rounded to a whole number of steps in 1/60 s", 0.00001, 1.0 / 60.0, "s", log=True, restart=True),
        Tunable("physics.integrator", "discrete", "discrete, implicitfast or euler with stable PD, or explicit: the thesis's torques evaluated at the start of the step", choices=("discrete", "implicitfast", "euler", "explicit"), restart=True),
        Tunable("physics.friction", 1.0, "Coulomb friction coefficient of soles and floor, Eq. 3.6", 0.05, 2.0),
        Tunable("physics.self_collision", False, "body parts of one character collide with each other", restart=True),
        # duel
        Tunable(
            "duel.strategy",
            "virtual-actuation",
            "how the two of a duel keep their feet: whole-body takes nearly every shove, so rounds end only with the others",
            choices=("none", "ankle", "virtual-actuation", "whole-body"),
        ),
        Tunable("duel.distance_m", 0.88, "how far apart the two stand, pelvis to pelvis", 0.4, 2.0, "m", restart=True),
        Tunable("duel.opponent_vigour", 0.9, "how often the opponent attacks and how much weight it puts in, at the start of a round", 0.0, 1.0),
        Tunable("duel.round_limit_s", 60.0, "a round that lasts longer is a draw", 5.0, 300.0, "s"),
        # picture
        Tunable("picture.exposure", 1.0, "brightness of the picture", 0.25, 4.0),
        Tunable("picture.ambient_occlusion", 0.7, "darkening of corners and creases", 0.0, 1.0),
        Tunable("picture.fov_deg", 40.0, "vertical field of view of the camera", 20.0, 90.0, "deg"),
        Tunable("picture.light_azimuth_deg", 35.0, "compass direction the main light comes from", -180.0, 180.0, "deg"),
        Tunable("picture.light_height_deg", 55.0, "height of the main light above the horizon", 10.0, 85.0, "deg"),
        Tunable("picture.lamps", 1.0, "brightness of everything in the room that glows: floor lamp, window, television", 0.0, 3.0),
        Tunable("picture.saturation", 1.0, "strength of the colours; 0 is grey", 0.0, 2.0),
        Tunable("picture.vignette", 0.35, "darkening towards the corners of the picture", 0.0, 1.0),
        Tunable("picture.glow", 0.12, "light that bright things bleed over their surroundings (medium and high quality)", 0.0, 0.5),
        # layers
        Tunable("layer.target", False, "the kinematic target as a translucent ghost"),
        Tunable("layer.input", False, "the input joints as spheres with bones"),
        Tunable("layer.orientation", False, "the unprocessed orientation skeleton, thesis Fig. 4"),
        Tunable("layer.balance", False, "support polygon, COM, COS and COM target on the floor"),
        Tunable("layer.contact", False, "contact forces as arrows"),
        Tunable("layer.torque", False, "joint torque as colour on the character"),
        Tunable("layer.points", True, "what a depth camera sees, as points beside the character; only where the input has one"),
        Tunable("layer.depth_picture", True, "what a depth camera sees, as a picture in the corner; only where the input has one"),
    ]
)
# fmt: on


class Settings:
    """The current value of every tunable. `version` grows by one with each change, so readers can cache."""

    def __init__(self, values: Mapping[str, object] | None = None) -> None:
        self._values: dict[str, Value] = {name: t.default for name, t in TUNABLES.items()}
        # the same once more as they are asked for hundreds of times a second
        self._numbers = {name: float(value) for name, value in self._values.items() if not isinstance(value, str)}
        self.version = 0
        for name, value in (values or {}).items():
            self.set(name, value)

    def set(self, name: str, value: object) -> None:
        """Set one tunable by name; raises TunableError where name or value is not valid."""
        tunable = TUNABLES.get(name)
        if tunable is None:
            raise TunableError(f"there is no tunable {name!r}; valid names: {', '.join(TUNABLES)}.")
        parsed = tunable.parse(value)
        self._values[name] = parsed
        if not isinstance(parsed, str):
            self._numbers[name] = float(parsed)
        self.version += 1

    def number(self, name: str) -> float:
        """The value of a numeric tunable."""
        return self._numbers[name]

    def switch(self, name: str) -> bool:
        """The value of an on/off tunable."""
        return self._values[name] is True

    def choice(self, name: str) -> str:
        """The value of a tunable that is one of several words."""
        return str(self._values[name])

    def get(self, name: str) -> Value:
        return self._values[name]

    def as_dict(self) -> dict[str, Value]:
        """A copy of all values by name."""
        return dict(self._values)

    def reset(self, names: Iterable[str] | None = None) -> None:
        """Back to the declared default, for the given names or all."""
        for name in names or TUNABLES:
            self.set(name, TUNABLES[name].default)
