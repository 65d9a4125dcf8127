"""Playing with a picture: the loop's options, what the menu may ask for, and the files a run without a display leaves."""

import argparse
from pathlib import Path

from game.app import Options, play
from game.commands import BadInput
from game.commands.casting import Casting
from game.commands.output_file import check_output_file
from game.render.capture import VideoError
from game.render.gl_window import NoPicture
from game.scenes.registry import SCENES, PlayableScene
from game.tunables import Settings

OUTPUT = Path("topple-output")
MENU_MOTIONS = ("waving", "leaning", "bowing", "reaching", "boxing", "stepping", "balancing", "jump")
MENU_INPUTS = ("auto", "kinect", "script", *(f"performer:{motion}" for motion in MENU_MOTIONS))


class Stage:
    """The scene on stage and what steers it; answers the menu's requests for another scene or input."""

    def __init__(self, casting: Casting, scene: PlayableScene) -> None:
        self.casting, self.scene = casting, scene

    def request(self, kind: str, value: str):
        """A new Staged for "scene" or "input"; ValueError with a sentence where that is not valid."""
        from game.actions import Staged

        casting, name = self.casting, self.scene.name
        if kind == "input":
            casting = Casting(value, casting.character, casting.settings, casting.seed)
            name = casting.default_scene() if casting.default_scene() == "mirror" else name
        else:
            name = value
        scene = casting.scene(name)
        # a scene that cannot begin must not replace one that plays
        scene.enter()
        self.casting, self.scene = casting, scene
        return Staged(scene, casting, casting.spec)


def draw(
    scene: PlayableScene,
    casting: Casting,
    settings: Settings,
    arguments: argparse.Namespace,
    size: tuple[int, int],
    *,
    headless: bool,
    announce: bool,
) -> tuple[PlayableScene, dict[str, object]]:
    """Play until the end; returns the scene last on stage and what the loop adds to the report.

    Raises BadInput where nothing can be drawn.
    """
    picture, video = arguments.picture, arguments.video
    if announce:
        video = video or OUTPUT / "topple.mp4"
        picture = picture or OUTPUT / "topple.png"
        for option, path in (("--video", video), ("--picture", picture)):
            check_output_file(option, path)
        print(f"topple: no display here, so {casting.spec} is drawn off-screen into {video} and {picture}.")
    stage = Stage(casting, scene)
    options = Options(
        headless=headless,
        size=size,
        quality=arguments.quality,
        seconds=arguments.seconds,
        picture=picture,
        video=video,
        fps=30 if announce else 60,
        scenes=tuple(SCENES),
        inputs=MENU_INPUTS,
        input_spec=casting.spec,
        output_dir=OUTPUT,
    )
    try:
        report = play(scene, settings, options, controls=casting, on_request=stage.request)
    except (NoPicture, VideoError) as fault:
        raise BadInput(str(fault)) from fault
    for path in report.files:
        print(f"topple: wrote {path}")
    drawn = {
        "drawn": True,
        "gl": report.gl,
        "frames": report.frames,
        "stage_ms": dict(report.stage_ms),
        "files": [str(path) for path in report.files],
    }
    return stage.scene, drawn
