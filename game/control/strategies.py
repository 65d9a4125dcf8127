"""The balance strategies by name: a new one is one module and one line here (and its word in `balance.strategy`)."""

from collections.abc import Callable, Mapping

from game.control.ankle_strategy import AnkleStrategy
from game.control.joint_command import BalanceStrategy
from game.control.pose_only import PoseOnly
from game.control.virtual_actuation import VirtualActuation
from game.control.whole_body.whole_body import WholeBody
from game.tunables import Settings

STRATEGIES: Mapping[str, Callable[[Settings], BalanceStrategy]] = {
    "none": PoseOnly,
    "ankle": AnkleStrategy,
    "virtual-actuation": VirtualActuation,
    "whole-body": WholeBody,
}
