#!/usr/bin/env python3
"""The README's table of how good it is, from the pages that scorers write.

usage: readme_figures.py [--check] [FOLDER]

Reads docs/scores.md, docs/hidden-effects.md and docs/tests.md of the repository FOLDER (the one this
file is in) and puts the table between the markers of README.md. With --check nothing is
written; exit code 1 where the README says something else than the pages.
"""
import argparse
import pathlib
import re
import sys

import between_markers


class Page:
    """A Markdown page whose tables are looked up by what stands before them."""

    def __init__(self, path):
        self.path = path
        self.text = path.read_text(encoding="utf-8")

    def row(self, heading, first_cell):
        """Cells after `first_cell` of the first table row below the line `heading`."""
        start = self.text.find("\n" + heading)
        match = start >= 0 and re.search(
            rf"^\| {re.escape(first_cell)} \|(.*)\|$", self.text[start:], re.MULTILINE)
        if not match:
            sys.exit(f"{self.path}: expected a row '{first_cell}' below '{heading}'; "
                     "did the scorer change its table? Then change readme_figures.py, too")
        return [cell.strip() for cell in match.group(1).split("|")]


def table(root):
    """The README's table, from the pages below `root`."""
    scores = Page(root / "docs/scores.md")
    hidden = Page(root / "docs/hidden-effects.md")
    tests = Page(root / "docs/tests.md")
    found = scores.row("Simulated sticking loops", "all")[1]
    n, *false = map(int, scores.row("Simulated loops without stiction", "all")[:3])
    loads_found = scores.row("Sticking, by motion of the valve", "all")[2]
    loads_n, loads_false = scores.row("Healthy, without a neighbour that sticks", "all")[:2]
    near_n, near_false = scores.row("Healthy, by cause", "neighbour")[:2]
    own_n, own_false = scores.row(
        "Loops whose valve follows, under a load that comes back at its own time", "all")[:2]
    any_n, any_false = scores.row(
        "Loops whose valve follows, under a load that is switched at any time", "all")[:2]
    blind_n, _, blind_false = scores.row(
        "Nothing but the controller moves u: what explain names", "all")[:3]
    right = [tuple(map(int, pair)) for pair in
             re.findall(r"^(\d+) of (\d+)(?: loops)? right$", scores.text, re.MULTILINE)]
    if len(right) != 2:
        sys.exit(f"{scores.path}: expected two lines like '11 of 12 right', found {len(right)}")
    sacac = scores.text[scores.text.find("\nSACAC recordings"):]
    verdicts = re.findall(r"^\| \S+ \| \S+ \| \S+ \| (right|wrong) \|", sacac, re.MULTILINE)
    right.append((verdicts.count("right"), len(verdicts)))
    called = re.findall(r"^\| \S+ \| other \|(?: [\d, ]+ \|)? (stiction|backlash) \|",
                        scores.text, re.MULTILINE)
    named = hidden.row("### One hidden effect, % of recordings",
                       "right effect or its group named first")[3]
    wrong = hidden.row("### One hidden effect, % of recordings", "wrong name first")[3]
    noticed = tests.row("## What tests notice", "all")[3]
    taken = tests.row("## What they run", "all")[3]
    lines = [
        "| | found or right | false |",
        "|---|---|---|",
        f"| simulated loops, sticking; healthy | {found} % | {sum(false)} of {n} |",
        "| the same under loads cut from real recordings, through historians "
        f"| {loads_found} % | {loads_false} of {loads_n} |",
        "| … healthy loops that a neighbour's sticking valve shakes "
        f"| | {near_false} of {near_n} |",
        "| … under a load that comes back at its own time; that is switched at any time "
        f"| | {own_false} of {own_n}; {any_false} of {any_n} |",
        "| recordings of plants with a published cause "
        f"| {sum(r for r, _ in right)} of {sum(n for _, n in right)} | {len(called)} |",
        f"| one hidden effect of a simulated loop named first | {named} % | {wrong} % |",
        "| … where nothing but the controller moves u, and so none can be told "
        f"| | {blind_false} of {blind_n} |",
        f"| one place of the device's code changed: tests notice | {noticed} | |",
        f"| branches of the device's code that unit tests take | {taken} | |",
    ]
    return "".join(line + "\n" for line in lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("folder", nargs="?", type=pathlib.Path,
                        default=pathlib.Path(__file__).parents[2])
    options = parser.parse_args()
    readme = options.folder / "README.md"
    text = readme.read_text(encoding="utf-8")
    try:
        fresh = between_markers.replaced(text, "figures", table(options.folder))
    except ValueError as wrong:
        sys.exit(f"{readme}: {wrong}")
    if options.check and fresh != text:
        sys.exit(f"{readme}: its figures are not those of docs/; run {pathlib.Path(__file__).name}")
    if not options.check:
        readme.write_text(fresh, encoding="utf-8")


if __name__ == "__main__":
    main()
