"""A Kinect v1 over USB: from libusb to whole frames of raw disparity. Verified in simulation and on recordings, not yet on hardware."""
