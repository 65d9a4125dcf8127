"""What sees a person: body frames, recordings and, later, the Kinect v1 itself. Never imports `game`."""
