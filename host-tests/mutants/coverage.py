#!/usr/bin/env python3
"""Lines and branches of lib/ident and lib/wire that their unit tests run, a row a room.

    host-tests/mutants/coverage.py [--jobs 1] [--files]

Builds the tests with --coverage in build/coverage, runs them, and adds up what gcovr counts;
branches that only an exception takes are left out. --files: a row a file. Needs gcovr, CMake
and ninja.
"""
import argparse
import collections
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
BUILD = ROOT / "build" / "coverage"
COUNTED = ("lib/ident", "lib/wire")
COUNTS = ("line_covered", "line_total", "branch_covered", "branch_total")


def build(jobs):
    subprocess.run(
        ["cmake", "-S", HERE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=",
         "-DCMAKE_CXX_FLAGS=-O1 --coverage"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", BUILD, "--quiet", f"-j{jobs}", "unit_tests"], check=True)


def run_tests():
    for counts in BUILD.rglob("*.gcda"):
        counts.unlink()
    done = subprocess.run([BUILD / "unit_tests", "--gtest_brief=1"], cwd=BUILD, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"the tests fail:\n{done.stdout[-4000:]}")


def counted():
    """Each file and its COUNTS."""
    filters = [word for folder in COUNTED for word in ("--filter", f"{ROOT}/{folder}/")]
    report = subprocess.run(
        ["gcovr", "--root", ROOT, *filters, "--exclude-throw-branches", "--json-summary",
         "--gcov-ignore-parse-errors", BUILD], check=True, text=True,
        stdout=subprocess.PIPE).stdout
    return {f["filename"]: [f[count] for count in COUNTS] for f in json.loads(report)["files"]}


def share(covered, total):
    return f"{covered} of {total} | {100 * covered / total:.1f} %" if total else "– | –"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=1, help="of the build")
    parser.add_argument("--files", action="store_true", help="a row a file")
    arguments = parser.parse_args()
    for tool, package in (("gcovr", "gcovr"), ("cmake", "cmake"), ("ninja", "ninja-build")):
        if not shutil.which(tool):
            sys.exit(f"{tool} is missing: apt-get install {package}")
    build(arguments.jobs)
    run_tests()
    rows = collections.defaultdict(lambda: [0] * len(COUNTS))
    for name, counts in counted().items():
        room = name if arguments.files else str(pathlib.PurePath(name).parent)
        for key in (room, "all"):
            rows[key] = [a + b for a, b in zip(rows[key], counts)]
    everything = rows.pop("all")
    print("| room | lines run | | branches taken | |\n|---|---|---|---|---|")
    for room, counts in [*sorted(rows.items()), ("all", everything)]:
        print(f"| {room} | {share(*counts[:2])} | {share(*counts[2:])} |")


if __name__ == "__main__":
    main()
