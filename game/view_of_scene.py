"""One picture frame as the overlay shows it, gathered from the loop and its scene."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from game.overlay.view import PlacedLabel, View

if TYPE_CHECKING:
    from game.app import App

SHOWN_STAGES = ("update", "draw", "overlay")


def view_of_scene(app: App) -> View:
    """Plots and stages are only gathered for a frame that is to show them anew, since a scene may take its time to lay them out."""
    overlay, actions, scene = app.picture.overlay, app.actions, app.scene
    now_s = app.now_s
    plots_due = overlay is not None and overlay.plots_due(now_s)
    readouts = scene.readouts()
    messages = scene.messages()
    return View(
        scene=scene.name,
        settings=app.settings,
        now_s=now_s,
        time_s=scene.time_s,
        score=scene.score(),
        status=_status(readouts, messages),
        messages=messages,
        help_keys=scene.help_keys(),
        labels=tuple(PlacedLabel(x, y, label.text, label.colour) for x, y, label in app.picture.labels()),
        plots=scene.plots() if plots_due else (),
        stage_ms=_stages(app, readouts) if plots_due else {},
        upright_s=_number(readouts, "upright_s"),
        fell=_fell(readouts),
        speed=app.pace.speed,
        paused=actions.paused,
        interrupted=actions.interrupted,
        finished=scene.finished,
        restart_pending=actions.restart_pending,
        first_input_s=actions.first_input_s,
        cameras=tuple(scene.cameras()),
        scenes=app.options.scenes,
        inputs=app.options.inputs,
        input_spec=actions.input_spec,
        depth_picture=getattr(scene, "depth_picture", None),
    )


def _status(readouts: Mapping[str, float | str], messages: tuple[str, ...]) -> str:
    """Which input is live, in words: the readout `input`, or the first thing the scene said."""
    said = readouts.get("input")
    return said if isinstance(said, str) else messages[0] if messages else ""


def _number(readouts: Mapping[str, float | str], name: str) -> float | None:
    value = readouts.get(name)
    return float(value) if isinstance(value, (int, float)) else None


def _fell(readouts: Mapping[str, float | str]) -> bool:
    fell = _number(readouts, "fell_at_s")
    return fell is not None and fell >= 0.0


def _stages(app: App, readouts: Mapping[str, float | str]) -> Mapping[str, float]:
    """Medians of the last second. A scene's own readouts `NAME_ms` split the update; the rest of it stays `update`."""
    medians = app.times.medians(60)
    own = {name[:-3]: float(value) for name, value in readouts.items() if name.endswith("_ms") and isinstance(value, (int, float))}
    rest = max(0.0, medians.get("update", 0.0) - sum(own.values()))
    update = {"update": rest} if not own else {"rest of update": rest} if rest > 0.01 else {}
    return {**own, **update, **{s: medians[s] for s in SHOWN_STAGES[1:] if s in medians}}
