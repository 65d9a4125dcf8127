"""A simulated USB host controller: devices come and go, transfers queue on endpoints, and a microframe nobody listens to is lost."""

import itertools
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kinect.usb.clock import Clock
from kinect.usb.simulated_camera import SimulatedCamera
from kinect.usb.simulated_clock import VirtualClock
from kinect.usb.simulated_devices import ERROR_NO_DEVICE, ERROR_NO_MEM, SimulatedDevice
from kinect.usb.simulated_kinect import SimulatedKinect
from kinect.usb.simulated_stream import MICROFRAMES_PER_S

COMPLETED, FAILED, CANCELLED, NO_DEVICE = 0, 1, 3, 5
RESTART_S: Final = 0.0005
"""What an idle endpoint needs before it listens again."""
SLICE_S: Final = 0.01


@dataclass
class Submission:
    """A transfer in flight. slots: (n, s) octets; finish: takes (status, lengths, statuses) and calls the program back."""

    device: SimulatedDevice
    endpoint: int
    slots: NDArray[np.uint8]
    finish: Callable[[int, NDArray[np.uint32], NDArray[np.int32]], None]
    begin: int
    due: float
    order: int
    status: int = COMPLETED


class SimulatedHost:
    """Time, devices and transfers. loss: share of packets that this host corrupts. callback_s: virtual time that each callback takes."""

    def __init__(self, clock: Clock, callback_s: float = 0.0, loss: float = 0.0, largest_queue: int = 1 << 30, seed: int = 0) -> None:
        self.clock, self.callback_s, self.loss, self.largest_queue = clock, callback_s, loss, largest_queue
        self.devices: list[SimulatedDevice] = []
        self.submissions: dict[int, Submission] = {}
        self.lock = threading.RLock()
        self.finished = 0
        self.own_cpu_s = self.called_back_s = 0.0  # CPU time of this simulation's own events, and of the program's callbacks
        self._schedule: list[tuple[float, int, Callable[[], Any]]] = []
        self._tails: dict[tuple[int, int], int] = {}
        self._order = itertools.count()
        self._addresses = itertools.count(5)
        self._random = np.random.default_rng(seed)

    def plug(self, kinect: SimulatedKinect) -> None:
        """Plug a Kinect in: it gets new addresses."""
        with self.lock:
            for device in kinect.devices:
                device.address, device.gone = next(self._addresses) % 128, False
                device.reset(self.clock.now())
                self.devices.append(device)

    def unplug(self, kinect: SimulatedKinect, silent: bool = False) -> None:
        """Pull it out. `silent`: the transfers in flight never come back by themselves, as on some systems."""
        with self.lock:
            for device in kinect.devices:
                device.gone = True
                self.devices = [d for d in self.devices if d is not device]
                for submission in self.submissions.values():
                    if submission.device is device:
                        submission.due = 1e12 if silent else self.clock.now()
                        submission.status = NO_DEVICE

    def at(self, time_s: float, action: Callable[[], Any]) -> None:
        """Do something at a moment of this host's time."""
        with self.lock:
            self._schedule.append((time_s, next(self._order), action))
            self._schedule.sort(key=lambda entry: entry[:2])

    def submit(self, key: int, device: SimulatedDevice, endpoint: int, slots: NDArray[np.uint8], finish: Callable[..., None]) -> int:
        """Queue a transfer behind the others of its endpoint; an idle endpoint needs a while to wake. 0 or libusb's error."""
        if device.gone:
            return ERROR_NO_DEVICE
        queued = sum(len(s.slots) for s in self.submissions.values() if s.device is device and s.endpoint == endpoint)
        if queued + len(slots) > self.largest_queue:
            return ERROR_NO_MEM
        now = self.clock.now()
        pipe = (id(device), endpoint)
        begin = self._tails.get(pipe, 0)
        if begin <= now * MICROFRAMES_PER_S:
            begin = int(np.ceil((now + RESTART_S) * MICROFRAMES_PER_S))
        self._tails[pipe] = begin + len(slots)
        due = (begin + len(slots)) / MICROFRAMES_PER_S
        self.submissions[key] = Submission(device, endpoint, slots, finish, begin, due, next(self._order))
        return 0

    def cancel(self, key: int) -> bool:
        """Call a transfer back. False where it is not in flight."""
        submission = self.submissions.get(key)
        if submission is None:
            return False
        submission.due, submission.status = self.clock.now(), CANCELLED
        self._tails.pop((id(submission.device), submission.endpoint), None)
        return True

    def handle_events(self, timeout_s: float) -> None:
        """As libusb does: call back for what is done, or wait for the next, at most so long."""
        began = time.thread_time() - self.called_back_s
        self._handle_events(timeout_s)
        self.own_cpu_s += time.thread_time() - self.called_back_s - began

    def _handle_events(self, timeout_s: float) -> None:
        deadline = self.clock.now() + timeout_s
        before = self.finished
        while True:
            with self.lock:
                self.dispatch()
                now = self.clock.now()
                upcoming = min([s.due for s in self.submissions.values()] + [t for t, _, _ in self._schedule[:1]], default=deadline)
            if self.finished != before or now >= deadline:
                return
            wait = max(min(upcoming, deadline) - now, 0.0)
            self.clock.sleep(wait if isinstance(self.clock, VirtualClock) else min(wait, SLICE_S))

    def dispatch(self) -> None:
        """Let everything happen that is due, in order of time."""
        while True:
            now = self.clock.now()
            key = min(self.submissions, key=lambda k: (self.submissions[k].due, self.submissions[k].order), default=None)
            due = self.submissions[key].due if key is not None else np.inf
            if self._schedule and self._schedule[0][0] <= min(now, due):
                self._schedule.pop(0)[2]()
            elif key is not None and due <= now:
                self._finish(self.submissions.pop(key))
            else:
                return

    def forget_program(self) -> None:
        """The program was killed: nobody is called back any more, its claims are void. The devices notice nothing."""
        with self.lock:
            self.submissions.clear()
            self._tails.clear()
            for device in self.devices:
                device.claimed_by = None

    def _finish(self, submission: Submission) -> None:
        slots, device = submission.slots, submission.device
        lengths = np.zeros(len(slots), np.uint32)
        statuses = np.zeros(len(slots), np.int32)
        stream = device.streams.get(submission.endpoint) if isinstance(device, SimulatedCamera) and device.sends else None
        if submission.status == COMPLETED and stream is not None:
            lengths = stream.fill(submission.begin, slots)
            if self.loss:
                hit = self._random.random(len(slots)) < self.loss
                statuses[hit] = FAILED
                lengths[hit] = 0
        self.finished += 1
        began = time.thread_time()
        submission.finish(submission.status, lengths, statuses)
        self.called_back_s += time.thread_time() - began
        if self.callback_s:
            self.clock.sleep(self.callback_s)
