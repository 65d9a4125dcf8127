"""Balance strategy `whole-body`: a capture-point planner and an inverse-dynamics QP that give torques for every joint at once."""
