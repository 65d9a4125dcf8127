"""Play Topple: in a window, headless into files, or without any picture."""

import argparse
import sys
from pathlib import Path

from game.commands import DONE, BadInput
from game.commands.casting import Casting
from game.commands.output_file import check_output_file, write_report
from game.commands.set_option import apply_assignments
from game.presets import PRESETS, apply_preset
from game.scenes.fighter import NoBodyError
from game.tunables import TUNABLES, Settings, TunableError
from game.undrawn import run_undrawn
from game.warm_up import tell_of_compiling

USUAL_SIZE = "1280x720"
UNASKED_SIZE = "960x540"
"""Of a film that is drawn because there is no display: nobody chose to wait for it."""
UNASKED_SECONDS = 20.0
"""How long the performer is drawn where nobody asked for anything and no screen is there; it outlasts the motion by a few seconds."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--scene", choices=("mirror", "duel"), help="default: duel, or mirror where --input is a recording or a performer")
    add("--input", default="auto", metavar="SPEC", help="clip:PATH, performer:NAME, puppet, script, kinect, kinect-replay:PATH or auto")
    add("--character", default="original", metavar="NAME", help="original, human, human-boxes, low-com, asymmetric or a .toml file")
    add("--preset", choices=tuple(PRESETS), help="values for the whole method; default: default")
    add("--set", action="append", default=[], metavar="NAME=VALUE", dest="sets", help="set one tunable; may be given again")
    add("--balance", metavar="NAME", help="how characters keep their feet: sets balance.strategy and duel.strategy")
    add("--ik", metavar="NAME", help="short for --set ik.method=NAME")
    add("--headless", action="store_true", help="draw off-screen")
    add("--seconds", type=float, metavar="S", help="stop after so much simulated time")
    add("--size", metavar="WxH", help="of the picture (default 1280x720; without a display and --headless 960x540)")
    add("--quality", choices=("low", "medium", "high"), help="of the picture (default high, low where the processor has to draw)")
    add("--no-draw", action="store_true", help="simulate only; needs no graphics")
    add("--seed", type=int, default=0, help="of everything random (default 0)")
    add("--report", type=Path, metavar="FILE.json", help="write what was measured")
    add("--picture", type=Path, metavar="FILE.png", help="write the last frame")
    add("--video", type=Path, metavar="FILE.mp4", help="write a film")
    add("--list-tunables", action="store_true", help="print every tunable and stop")


def run(arguments: argparse.Namespace) -> int:
    if arguments.list_tunables:
        print(tunable_list())
        return DONE
    settings = settings_from(arguments)
    if arguments.seconds is not None and not 0.0 < arguments.seconds <= 86400.0:
        raise BadInput(f"--seconds must lie between 0 and 86400, not {arguments.seconds:g}.")
    check_outputs(arguments)
    headless = not arguments.no_draw and (arguments.headless or not has_display())
    announce = headless and not arguments.headless
    usual_size = UNASKED_SIZE if announce else USUAL_SIZE
    size = parse_size(usual_size if arguments.size is None else arguments.size)
    if announce and arguments.input == "auto":
        arguments.input = "performer:boxing"
        arguments.seconds = arguments.seconds or UNASKED_SECONDS
    tell_of_compiling()
    casting = Casting(arguments.input, arguments.character, settings, arguments.seed)
    scene = casting.scene(arguments.scene or casting.default_scene())
    try:
        if arguments.no_draw:
            outcome = run_undrawn(scene, arguments.seconds)
        else:
            from game.commands.picture import draw

            scene, outcome = draw(scene, casting, settings, arguments, size, headless=headless, announce=announce)
    except NoBodyError as fault:
        raise BadInput(str(fault)) from fault
    report = {**scene.report(), **outcome}
    ms, drawing = report["ms_per_frame"], outcome.get("stage_ms", {})
    assert isinstance(ms, dict) and isinstance(drawing, dict)
    ms["draw"] = drawing.get("draw", 0.0)
    if arguments.report is not None:
        write_report(arguments.report, report)
    if arguments.no_draw or headless:
        print(summary(report))
    return DONE


def check_outputs(arguments: argparse.Namespace) -> None:
    """Raises BadInput where the seed is not valid, or a file asked for cannot be written or will not come to be."""
    if arguments.seed < 0:
        raise BadInput(f"--seed must be a whole number from 0, not {arguments.seed}.")
    if arguments.no_draw and (arguments.picture or arguments.video):
        raise BadInput("--no-draw makes no picture; leave it out, or leave out --picture and --video.")
    for option, path, suffixes in (
        ("--report", arguments.report, ()),
        ("--picture", arguments.picture, (".png",)),
        ("--video", arguments.video, (".mp4",)),
    ):
        if path is not None:
            check_output_file(option, path, suffixes)


def settings_from(arguments: argparse.Namespace) -> Settings:
    """Defaults (in a window: the saved settings), then the preset, then --set, --ik and --balance; raises BadInput."""
    settings = Settings()
    try:
        if not arguments.no_draw and not arguments.headless and has_display():
            from game import settings_file

            for problem in settings_file.load(settings):
                print(f"topple: {problem}", file=sys.stderr)
        if arguments.preset:
            apply_preset(settings, arguments.preset)
        apply_assignments(settings, arguments.sets)
        if arguments.balance:
            settings.set("balance.strategy", arguments.balance)
            settings.set("duel.strategy", arguments.balance)
        if arguments.ik:
            settings.set("ik.method", arguments.ik)
    except TunableError as fault:
        raise BadInput(str(fault)) from fault
    return settings


def parse_size(text: str) -> tuple[int, int]:
    """(width, height) pixels of "1280x720"; raises BadInput."""
    width, _, height = text.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal() and 64 <= int(width) <= 7680 and 64 <= int(height) <= 4320):
        raise BadInput(f"--size {text!r} must be WIDTHxHEIGHT in pixels from 64x64 to 7680x4320, such as 1280x720.")
    return int(width), int(height)


def has_display() -> bool:
    """Whether a window can be expected to open: always on Windows and macOS, by DISPLAY or WAYLAND_DISPLAY elsewhere."""
    import os

    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def tunable_list() -> str:
    """A line per tunable: name, default, range or choices, unit, meaning."""
    lines = []
    for t in TUNABLES.values():
        valid = "|".join(t.choices) if t.choices else "on|off" if isinstance(t.default, bool) else f"{t.low:g}..{t.high:g}"
        lines.append(f"{t.name} = {t.default!s:<10} [{valid}{' ' + t.unit if t.unit else ''}]  {t.meaning}")
    return "\n".join(lines)


def summary(report: dict[str, object]) -> str:
    """One line for a person."""
    if report["scene"] == "duel":
        return f"topple: duel, {report['score']}, {report['simulated_s']:.1f} s at {report['real_time_factor']:.1f} x real time."
    fell = report["fell_at_s"]
    how = "upright to the end" if fell is None else f"fell after {fell:.1f} s"
    return f"topple: {report['input']}, {how}, {report['simulated_s']:.1f} s at {report['real_time_factor']:.1f} x real time."
