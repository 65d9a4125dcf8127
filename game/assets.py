"""Where the files that are not code lie: characters, fonts, sounds."""

from pathlib import Path

_GAME = Path(__file__).resolve().parent


def assets_folder() -> Path:
    """The folder of all assets: inside the package where the game is installed, else at the top of the checkout."""
    installed = _GAME / "assets"
    return installed if installed.is_dir() else _GAME.parent / "assets"


def asset(path: str) -> Path:
    """The file or folder `path` below the assets, e.g. "characters/original.toml".

    Raises FileNotFoundError that names the missing asset and what lies beside it.
    """
    found = assets_folder() / path
    if not found.exists():
        beside = sorted(p.name for p in found.parent.iterdir()) if found.parent.is_dir() else []
        raise FileNotFoundError(f"there is no asset {path!r} in {assets_folder()}; beside it lie: {', '.join(beside) or 'no files'}.")
    return found
