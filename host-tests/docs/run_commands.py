#!/usr/bin/env python3
"""Runs the commands of the documentation, so that none of them is wrong.

    run_commands.py BIN SOURCE PAGE.md...

Each page gets a folder with nothing in it but `stickband`, the checkout SOURCE; its ```sh
blocks run there from top to bottom, with BIN first in PATH. A block that cannot run anywhere says why in the line above it:
<!-- not run: it needs a CAN bus -->. The first command that fails ends the test.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- not run: (?P<why>[^>]+?) -->\n+)?```sh\n(?P<text>.*?)^```",
                   re.MULTILINE | re.DOTALL)


def run(page, source, environment):
    """Number of blocks that ran; raises where a command fails."""
    ran = 0
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "stickband").symlink_to(source)
        for block in BLOCK.finditer(page.read_text(encoding="utf-8")):
            line = page.read_text(encoding="utf-8")[:block.start("text")].count("\n") + 1
            if block["why"]:
                print(f"{page.name}:{line}: not run, {block['why']}")
                continue
            done = subprocess.run(["sh", "-euc", block["text"]], cwd=folder, env=environment,
                                  stdin=subprocess.DEVNULL, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if done.returncode != 0:
                sys.exit(f"{page}:{line}: exit code {done.returncode}\n{block['text']}\n"
                         f"{done.stdout}")
            ran += 1
    return ran


def main():
    binaries, source, *pages = sys.argv[1:]
    environment = dict(os.environ)
    environment["PATH"] = f"{pathlib.Path(binaries).resolve()}:{environment['PATH']}"
    ran = 0
    for page in pages:
        ran += run(pathlib.Path(page).resolve(), pathlib.Path(source).resolve(), environment)
    print(f"{ran} blocks of {len(pages)} pages ran")
    if ran == 0:
        sys.exit("no block was run; expected ```sh blocks in these pages")


if __name__ == "__main__":
    main()
