"""Everything that must be green: ruff, the format, the types, then the tests. Arguments go to pytest."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]

CHECKS = {
    "ruff check": ["ruff", "check", "--output-format", "concise"],
    "ruff format": ["ruff", "format", "--check", "--output-format", "concise"],
    "pyright": ["pyright", "--pythonpath", sys.executable],
}


def main(arguments: list[str]) -> int:
    """Run all checks, the tests last so that their closing line is; 0 where everything is green."""
    # Two test processes on two cores: linear algebra with threads of its own would only get in their way.
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    red = []
    for name, command in CHECKS.items():
        print(f"check: {name}", flush=True)
        if subprocess.run([sys.executable, "-m", *command], cwd=ROOT, env=environment).returncode != 0:
            red.append(name)
    print("check: pytest", flush=True)
    pytest = [sys.executable, "-m", "pytest", "-n", "2", "--dist", "loadfile", "--no-loadscope-reorder", *arguments]
    tests = subprocess.run(pytest, cwd=ROOT, env=environment).returncode
    if red:
        print(f"check: not green before the tests: {', '.join(red)}", flush=True)
    return tests or int(bool(red))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
