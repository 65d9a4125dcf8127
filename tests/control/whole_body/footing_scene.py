"""The scene in which the tests of footing play: a body over its soles, a capture point, and what the player does."""

import numpy as np

from game.control.whole_body.capture_point import natural_frequency
from game.control.whole_body.contact_states import Phase
from game.control.whole_body.footing import Footing
from game.control.whole_body.sole import Sole
from game.control.whole_body.sway import Sway
from game.control.whole_body.wish import Wish

LEFT, RIGHT = 0, 1
OMEGA = natural_frequency(9.81, 0.95)
DT = 1.0 / 120.0
HALF_LENGTH, HALF_WIDTH = 0.15, 0.045
STAND = np.array([[0.0, 0.1], [0.0, -0.1]])
CENTRED = np.zeros(2)
STANDS, SWINGS, STEPS = Phase.STANCE, Phase.SWING, Phase.STEP


class Scene:
    """Two feet, a capture point and a player, all moved by hand."""

    def __init__(self):
        self.footing = Footing()
        self.place, self.height, self.yaw = STAND.copy(), [0.0, 0.0], [0.0, 0.0]
        self.touches = [True, True]
        self.xi = CENTRED.copy()
        self.up, self.flight = (False, False), False
        self.wished, self.wished_yaw = STAND.copy(), (0.0, 0.0)
        self.sway_m, self.thrown, self.taking_off = 0.0, False, False
        self.push, self.load = np.zeros(2), (0.5, 0.5)

    def soles(self) -> tuple[Sole, Sole]:
        return self.sole(LEFT), self.sole(RIGHT)

    def sole(self, side: int) -> Sole:
        centre, ankle = np.array([*self.place[side], self.height[side]]), np.array([*self.place[side], 0.09])
        return Sole(centre, self.yaw[side], ankle, self.touches[side], HALF_LENGTH, HALF_WIDTH)

    def go(self, seconds=DT):
        for _ in range(max(1, round(seconds / DT))):
            self.footing.update(self.soles(), self.sway(), self.wish(), self.taking_off, DT)
        return self.phases()

    def wish(self) -> Wish:
        return Wish(self.up, self.flight, self.wished.copy(), self.wished_yaw)

    def sway(self) -> Sway:
        return Sway(self.xi, OMEGA, self.sway_m, self.thrown, self.push, self.load)

    def phases(self):
        return tuple(foot.phase for foot in self.footing.feet)

    def lift_off(self, side, height=0.05):
        self.touches[side], self.height[side] = False, height

    def put_down(self, side):
        self.touches[side], self.height[side] = True, 0.0
