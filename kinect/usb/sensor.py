"""A Kinect v1 as a live source of raw depth frames that looks for itself, wakes itself up, and survives being unplugged."""

import atexit
import contextlib
import logging
import queue
import threading
from collections import deque
from collections.abc import Callable
from typing import Any

from kinect.device_calibration import TYPICAL, DeviceCalibration
from kinect.usb.capture_time import CaptureTime
from kinect.usb.clock import Clock, WallClock
from kinect.usb.counters import Counters, new_tally, snapshot
from kinect.usb.discovery import find_kinects
from kinect.usb.errors import Fault, KinectError, explained
from kinect.usb.libusb import load_backend
from kinect.usb.loss_watch import LossWatch
from kinect.usb.models import Model
from kinect.usb.motor import Led, Motor, MotorState, no_motor, tilt_word
from kinect.usb.opened_kinect import TROUBLE, Arrival, OpenedKinect
from kinect.usb.packing import unpack11
from kinect.usb.raw_depth_frame import RawDepthFrame, RawVideoFrame
from kinect.usb.sensor_options import SensorOptions, SensorState


class KinectSensor:
    """Frames, status, counters. `start` runs it in a thread of its own; `step` does one round, for a simulated clock.

    Nothing here raises for what the device does: it says so in `status` and tries again.
    """

    def __init__(self, load: Callable[[], Any] = load_backend, clock: Clock | None = None, options: SensorOptions | None = None) -> None:
        self.options = options or SensorOptions()
        self.state = SensorState.SEARCHING
        self.fault: Fault | None = None
        self.model: Model | None = None
        self.calibration: DeviceCalibration = TYPICAL
        self.level: MotorState | None = None
        self._sentence = "Looking for a Kinect."
        self._load, self._clock = load, clock or WallClock()
        self._tally = new_tally()
        self._opened: OpenedKinect | None = None
        self._frames: deque[RawDepthFrame] = deque()
        self._video: deque[RawVideoFrame] = deque(maxlen=2)
        self._requests: queue.SimpleQueue[Callable[[Motor], None]] = queue.SimpleQueue()
        self._capture = CaptureTime()
        self._last_frame_s = self._last_presence_s = self._last_level_s = 0.0
        self._next_look_s = self._clock.now()
        self._losses = LossWatch(self.options.loss_every_s, self.options.loss_to_tell)
        self._restarts = 0
        self._seen_before = False
        self._thread: threading.Thread | None = None
        self._closing = threading.Event()

    @property
    def status(self) -> str:
        """What the sensor sees, in plain words, with the remedy where something is wrong."""
        return self._sentence

    def counters(self) -> Counters:
        """Everything counted so far."""
        return snapshot(self._tally)

    def poll(self) -> list[RawDepthFrame]:
        """Every depth frame that arrived since the last call, oldest first, at most the last `kept_frames`."""
        frames = []
        with contextlib.suppress(IndexError):  # the other thread may drop an old frame between any two lines
            while True:
                frames.append(self._frames.popleft())
        return frames

    def latest_video(self) -> RawVideoFrame | None:
        """The newest colour or infrared frame, None without that stream."""
        return self._video[-1] if self._video else None

    def set_led(self, led: Led) -> None:
        """Ask for a colour. Raises KinectError where this Kinect's LED is out of reach."""
        self._request(lambda motor: motor.set_led(led))

    def set_tilt(self, degrees: float) -> None:
        """Ask for a tilt, degrees above the horizon. Raises KinectError where this Kinect has no motor for us, ValueError beyond +-27."""
        tilt_word(degrees)
        self._request(lambda motor: motor.set_tilt(degrees))

    def start(self) -> "KinectSensor":
        """Run in a thread until `close`."""
        if self._thread is None:
            self._closing.clear()
            self._thread = threading.Thread(target=self._run, name="kinect", daemon=True)
            self._thread.start()
            atexit.register(self.close)
        return self

    def close(self) -> None:
        """Stop the stream, let go of the device, end the thread. Calling it twice is harmless."""
        self._closing.set()
        if self._thread is not None:
            self._thread.join(10.0)
            stuck, self._thread = self._thread.is_alive(), None
            atexit.unregister(self.close)
            if stuck:  # in libusb: what it holds is not ours to free
                return
        self._let_go()
        self.state, self.fault, self._sentence = SensorState.CLOSED, None, "The Kinect was switched off."

    def step(self, wait_s: float = 0.05) -> None:
        """One round: look for a device, or wait at most `wait_s` for its transfers and see to the watchdog. Never raises."""
        try:
            if self._opened is None:
                self._search(wait_s)
            else:
                self._listen(self._opened, wait_s)
        except TROUBLE as error:
            self._fail(explained(error, "the Kinect"))
        except Exception as error:  # a mistake of ours must not end the thread, but must be found
            logging.getLogger(__name__).exception("The Kinect's driver made a mistake and starts anew")
            self._fail(explained(error, "the Kinect"))

    def _run(self) -> None:
        while not self._closing.is_set():
            self.step()

    def _search(self, wait_s: float) -> None:
        wait = self._next_look_s - self._clock.now()
        if wait > 0:
            self._clock.sleep(min(wait, wait_s))
            return
        self._next_look_s = self._clock.now() + self.options.look_every_s
        found = find_kinects(self._load()).first()
        self.state = SensorState.STARTING
        self._opened = opened = OpenedKinect(found, self._clock, self._tally, self.options.ring, self.options.video)
        opened.start_streams()
        self.model, self.calibration = found.model, opened.calibration
        self._restarts = 0
        self._last_frame_s = self._last_presence_s = self._clock.now()
        self._last_level_s = -1e9
        self._losses.begin(self.counters(), self._clock.now())
        if self.fault is not Fault.SILENT:  # which stays true until a picture comes
            self._say(None, f"{found.model.value} found on {found.place}: waiting for its first picture.")

    def _listen(self, opened: OpenedKinect, wait_s: float) -> None:
        opened.pump(wait_s)
        self._publish(opened)
        now = self._clock.now()
        silent_s = now - self._last_frame_s
        if opened.unplugged or (silent_s > self.options.presence_after_s and not self._still_there(opened, now)):
            raise KinectError(Fault.UNPLUGGED, "")
        if opened.motor is not None:
            self._attend_to_motor(opened, opened.motor, now)
        self._judge_losses(opened, now)
        if silent_s > self.options.silence_s or not opened.listening:
            self._wake(opened)

    def _publish(self, opened: OpenedKinect) -> None:
        arrivals, opened.depth[:] = opened.depth[:], []
        for arrival in arrivals:
            self._last_frame_s = arrival.host_s
            if arrival.frame.received < self.options.least_packets:
                self._tally.frames_rejected += 1
                continue
            self._restarts = 0
            if len(self._frames) >= self.options.kept_frames:
                self._tally.frames_overrun += 1
                self._frames.popleft()
            self._frames.append(self._depth_frame(arrival))
            if self.state is not SensorState.STREAMING:
                self.state, self._seen_before = SensorState.STREAMING, True
                self._say(None, opened.sends_depth)
        arrivals, opened.video[:] = opened.video[:], []
        for arrival in arrivals:
            frame = arrival.frame
            self._video.append(RawVideoFrame(frame.data, frame.ticks, arrival.host_s, frame.received, frame.expected))

    def _depth_frame(self, arrival: Arrival) -> RawDepthFrame:
        frame, time_s = arrival.frame, self._capture.seconds(arrival.frame.ticks, arrival.host_s)
        return RawDepthFrame(unpack11(frame.data).reshape(480, 640), frame.ticks, time_s, frame.received, frame.expected)

    def _judge_losses(self, opened: OpenedKinect, now: float) -> None:
        sentence = self._losses.look(self.counters(), now)
        if sentence:
            self._say(Fault.LOSSY, sentence)
        elif sentence == "" and self.fault is Fault.LOSSY:
            self._say(None, opened.sends_depth)

    def _still_there(self, opened: OpenedKinect, now: float) -> bool:
        """Some systems let a stream fall silent instead of saying that its device is gone."""
        if now - self._last_presence_s < self.options.presence_after_s:
            return True
        self._last_presence_s = now
        return any(kinect.key == opened.found.key for kinect in find_kinects(self._load()).kinects)

    def _attend_to_motor(self, opened: OpenedKinect, motor: Motor, now: float) -> None:
        try:
            while not self._requests.empty():
                self._requests.get()(motor)
            if now - self._last_level_s >= self.options.level_every_s:
                self._last_level_s = now
                self.level = motor.state()
        except TROUBLE:
            motor.close()
            opened.motor = None  # depth goes on without it

    def _wake(self, opened: OpenedKinect) -> None:
        """The watchdog: start the stream anew, and after some such attempts in vain the device."""
        self._restarts += 1
        self.state = SensorState.STARTING
        remedy = "try another USB port, straight in the computer, and check its 12 V supply."
        self._say(Fault.SILENT, f"The Kinect is plugged in but sends no pictures: {remedy}")
        if self._restarts >= self.options.restarts_before_reopen:
            self._tally.reopens += 1
            self._let_go()
            self._next_look_s = self._clock.now()
            return
        self._tally.stream_restarts += 1
        opened.stop_streams()
        opened.start_streams()
        self._last_frame_s = self._clock.now()

    def _fail(self, error: KinectError) -> None:
        """Let go of what there is, say what is wrong, look again soon."""
        was_open = self._opened is not None
        self._let_go()
        self.state = SensorState.SEARCHING
        if error.fault is Fault.UNPLUGGED or (self._seen_before and error.fault is Fault.NO_DEVICE):
            self._tally.unplugs += int(was_open)
            self._say(Fault.UNPLUGGED, "The Kinect was unplugged: plug it in again, and it goes on by itself.")
        else:
            self._tally.opens_failed += int(error.fault not in (Fault.NO_DEVICE, Fault.NO_LIBUSB))
            self._say(error.fault, str(error))
        self._next_look_s = self._clock.now() + self.options.look_every_s

    def _let_go(self) -> None:
        opened, self._opened = self._opened, None
        self.level = None
        if opened is not None:
            opened.close()

    def _say(self, fault: Fault | None, sentence: str) -> None:
        self.fault, self._sentence = fault, sentence

    def _request(self, request: Callable[[Motor], None]) -> None:
        opened = self._opened
        if opened is None:
            raise KinectError(self.fault or Fault.NO_DEVICE, self.status)
        if opened.motor is None:
            raise no_motor(opened.found.model)
        self._requests.put(request)
