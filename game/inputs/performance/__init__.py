"""What the synthetic person does: a body, a script for each motion, and the balance that carries it out."""
