"""Runs one file of tests; 77, with the reason, where pytest or NumPy is absent."""
import importlib.util
import pathlib
import sys

missing = [name for name in ("pytest", "numpy") if importlib.util.find_spec(name) is None]
if missing:
    print("skipped: install " + ", ".join(f"python3-{name}" for name in missing))
    sys.exit(77)

import pytest  # noqa: E402

FOLDER = pathlib.Path(__file__).parent
sys.exit(pytest.main(["-q", "-rs", "-p", "no:cacheprovider", f"--rootdir={FOLDER}",
                      str(FOLDER / sys.argv[1])]))
