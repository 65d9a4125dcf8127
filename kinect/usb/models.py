"""Which USB product ids make a Kinect, and what each model can do."""

from enum import Enum
from typing import Final

MICROSOFT: Final = 0x045E

CAMERA_XBOX: Final = 0x02AE
CAMERA_WINDOWS: Final = 0x02BF
MOTOR: Final = 0x02B0
HUB: Final = 0x02C2
CAMERAS: Final = (CAMERA_XBOX, CAMERA_WINDOWS)
AUDIO: Final = (0x02AD, 0x02BB, 0x02BE, 0x02C3)
RULE_PRODUCTS: Final = (CAMERA_XBOX, CAMERA_WINDOWS, MOTOR, *AUDIO)
"""All that the udev rule must open to a player."""

KINECT_V2: Final = (0x02C4, 0x02D8, 0x02D9)
AZURE: Final = (0x097A, 0x097B, 0x097C, 0x097D, 0x097E)

BCD_1414: Final = 0x010B
"""The release number that only the camera of model 1414 carries."""


class Model(Enum):
    """The three Kinects of the first generation."""

    XBOX_1414 = "Kinect for Xbox 360, model 1414"
    XBOX_1473 = "Kinect for Xbox 360, model 1473"
    WINDOWS_1517 = "Kinect for Windows v1"

    @property
    def has_motor_device(self) -> bool:
        """Whether tilt, LED and accelerometer answer on a device of their own, without firmware."""
        return self is Model.XBOX_1414

    @property
    def limits(self) -> str:
        """What this model cannot do here, in plain words; empty where nothing is missing."""
        if self.has_motor_device:
            return ""
        return (
            f"The {self.value} gives depth like any other, but its motor and its sense of level sit behind firmware that only "
            "Microsoft may hand out: tilt it by hand, and let the floor be found from the picture."
        )


def model_of(product: int, release: int) -> Model | None:
    """The model of a camera with this product id and release number (bcdDevice); None where it is no Kinect v1 camera."""
    if product == CAMERA_WINDOWS:
        return Model.WINDOWS_1517
    if product == CAMERA_XBOX:
        return Model.XBOX_1414 if release == BCD_1414 else Model.XBOX_1473
    return None
