#!/usr/bin/env python3
"""Gate on the loops of lib/ident: each has an end that a reader can find.

    check_loops.py ROOT            every loop that is not counted stands in docs/memory.md
    check_loops.py ROOT --write    lists the counted ones there, between the markers

A counted loop runs over a container, or from a start to an end that is fixed when it
begins, by a step: `for (x = A; x < END; ++x)`. Any other loop needs a line in the table of
docs/memory.md that names its file and its condition and says why it ends.
"""
import pathlib
import re
import sys

import check_sources

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "docs"))
import between_markers  # noqa: E402

FOLDER = "lib/ident"
PAGE = "docs/memory.md"
ORDER = re.compile(r"(?:<=|>=|<|>|!=)")
STEP = re.compile(r"(?:\+\+|--|\+=|-=)")


def heads(text):
    """(kind, what stands between the parentheses) of every for and while."""
    for match in re.finditer(r"\b(for|while)\s*\(", text):
        depth, at = 1, match.end()
        while depth > 0:
            depth += {"(": 1, ")": -1}.get(text[at], 0)
            at += 1
        yield match.group(1), " ".join(text[match.end():at - 1].split())


def is_counted(kind, head):
    if kind == "while":
        return False
    parts = head.split(";")
    if len(parts) == 1:
        return " : " in head
    return len(parts) == 3 and bool(STEP.search(parts[2]) or "-- > 0" in parts[1])


def end_of(head):
    """What a counted loop runs to or over."""
    if ";" not in head:
        return head.split(" : ", 1)[1]
    condition = head.split(";")[1].strip()
    return re.sub(r"^\w+(?:-- > )?", "", condition).strip() if ORDER.search(condition) else condition


def loops(root):
    """(file, kind, head) of every loop."""
    for path in sorted((root / FOLDER).rglob("*.?pp")):
        text = check_sources.without_comments(path.read_text(errors="replace"))
        for kind, head in heads(text):
            yield path.relative_to(root / FOLDER).as_posix(), kind, head


def condition_of(kind, head):
    return head if kind == "while" else head.split(";")[1].strip()


def check(root):
    page = (root / PAGE).read_text()
    listed = {tuple(cell.strip().strip("`") for cell in line.split("|")[1:3])
              for line in page.splitlines() if line.startswith("| `")}
    for name, kind, head in loops(root):
        if not is_counted(kind, head):
            key = (name, condition_of(kind, head).replace("||", "or").replace("|", "or"))
            if key not in listed:
                yield (f"{FOLDER}/{name}: {kind} ({head}) is not counted: count it, or add to "
                       f"{PAGE}\n| `{key[0]}` | `{key[1]}` | why it ends |")


def table(root):
    ends = {}
    for name, kind, head in loops(root):
        if is_counted(kind, head):
            ends.setdefault(name, []).append(end_of(head))
    lines = ["| file | counted loops | they run to, or over |", "|:--|--:|:--|"]
    for name, found in ends.items():
        distinct = ", ".join(f"`{end}`" for end in dict.fromkeys(found)).replace("|", "or")
        lines.append(f"| {name} | {len(found)} | {distinct} |")
    return "\n".join(lines)


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--write"]):
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[0])
    if arguments[1:]:
        between_markers.replace(root / PAGE, "loops", table(root))
        return 0
    offences = list(check(root))
    print("\n".join(offences) if offences else "clean")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
