"""Settings on disk: one TOML table per group in the platform's configuration folder."""

import os
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import platformdirs
import tomli_w

from game.tunables import TUNABLES, Settings, TunableError, Value


def default_path() -> Path:
    """Where the settings live on this platform."""
    return Path(platformdirs.user_config_dir("topple", appauthor=False)) / "settings.toml"


def load(settings: Settings, path: Path | None = None) -> tuple[str, ...]:
    """Set everything valid that the file (None: the platform's own) holds; a sentence for each thing it could not use. No file: none."""
    path = path or default_path()
    tables, complaint = _read(path)
    if complaint:
        return (complaint,)
    complaints: list[str] = []
    for name, value in _flat(tables).items():
        try:
            settings.set(name, value)
        except TunableError as error:
            complaints.append(f"{path}: {_sentence(name, error)} The rest was loaded.")
    return tuple(complaints)


def save(settings: Settings, path: Path | None = None) -> str:
    """Write what differs from the declared defaults; returns a sentence for the player. OSError where the folder cannot be written.

    A file that holds anything this version cannot use is first copied to `NAME.bak` (`.bak2`, ... where one exists already).
    """
    path = path or default_path()
    kept = ""
    if path.exists() and load(Settings(), path):
        spare = _free_name(path)
        spare.write_bytes(path.read_bytes())
        kept = f" The file there could not be used whole and is kept as {spare.name}."
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(path.name + ".new")
    with new.open("wb") as file:
        tomli_w.dump(_tables(settings), file)
    os.replace(new, path)
    return f"Saved to {path}.{kept}"


def _read(path: Path) -> tuple[Mapping[str, Any], str]:
    try:
        return tomllib.loads(path.read_bytes().decode("utf-8")), ""
    except FileNotFoundError:
        return {}, ""
    except OSError as error:
        return {}, f"{path} cannot be read ({error.strerror}); the settings stay as they are."
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        return {}, f"{path} is not a TOML file ({error}); the settings stay as they are."


def _flat(tables: Mapping[str, Any]) -> dict[str, Any]:
    """group.name -> value, for tables one level deep; anything else keeps its own name and is refused by Settings."""
    flat: dict[str, Any] = {}
    for group, entry in tables.items():
        if isinstance(entry, dict):
            flat.update({f"{group}.{key}": value for key, value in entry.items()})
        else:
            flat[group] = entry
    return flat


def _tables(settings: Settings) -> dict[str, dict[str, Value]]:
    tables: dict[str, dict[str, Value]] = {}
    for name, tunable in TUNABLES.items():
        value = settings.get(name)
        if value != tunable.default:
            tables.setdefault(tunable.group, {})[name.split(".", 1)[1]] = value
    return tables


def _sentence(name: str, error: TunableError) -> str:
    return str(error) if name in TUNABLES else f"there is no tunable {name!r} in this version."


def _free_name(path: Path) -> Path:
    number = 1
    while (spare := path.with_name(f"{path.name}.bak{number if number > 1 else ''}")).exists():
        number += 1
    return spare
