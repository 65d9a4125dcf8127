"""A whole simulated Kinect: the devices of one model behind one hub."""

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.models import Model
from kinect.usb.simulated_camera import SimulatedCamera
from kinect.usb.simulated_devices import CAMERA_ENDPOINTS, SimulatedAudio, SimulatedDevice, SimulatedMotor, camera_release, hub_of
from kinect.usb.simulated_stream import FrameSource, replayed


class SimulatedKinect:
    """powered: whether the 12 V supply is in; without it camera and audio stay off the bus."""

    def __init__(
        self,
        source: FrameSource | None = None,
        model: Model = Model.XBOX_1414,
        ports: tuple[int, ...] = (2,),
        calibration: DeviceCalibration = TYPICAL,
        powered: bool = True,
    ) -> None:
        product, release = camera_release(model)
        settings = ((), CAMERA_ENDPOINTS) if model is Model.WINDOWS_1517 else (CAMERA_ENDPOINTS,)
        self.model = model
        self.camera = SimulatedCamera(
            product,
            release,
            (*ports, 1),
            settings=settings,
            source=source or replayed(()),
            calibration=calibration,
            fixed_bytes=322 if model is Model.XBOX_1414 else 334,
        )
        self.motor = SimulatedMotor(ports=(*ports, 2))
        self.audio = SimulatedAudio(product=0x02BE if model is Model.WINDOWS_1517 else 0x02AD, ports=(*ports, 3))
        self.hub = hub_of(model, ports)
        self.powered = powered

    @property
    def devices(self) -> list[SimulatedDevice]:
        """What shows on the bus."""
        motor: list[SimulatedDevice] = [self.motor] if self.model.has_motor_device else []
        return [self.hub, *motor, *([self.camera, self.audio] if self.powered else [])]


class OtherDevice(SimulatedKinect):
    """Any other device by its product id, such as a newer Kinect."""

    def __init__(self, product: int, ports: tuple[int, ...] = (4,)) -> None:
        super().__init__()
        self._device = SimulatedDevice(product, ports=ports)

    @property
    def devices(self) -> list[SimulatedDevice]:
        """Just the one."""
        return [self._device]
