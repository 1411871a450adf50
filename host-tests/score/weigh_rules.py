#!/usr/bin/env python3
"""What is each threshold of the verdict worth?

usage: weigh_rules.py BUILD [LOOPS]     BUILD: the host's build folder; LOOPS as of score_rules
Identifies loops whose valve is known once (BUILD/bin/score_rules), then judges them anew with one
threshold of judge.cpp or doubts.cpp after the other made next to nothing, a fifth smaller, a
quarter larger, and huge. Prints a Markdown table of what changes; a threshold whose row has no
change decides nothing here, and one that gives as many false alarms as it finds valves little.
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ("lib/ident/verdict/judge.cpp", "lib/ident/verdict/doubts.cpp")
THRESHOLD = re.compile(r"constexpr Threshold (k\w+) = Threshold\(([\d.]+)\);")
FACTORS = (1e-4, 0.8, 1.25, 1e5)
COLUMNS = ("found, simulated", "false", "found, real loads", "false", "healthy cleared",
           "sticking cleared")


def compile_command(build, source, target, output):
    """As the build compiles `target`, another source into another object."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if entry["file"] == str(ROOT / target) and "stickband_ident.dir" in entry["command"]:
            words = shlex.split(entry["command"])
            words[words.index("-o") + 1] = str(output)
            words[words.index("-c") + 1] = str(source)
            return words
    sys.exit(f"{target}: not in {build}/compile_commands.json; run ./dev build first")


def judged(build, folder, target, text, loops):
    """The six numbers with `text` in the place of `target`."""
    variant = folder / "variant.cpp"
    variant.write_text(text)
    subprocess.run(compile_command(build, variant, target, folder / "variant.o"), check=True)
    again = folder / "again"
    objects = build / "host-tests/score/CMakeFiles/judge_again.dir/judge_again.cpp.o"
    subprocess.run(["c++", str(objects), str(folder / "variant.o"),
                    str(build / "lib/ident/libstickband_ident.a"), "-o", str(again)], check=True)
    told = subprocess.run([again, loops], check=True, capture_output=True, text=True).stdout
    return [int(word) for word in told.split()]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        loops = folder / "loops"
        subprocess.run([build / "bin/score_rules", loops, *sys.argv[2:]], check=True)
        whole = judged(build, folder, SOURCES[0], (ROOT / SOURCES[0]).read_text(), loops)
        print("| threshold | at | " + " | ".join(COLUMNS) + " |")
        print("|---" * (len(COLUMNS) + 2) + "|")
        print("| as it is | | " + " | ".join(str(n) for n in whole) + " |")
        for target in SOURCES:
            text = (ROOT / target).read_text()
            for match in THRESHOLD.finditer(text):
                for factor in FACTORS:
                    value = float(match[2]) * factor
                    changed = (text[:match.start(2)] + repr(value) + text[match.end(2):])
                    now = judged(build, folder, target, changed, loops)
                    cells = [f"{a - b:+d}" if a != b else "" for a, b in zip(now, whole)]
                    print(f"| `{match[1]}` | {value:g} | " + " | ".join(cells) + " |",
                          flush=True)


if __name__ == "__main__":
    main()
