"""What holds for all tests: property tests try the same examples every time, and a slow machine is no failure."""

from hypothesis import settings

settings.register_profile("topple", derandomize=True, deadline=None)
settings.load_profile("topple")
