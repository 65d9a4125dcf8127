"""Depth pictures: from raw disparity to metres, points, the floor, and recordings of all that."""
