"""A character's body: boxes, masses and joint places, read from a TOML file that a player can copy and edit."""

import tomllib
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.assets import asset
from game.characters.skeleton import PARENT, PART_COUNT, PARTS

Floats = NDArray[np.float64]

BUILT_IN = ("original", "human", "human-boxes", "low-com", "asymmetric")
_FIELDS = {"size_m": 3, "mass_kg": 1, "joint_m": 3, "centre_m": 3}
_SIDES = ("left", "right")


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
    def total_mass(self) -> float:
        return float(self.mass.sum())

    @cached_property
    def idle_com_height(self) -> float:
        """Height of the centre of mass when standing idle, metres above the sole."""
        return float(self.mass @ self.centre[:, 2]) / self.total_mass


def _where(name: str) -> Path:
    if name in BUILT_IN:
        return asset(f"characters/{name}.toml")
    path = Path(name)
    if path.suffix != ".toml" or not path.is_file():
        raise BodyPlanError(f"there is no character {name!r}; valid: {', '.join(BUILT_IN)}, or a .toml file like assets/characters/original.toml.")
    return path


def _read_parts(name: str, seen: tuple[str, ...] = ()) -> tuple[dict[str, dict[str, Any]], str]:
    """The file's parts laid over those of the file it is based on; limbs spread to left and right."""
    path = _where(name)
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BodyPlanError(f"{path} is no valid TOML: {error}.") from error
    parts: dict[str, dict[str, Any]] = {}
    base = document.get("based_on")
    if base is not None:
        if base in seen or not isinstance(base, str):
            raise BodyPlanError(f"{path}: based_on = {base!r} must name another character ({', '.join(BUILT_IN)} or a file) and not itself.")
        parts, _ = _read_parts(base, (*seen, name))
    table = document.get("part", {})
    if not isinstance(table, dict):
        raise BodyPlanError(f"{path}: part must be a table of parts such as [part.pelvis].")
    for key, fields in table.items():
        targets = [key] if key in PARTS else [f"{key}_{side}" for side in _SIDES if f"{key}_{side}" in PARTS]
        if not targets or not isinstance(fields, dict):
            raise BodyPlanError(f"{path}: there is no part {key!r}; valid: {', '.join(PARTS)}, or a limb without its side.")
        for field, value in fields.items():
            row = _checked(path, key, field, value)
            for target in targets:
                mirrored = row.copy()
                if field in ("joint_m", "centre_m") and key != target and target.endswith("right"):
                    mirrored[1] = -mirrored[1]
                parts.setdefault(target, {})[field] = mirrored
    return parts, str(document.get("about", path.stem))


def _checked(path: Path, part: str, field: str, value: object) -> Floats:
    width = _FIELDS.get(field)
    if width is None:
        raise BodyPlanError(f"{path}: part.{part} has no field {field!r}; valid: {', '.join(_FIELDS)}.")
    try:
        row = np.atleast_1d(np.asarray(value, dtype=np.float64))
    except (TypeError, ValueError):
        row = np.empty(0)
    if row.shape != (width,) or not np.all(np.isfinite(row)):
        raise BodyPlanError(f"{path}: part.{part}.{field} must be {width} finite number(s), not {value!r}.")
    if field in ("size_m", "mass_kg") and np.any(row <= 0.0):
        raise BodyPlanError(f"{path}: part.{part}.{field} must be positive, not {value!r}.")
    return row


def load_body_plan(name: str) -> BodyPlan:
    """The built-in character `name`, or one from a .toml file; raises BodyPlanError."""
    parts, about = _read_parts(name)
    for part in PARTS:
        for field in _FIELDS:
            if field not in parts.get(part, {}):
                raise BodyPlanError(f"{_where(name)}: part.{part}.{field} is missing; give it or start from based_on = \"original\".")

    def column(field: str) -> Floats:
        return np.array([parts[part][field] for part in PARTS])

    plan = BodyPlan(Path(name).stem, about, column("size_m"), column("mass_kg")[:, 0], column("joint_m"), column("centre_m"))
    lowest = (plan.centre[:, 2] - 0.5 * plan.size[:, 2]).min()
    if abs(lowest) > 0.005:
        raise BodyPlanError(f"{_where(name)}: the lowest box must stand on the floor (z = 0), not at z = {lowest:.3f} m.")
    assert len(plan.mass) == PART_COUNT
    return plan
