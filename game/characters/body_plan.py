"""A character's body: boxes, masses and joint places, read from a TOML file that a player can copy and edit."""

import tomllib
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.assets import asset
from game.characters.skeleton import PARENT, PARTS

Floats = NDArray[np.float64]

BUILT_IN = ("original", "human", "human-boxes", "low-com", "asymmetric")
_KEYS = ("about", "based_on", "part")
_FIELDS = {"size_m": (3, 0.005, 5.0), "mass_kg": (1, 0.01, 1000.0), "joint_m": (3, -10.0, 10.0), "centre_m": (3, -10.0, 10.0)}
"""Each field of a part: how many numbers, the smallest and the largest."""

_SIDES = ("left", "right")
_LIMBS = (("upper_leg", "lower_leg"), ("lower_leg", "foot"), ("upper_arm", "lower_arm"), ("lower_arm", "hand"))
_ABOVE = (("head", "trunk"), *((f"{upper}_{side}", f"{lower}_{side}") for upper, lower in _LIMBS for side in _SIDES))
SHORTEST_BONE_M = 0.02
"""Joints that follow each other along a limb or the trunk lie at least this far apart in height when standing idle."""


class BodyPlanError(ValueError):
    """A character file that cannot be used; the message names the file, the field and what would be valid."""


@dataclass(frozen=True)
class BodyPlan:
    """Fifteen boxes standing idle (feet side by side, arms down), world frame, metres and kilograms.

    size (15, 3) full edge lengths; mass (15,); joint (15, 3) idle joint centres, row 0 the root point (the Kinect's
    hip centre); centre (15, 3) idle box centres. Rows in the order of `PARTS`.
    """

    name: str
    about: str
    size: Floats
    mass: Floats
    joint: Floats
    centre: Floats

    @cached_property
    def joint_offset(self) -> Floats:
        """(15, 3) joint centre from the parent's joint centre, in the parent's frame; row 0 is zero."""
        parent = np.maximum(np.array(PARENT), 0)
        return self.joint - self.joint[parent]

    @cached_property
    def centre_offset(self) -> Floats:
        """(15, 3) box centre from the part's own joint centre, in the part's frame."""
        return self.centre - self.joint

    @cached_property
    def foot_half(self) -> tuple[float, float, float]:
        """m, half length, width and height of a foot box."""
        length, width, height = (self.size[PARTS.index("foot_left")] / 2.0).tolist()
        return length, width, height

    @cached_property
    def total_mass(self) -> float:
        return float(self.mass.sum())

    @cached_property
    def idle_com_height(self) -> float:
        """Height of the centre of mass when standing idle, metres above the sole."""
        return float(self.mass @ self.centre[:, 2]) / self.total_mass


def _is_toml(path: Path) -> bool:
    try:
        return path.suffix == ".toml" and path.is_file()
    except OSError:  # e.g. a name longer than the file system allows
        return False


def _where(name: str) -> Path:
    path = asset(f"characters/{name}.toml") if name in BUILT_IN else Path(name)
    if not _is_toml(path):
        known = f"{', '.join(BUILT_IN)}, or a .toml file like assets/characters/original.toml"
        raise BodyPlanError(f"there is no character {_shown(name)}; valid: {known}.")
    return path


def _where_base(path: Path, base: object, seen: tuple[Path, ...]) -> Path:
    """The file that `path` is based on: a built-in character, or a file named from where `path` lies."""
    found = asset(f"characters/{base}.toml") if base in BUILT_IN else path.parent / base if isinstance(base, str) else path.parent
    known = f"{', '.join(BUILT_IN)}, or another .toml file beside it"
    if not _is_toml(found):
        raise BodyPlanError(f"{path}: based_on = {_shown(base)} names no character; valid: {known}.")
    if found.resolve() in seen:
        raise BodyPlanError(f"{path}: based_on = {_shown(base)} leads back to the same file; valid: {known}.")
    return found


def _shown(value: object) -> str:
    """A value as an error message quotes it: one line, not endless."""
    try:
        text = repr(value)
    except ValueError:  # Python refuses to write out whole numbers of thousands of digits
        text = "a number of thousands of digits"
    return text if len(text) <= 80 else f"{text[:77]}..."


def _read_document(path: Path) -> dict[str, Any]:
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as fault:
        raise BodyPlanError(f"{path} cannot be read: {fault.strerror or fault}.") from fault
    except RecursionError as fault:
        raise BodyPlanError(f"{path} is no valid TOML for a character: its values are nested too deeply.") from fault
    except ValueError as fault:  # TOML, UTF-8, and numbers too long for Python
        raise BodyPlanError(f"{path} is no valid TOML: {fault}.") from fault
    for key in document:
        if key not in _KEYS:
            raise BodyPlanError(f"{path}: there is no entry {_shown(key)}; valid: {', '.join(_KEYS)}.")
    return document


def _read_parts(path: Path, seen: tuple[Path, ...] = ()) -> tuple[dict[str, dict[str, Floats]], str]:
    """The file's parts laid over those of the file it is based on; limbs spread to left and right."""
    document = _read_document(path)
    parts: dict[str, dict[str, Floats]] = {}
    if "based_on" in document:
        seen = (*seen, path.resolve())
        parts, _ = _read_parts(_where_base(path, document["based_on"], seen), seen)
    table = document.get("part", {})
    if not isinstance(table, dict):
        raise BodyPlanError(f"{path}: part must be a table of parts such as [part.pelvis], not {_shown(table)}.")
    for key, fields in table.items():
        targets = [key] if key in PARTS else [f"{key}_{side}" for side in _SIDES if f"{key}_{side}" in PARTS]
        if not targets:
            raise BodyPlanError(f"{path}: there is no part {_shown(key)}; valid: {', '.join(PARTS)}, or a limb without its side.")
        if not isinstance(fields, dict):
            raise BodyPlanError(f"{path}: part.{key} must be a table [part.{key}] of {', '.join(_FIELDS)}, not {_shown(fields)}.")
        for field, value in fields.items():
            row = _checked(path, key, field, value)
            for target in targets:
                mirrored = row.copy()
                if field in ("joint_m", "centre_m") and key != target and target.endswith("right"):
                    mirrored[1] = -mirrored[1]
                parts.setdefault(target, {})[field] = mirrored
    return parts, str(document.get("about", path.stem))


def _checked(path: Path, part: str, field: str, value: object) -> Floats:
    if field not in _FIELDS:
        raise BodyPlanError(f"{path}: part.{part} has no field {_shown(field)}; valid: {', '.join(_FIELDS)}.")
    count, low, high = _FIELDS[field]
    numbers = value if isinstance(value, list) else [value]
    sound = [x for x in numbers if isinstance(x, (int, float)) and not isinstance(x, bool) and low <= x <= high]
    if len(numbers) != count or len(sound) != count:
        wanted = "a number" if count == 1 else f"{count} numbers"
        raise BodyPlanError(f"{path}: part.{part}.{field} must be {wanted} from {low:g} to {high:g}, not {_shown(value)}.")
    return np.array(sound, dtype=np.float64)


def _check_stance(path: Path, plan: BodyPlan) -> None:
    """Standing idle: limbs and spine straight enough that their joints follow each other downwards, the sole on the floor."""
    for upper, lower in _ABOVE:
        if plan.joint[PARTS.index(upper), 2] - plan.joint[PARTS.index(lower), 2] < SHORTEST_BONE_M:
            wanted = f"lie at least {SHORTEST_BONE_M:g} m lower than that of {upper}"
            raise BodyPlanError(f"{path}: part.{lower}.joint_m must {wanted}: a character is described standing with its arms down.")
    lowest = float((plan.centre[:, 2] - 0.5 * plan.size[:, 2]).min())
    if abs(lowest) > 0.005:
        wanted = f"put the lowest box on the floor (z = 0), not at z = {lowest:.3f} m"
        raise BodyPlanError(f"{path}: size_m and centre_m must {wanted}.")


def load_body_plan(name: str) -> BodyPlan:
    """The built-in character `name`, or one from a .toml file; raises BodyPlanError."""
    path = _where(name)
    parts, about = _read_parts(path)
    for part in PARTS:
        for field in _FIELDS:
            if field not in parts.get(part, {}):
                raise BodyPlanError(f'{path}: part.{part}.{field} is missing; give it or start from based_on = "original".')

    def column(field: str) -> Floats:
        return np.array([parts[part][field] for part in PARTS])

    plan = BodyPlan(path.stem, about, column("size_m"), column("mass_kg")[:, 0], column("joint_m"), column("centre_m"))
    _check_stance(path, plan)
    return plan
