"""A Kinect that is, or will be, plugged in: depth pictures and the floor, and a stand-in until bodies are tracked."""

from collections.abc import Callable

from game.inputs.kinect_live_floor import FloorSeeker
from game.inputs.kinect_live_switching import hold_quick_switching, let_go_of_quick_switching
from game.inputs.kinect_replay import NO_BODY, floor_in_words
from game.inputs.stand_in import StandIn
from kinect.body import BodyFrame, Floor
from kinect.depth.depth_frame import DepthFrame
from kinect.depth.depth_stream import SensorDepth
from kinect.usb.sensor import KinectSensor
from kinect.usb.sensor_options import SensorState


class LiveKinect:
    """A `BodySource` that sees depth. The device is opened when it is first polled, in the sensor's own thread; no call waits for it.

    Where a plug is pulled, `interrupted` says so and the game waits; the sensor looks for the Kinect until it is back.
    """

    length_s: float | None = None

    def __init__(self, sensor: Callable[[], KinectSensor] = KinectSensor) -> None:
        self._make = sensor
        self._sensor: KinectSensor | None = None
        self._stream: SensorDepth | None = None
        self._seeker: FloorSeeker | None = None
        self._stand_in = StandIn()
        self._newest: DepthFrame | None = None
        self._closed = False

    @property
    def status(self) -> str:
        """What the Kinect sees, or what is wrong with it and how to mend that."""
        sensor = self._sensor
        if self._closed or sensor is None:
            return "The Kinect was switched off." if self._closed else "Looking for a Kinect."
        if sensor.state is not SensorState.STREAMING:
            return sensor.status
        return f"{sensor.status} {NO_BODY} {floor_in_words(self.floor)}"

    @property
    def interrupted(self) -> str:
        """Why the game had better wait: a Kinect that sent pictures sends none just now. Empty while all is well, or nothing came yet."""
        sensor = self._sensor
        if self._closed or sensor is None or self._newest is None or sensor.state is SensorState.STREAMING:
            return ""
        return sensor.status

    @property
    def floor(self) -> Floor | None:
        """The plane of the floor in the sensor frame, None while none was seen."""
        return None if self._seeker is None else self._seeker.floor

    @property
    def drawn_floor(self) -> Floor | None:
        """The floor, or a guess good enough to draw with; None before the first picture."""
        return None if self._seeker is None else self._seeker.drawn

    @property
    def floor_why(self) -> str:
        """In words: where the floor is, or what was seen in place of one."""
        return "no floor was looked for yet" if self._seeker is None else self._seeker.why

    def poll(self, until_s: float) -> list[BodyFrame]:
        """The stand-in's frames up to until_s, over the floor that was found: it stands while nobody is tracked."""
        self._pick_up()
        return [] if self._closed else self._stand_in.poll(until_s, self.floor)

    def depth(self) -> DepthFrame | None:
        """The newest depth frame, None before the first."""
        self._pick_up()
        return self._newest

    def close(self) -> None:
        """Stop the stream, end both threads. Calling it twice is harmless."""
        was_open = self._stream is not None and not self._closed
        self._closed = True
        if was_open:
            assert self._stream is not None and self._seeker is not None
            self._stream.close()
            self._seeker.close()
            let_go_of_quick_switching()

    def _pick_up(self) -> None:
        """Take what has arrived, and begin where nothing has begun yet."""
        if self._closed:
            return
        if self._stream is None:
            hold_quick_switching()
            self._sensor = self._make()
            self._stream, self._seeker = SensorDepth(self._sensor), FloorSeeker()
        assert self._seeker is not None
        arrived = self._stream.poll(0.0)
        if arrived:
            self._newest = arrived[-1]
            self._seeker.show(self._newest)
