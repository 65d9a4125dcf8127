"""The living room, one module a piece of furniture."""
