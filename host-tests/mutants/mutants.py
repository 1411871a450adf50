#!/usr/bin/env python3
"""Tests the unit tests: changes one place of the sources at a time and sees whether a test
notices.

    host-tests/mutants/mutants.py                      # 500 points of lib/ident and lib/wire
    host-tests/mutants/mutants.py --match lib/wire/isotp --sample 0
    host-tests/mutants/mutants.py --again              # what survived the last run

Changed are comparisons (by one step between whole numbers, else turned round), + - * / <<
>> & |, && and ||, conditions (negated), numbers and constants (one more, reals twice that),
and statements (left out). One instrumented copy of the sources holds all of these points,
switched at run time, so it is built once, in build/mutants. A first run of the tests notes
which of them reach which point and how long they take. Then each point of the sample is
switched on and the unit tests that reach it run, those of its own test file first, each group
the fastest first, until one fails, crashes or takes several times as long as usual, or
--seconds of them have passed. What is alive then meets the laws, the comparisons with other
arithmetic and the longer unit tests for --whole seconds more; those that these kill are
counted in a column of their own, and the rest has survived.

The same seed and sources give the same sample and, but for time limits, the same answers.
A point whose operands are known only to an instantiation of a template, or that stands in
a constexpr function, counts if a test reaches it. Needs python3-clang, CMake and ninja.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import math
import os
import pathlib
import pickle
import random
import re
import resource
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import points as finder  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
WORK = ROOT / "build" / "mutants"
COPY, BUILD = WORK / "copy", WORK / "build"
CHANGED = ("lib/ident", "lib/wire")
PARSE = ["-std=c++20", "-DEIGEN_DONT_VECTORIZE", "-DEIGEN_NO_IO", f"-I{ROOT}",
         f"-I{ROOT}/lib", "-isystem", "/usr/include/eigen3"]
FLAGS = "-O1 -D_GLIBCXX_ASSERTIONS"
MOST_MEMORY = 4 << 30
ALWAYS = {"RC_PARAMS": "seed=1"}


def find_points():
    """Points of the sources; kept until one of them or the finder changes."""
    files = sorted(str(path.relative_to(ROOT)) for folder in CHANGED
                   for path in (ROOT / folder).rglob("*.?pp"))
    state = hashlib.sha256((HERE / "points.py").read_bytes())
    for name in files:
        state.update(name.encode() + (ROOT / name).read_bytes())
    kept = WORK / "points"
    if kept.exists():
        known, found = pickle.loads(kept.read_bytes())
        if known == state.digest():
            return found
    found = finder.points_of(ROOT, files, PARSE)
    WORK.mkdir(parents=True, exist_ok=True)
    kept.write_bytes(pickle.dumps((state.digest(), found)))
    for name in ("refused", "reached_unit_tests", "reached_whole_tests"):  # they know points by their numbers
        (WORK / name).unlink(missing_ok=True)
    return found


def write_copy(found, refused):
    """Only files that change are written, so that only those are compiled."""
    of_file = collections.defaultdict(list)
    for point in found:
        if point.id not in refused:
            of_file[point.file].append(point)
    for folder in (*CHANGED, "workbench"):
        for path in (ROOT / folder).rglob("*.?pp"):
            name = str(path.relative_to(ROOT))
            text = finder.instrument(path.read_bytes(), of_file[name])
            target = COPY / name
            if not target.exists() or target.read_bytes() != text:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(text)


def refused_by(log, found):
    """Points on lines that the compiler refuses: their place has to be constant after all."""
    lines = {(name, int(line)) for name, line in
             re.findall(rf"{COPY}/(\S+?):(\d+):\d+: (?:error|  required)", log)}
    texts = {name: (ROOT / name).read_bytes() for name, _ in lines if (ROOT / name).exists()}
    return {p.id for p in found if p.file in texts for offset, *_ in p.edits
            if (p.file, texts[p.file].count(b"\n", 0, offset) + 1) in lines}


def make(target, jobs):
    """What the compiler says where it fails, else nothing."""
    subprocess.run(
        ["cmake", "-S", HERE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=",
         f"-DCMAKE_CXX_FLAGS={FLAGS}", f"-DSWITCHED_COPY={COPY}"],
        check=True, stdout=subprocess.DEVNULL)
    done = subprocess.run(["ninja", "-C", BUILD, "-k0", f"-j{jobs}", target], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.stdout if done.returncode else ""


def build(found, jobs):
    """Builds the tests with the copy; gives the points that the compiler refuses."""
    kept = WORK / "refused"
    refused = set(map(int, kept.read_text().split())) if kept.exists() else set()
    for target in ("device", "all"):  # the tests take longer, so they come last
        write_copy(found, refused)
        while log := make(target, jobs):
            more = refused_by(log, found) - refused
            if not more:
                told = "\n".join(line for line in log.splitlines() if "error" in line)
                sys.exit(f"the instrumented copy does not build:\n{told or log[-4000:]}")
            refused |= more
            kept.write_text(" ".join(map(str, sorted(refused))))
            write_copy(found, refused)
    return refused


Test = collections.namedtuple("Test", "program name file seconds points")


def find_reach(program, most):
    """What runs before all tests, and the tests; kept until the program changes. Tests that
    took longer than the most seconds of a mutant are not asked again."""
    kept = WORK / f"reached_{program}"
    if not kept.exists() or kept.stat().st_mtime < (BUILD / program).stat().st_mtime:
        known = kept.read_text().splitlines() if kept.exists() else []
        slow = [line for line in known if int(line.split("\t")[2]) > 1000 * most]
        new = WORK / "reached.new"
        done = subprocess.run(
            [BUILD / program, "--gtest_filter=-" + ":".join(line.split("\t")[0] for line in slow)],
            env={**os.environ, **ALWAYS, "REACHED": str(new)}, text=True, cwd=WORK,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        failing = set(re.findall(r"FAILED  \] (\S+?),? (?:\(|where)", done.stdout))
        if done.returncode not in (0, 1):
            sys.exit(f"the tests crash without a mutant:\n{done.stdout[-4000:]}")
        for name in sorted(failing):
            print(f"left out, for it fails without a mutant: {name}", flush=True)
        lines = [line for line in new.read_text().splitlines() + slow
                 if line.split("\t")[0] not in failing]
        new.write_text("".join(f"{line}\n" for line in lines))
        new.rename(kept)
    tests = []
    for line in kept.read_text().splitlines():
        name, file, ms, ids = line.split("\t")
        file = file.partition("host-tests/")[2].removeprefix("unit/")
        tests.append(Test(program, name, file, int(ms) / 1000, frozenset(map(int, ids.split()))))
    return tests[0].points, tests[1:]


def is_mirror(source, test_file):
    """unit/wire/test_isotp_busy.cpp is of lib/wire/isotp.cpp, and so is isotp_send.cpp."""
    source = pathlib.PurePath(source.removeprefix("lib/"))
    test = pathlib.PurePath(test_file)
    a, b = source.stem + "_", test.stem.removeprefix("test_") + "_"
    return source.parent == test.parent and (a.startswith(b) or b.startswith(a))


def seeing(point, before_all, tests):
    """Tests that can see the point, in the order in which they run."""
    own = [t for t in tests if is_mirror(point.file, t.file)]
    wanted = [t for t in own if point.id in t.points or point.id in before_all]
    others = [t for t in tests if point.id in t.points and t not in own]
    return sorted(wanted, key=lambda t: t.seconds) + sorted(others, key=lambda t: t.seconds)


def within(tests, seconds):
    """As many of the tests as the seconds allow."""
    taken = []
    for test in tests:
        if sum(t.seconds for t in taken) + test.seconds <= seconds:
            taken.append(test)
    return taken


def batches(tests):
    """Tests of one program in groups that take about twice as long each."""
    group, room = [], 0.25
    for test in tests:
        if group and (sum(t.seconds for t in group) >= room or group[0].program != test.program):
            yield group
            group, room = [], 2 * room
        group.append(test)
    if group:
        yield group


def limits(seconds):
    def apply():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    return apply


def killed_by(point, groups):
    """The file or the fault that ends the mutant, or nothing."""
    for group in groups:
        usual = sum(t.seconds for t in group)
        most = math.ceil(3 * usual + 2)
        command = [BUILD / group[0].program, "--gtest_fail_fast", "--gtest_brief=1",
                   "--gtest_filter=" + ":".join(t.name for t in group)]
        try:
            done = subprocess.run(command, env={**os.environ, **ALWAYS, "MUTANT": str(point.id)}, cwd=WORK,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                  preexec_fn=limits(most), timeout=20 * most)
        except subprocess.TimeoutExpired:
            return "time limit"
        if done.returncode < 0:
            return "time limit" if done.returncode in (-24, -9) else "crash"
        if done.returncode > 0:
            failed = re.search(rb"FAILED  \] (\S+)", done.stdout)
            return failed.group(1).decode().rstrip(",") if failed else "failure"
    return ""


def room_of(name):
    return str(pathlib.PurePath(name).parent)


def print_table(countable, tried, killed, later):
    print("\n| room | places | tried | killed | then by the whole |\n|---|---|---|---|---|")
    for room in sorted({room_of(p.file) for p in countable}) + ["all"]:
        here = [sum(room in ("all", room_of(p.file)) for p in part)
                for part in (countable, tried, killed, later)]
        shares = [f"{100 * n / here[1]:.0f} %" if here[1] else "–"
                  for n in (here[2], here[2] + here[3])]
        print(f"| {room} | {here[0]} | {here[1]} | {shares[0]} | {shares[1]} |")


def choose(countable, arguments):
    matching = [p for p in countable if re.search(arguments.match, p.name)]
    if arguments.again:
        survivors = set((WORK / "survivors").read_text().splitlines())
        return [p for p in matching if p.name in survivors]
    if not arguments.sample or arguments.sample >= len(matching):
        return matching
    chosen = random.Random(arguments.seed).sample(matching, arguments.sample)
    return sorted(chosen, key=lambda p: p.id)


def parsed():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, default=500, help="points to try; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--match", default="", help="regular expression of file:line:column: change")
    parser.add_argument("--again", action="store_true", help="only what survived last time")
    parser.add_argument("--seconds", type=float, default=4, help="of unit tests for one mutant")
    parser.add_argument("--whole", type=float, default=20,
                        help="of laws and longer unit tests for what is alive then; 0: none")
    parser.add_argument("--jobs", type=int, default=1,
                        help="of the build, and mutants that are tried at once")
    parser.add_argument("--list", action="store_true", help="print the points and stop")
    return parser.parse_args()


def main():
    arguments = parsed()
    for tool in ("cmake", "ninja"):
        if not shutil.which(tool):
            sys.exit(f"{tool} is missing: apt-get install cmake ninja-build")
    found = find_points()
    if arguments.list:
        print("\n".join(p.name for p in found if re.search(arguments.match, p.name)))
        return
    refused = build(found, arguments.jobs)
    print(f"{len(found)} points, {len(refused)} of them refused by the compiler", flush=True)
    most = max(arguments.seconds, arguments.whole)
    before_all, units = find_reach("unit_tests", most)
    before_laws, laws = (find_reach("whole_tests", most) if arguments.whole
                         else (frozenset(), []))
    reached = (before_all | before_laws).union(*(t.points for t in units + laws))
    countable = [p for p in found if p.id not in refused and (p.sure or p.id in reached)]
    chosen = choose(countable, arguments)
    killed, later, survivors = [], [], []

    def tried(point):
        first = within(seeing(point, before_all, units), arguments.seconds)
        if by := killed_by(point, batches(first)):
            return killed, by
        rest = [t for t in units if t not in first]
        rest = seeing(point, before_all, rest) + seeing(point, before_laws, laws)
        rest.sort(key=lambda t: t.seconds)
        by = killed_by(point, batches(within(rest, arguments.whole)))
        return (later if by else survivors), by

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for point, (kind, by) in zip(chosen, pool.map(tried, chosen)):
            kind.append(point)
            unseen = "" if by or point.id in reached else " (no test reaches it)"
            outcome = ("killed" if kind is killed else
                       "killed later" if kind is later else "survived")
            print(f"{outcome}: {point.name}{unseen} {by}", flush=True)
    print_table(countable, chosen, killed, later)
    print("\nSurvivors:")
    print("\n".join(f"- {p.name}" for p in survivors) or "none")
    (WORK / "survivors").write_text("".join(f"{p.name}\n" for p in survivors))


if __name__ == "__main__":
    main()
