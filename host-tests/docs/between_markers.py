#!/usr/bin/env python3
"""Puts what a script measured where a page keeps it.

    between_markers.py PAGE NAME <TEXT

TEXT replaces what stands in PAGE between the lines <!-- NAME:begin --> and
<!-- NAME:end -->. Exit code 1, and the page as it was, where it has not just one such pair.
"""
import pathlib
import re
import sys


def replaced(page, name, text):
    """`page`, the text of one, with `text` between its markers; ValueError without them."""
    new, count = re.subn(rf"(<!-- {name}:begin -->\n).*?(<!-- {name}:end -->)",
                         lambda m: f"{m.group(1)}\n{text.strip()}\n\n{m.group(2)}", page,
                         flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"expected one pair of {name}:begin and {name}:end markers, found {count}")
    return new


def replace(path, name, text):
    """The same in the file at `path`, which the error names."""
    try:
        path.write_text(replaced(path.read_text(encoding="utf-8"), name, text), encoding="utf-8")
    except ValueError as wrong:
        raise ValueError(f"{path}: {wrong}") from None


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        replace(pathlib.Path(arguments[0]), arguments[1], sys.stdin.read())
    except (OSError, ValueError) as wrong:
        print(wrong, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
