"""Telling a bad USB host: the share of packets lost, looked at every few seconds."""

from kinect.usb.counters import Counters


class LossWatch:
    """Compares the counters with those of some seconds ago."""

    def __init__(self, every_s: float, share_to_tell: float) -> None:
        self._every_s, self._share_to_tell = every_s, share_to_tell
        self._before, self._looked_s = Counters(), 0.0

    def begin(self, counters: Counters, now: float) -> None:
        """The stream starts anew."""
        self._before, self._looked_s = counters, now

    def look(self, counters: Counters, now: float) -> str | None:
        """What to say of the losses since the last look: a sentence, "" where all is well, None where it is too early to look."""
        if now - self._looked_s < self._every_s:
            return None
        lost = counters.lost_packets - self._before.lost_packets
        share = lost / max(lost + counters.packets - self._before.packets, 1)
        self.begin(counters, now)
        if share <= self._share_to_tell:
            return ""
        remedy = "try another USB port, straight in the computer, with no hub or webcam beside it."
        return f"{share:.0%} of the Kinect's packets are lost on the way: {remedy}"
