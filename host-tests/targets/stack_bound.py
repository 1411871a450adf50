#!/usr/bin/env python3
"""Deepest stack of the monitor's calls, from the compiler's call graph.

    stack_bound.py FOLDER WINDOW     FOLDER: objects built with -fcallgraph-info=su,da

Prints `NAME BYTES` for push, step and report of the float monitor with that window, and the
path to each on the error stream. A recursion counts RECURSION times. Functions of libm and
of the ABI have no figure: each call to one counts LIBRARY bytes.
"""
import pathlib
import re
import subprocess
import sys

# Bytes that a call into libm or libgcc may need; the painted stack tells whether it is so.
LIBRARY = 160
# Function -> how often it can stand on the stack: std::sort halves its range in each.
RECURSION = {"__introsort_loop": 24}

# A function of several objects carries the path of one before its name.
NAME = r'"(?:[^":]*:)*([^":]+)"'
NODE = re.compile(rf'node: \{{ title: {NAME} label: "([^"]*)"')
EDGE = re.compile(rf'edge: \{{ sourcename: {NAME} targetname: {NAME}')
BYTES = re.compile(r"\\n(\d+) bytes \((static|dynamic|dynamic,bounded)\)")


def canonical(name):
    """Constructors and destructors have two names for one function."""
    return re.sub(r"([CD])1(?=E)", r"\g<1>2", name)


def read(folder):
    frames, calls = {}, {}
    for path in pathlib.Path(folder).rglob("*.ci"):
        text = path.read_text(errors="replace")
        for title, label in NODE.findall(text):
            title = canonical(title)
            match = BYTES.search(label)
            if match:
                if match.group(2) == "dynamic":
                    raise RuntimeError(f"{title}: a frame without a bound")
                frames[title] = max(frames.get(title, 0), int(match.group(1)))
        for source, target in EDGE.findall(text):
            calls.setdefault(canonical(source), set()).add(canonical(target))
    return frames, calls


class Graph:
    def __init__(self, frames, calls):
        self.frames, self.calls = frames, calls
        self.depth, self.next, self.open = {}, {}, []

    def deepest(self, name):
        """Bytes of `name` and the deepest of what it calls."""
        if name in self.depth:
            return self.depth[name]
        if name == "__indirect_call":
            raise RuntimeError(f"{self.open[-1]}: calls through a pointer")
        if name not in self.frames:
            return LIBRARY
        self.open.append(name)
        below, self.next[name] = 0, None
        times = 1
        for target in sorted(self.calls.get(name, ())):
            if target in self.open:
                times = self.recursion(name, target)
                continue
            depth = self.deepest(target)
            if depth > below:
                below, self.next[name] = depth, target
        self.open.pop()
        self.depth[name] = times * self.frames[name] + below
        return self.depth[name]

    def recursion(self, name, target):
        for known, times in RECURSION.items():
            if known in name and name == target:
                return times
        raise RuntimeError(f"{name} calls {target}, which is still open: an unknown recursion")

    def path(self, name):
        while name:
            yield name
            name = self.next.get(name)


def bounds(folder, window):
    """(call, bytes, path as (bytes, function)) for each call of the monitor."""
    frames, calls = read(folder)
    graph = Graph(frames, calls)
    for call in ("push", "step", "report"):
        pattern = re.compile(rf"_ZNK?5ident7MonitorIfLj{window}EE{len(call)}{call}E\w+\Z")
        roots = [name for name in frames if pattern.match(name)]
        if len(roots) != 1:
            raise RuntimeError(f"{call}: expected one function in {folder}, found {len(roots)}")
        deepest = graph.deepest(roots[0])
        names = subprocess.run(["c++filt"], input="\n".join(graph.path(roots[0])),
                               capture_output=True, text=True, check=True).stdout.splitlines()
        yield call, deepest, [(frames.get(title, LIBRARY), name)
                              for title, name in zip(graph.path(roots[0]), names)]


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    for call, deepest, path in bounds(*arguments):
        print(call, deepest)
        for size, name in path:
            print(f"  {size:6} {name}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
