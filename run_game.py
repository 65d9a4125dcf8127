"""The door of the house: hands the command line to game/commands/."""

from game.commands import main

if __name__ == "__main__":
    raise SystemExit(main())
