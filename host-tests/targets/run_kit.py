#!/usr/bin/env python3
"""The C interface on the emulated board.

    run_kit.py example BIN       the example finds the stick band of its loop, and its flash is
                                 what docs/firmware-kit.md says of it
    run_kit.py interrupted BIN   pushes from an interrupt neither lose nor tear a sample
"""
import pathlib
import re
import subprocess
import sys

import board
import budgets

TRUE_BAND = 4.0  # examples/cortex-m4f/plant.h
MOST_PUSH_INSTRUCTIONS = 100  # as stickband.h says
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/firmware-kit.md"
FLASH = re.compile(r"the example as linked, flash, bytes[^|]*\| ([\d,]+) \|")
SMALL_CHANGE = 1024  # bytes of flash, not worth a new figure


def start(image):
    board.skip_unless("qemu-system-arm", image)
    command = [*board.EMULATOR, *board.COUNTING, "-semihosting-config",
               "enable=on,target=native,chardev=sh", "-kernel", str(image)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)


def flash_is_told(image):
    told = int(FLASH.search(PAGE.read_text(encoding="utf-8"))[1].replace(",", ""))
    found = budgets.size_of_image(image)
    if abs(found - told) > SMALL_CHANGE:
        print(f"{PAGE.name}: expected the flash of the example, {found:,} bytes, found {told:,}; "
              "write it there")
    return abs(found - told) <= SMALL_CHANGE


def example(folder):
    emulator = start(folder / "example_cortex_m4f")
    try:
        for line in emulator.stdout:
            print(line, end="")
            found = re.search(r"stiction_raised, stick band ascending \S+ \((\S+) to (\S+)\), "
                              r"descending \S+ \((\S+) to (\S+)\)", line)
            if found:
                low, high, low_down, high_down = map(float, found.groups())
                held = low <= TRUE_BAND <= high and low_down <= TRUE_BAND <= high_down
                return flash_is_told(folder / "example_cortex_m4f") and held
        return False
    finally:
        emulator.kill()
        emulator.wait()


def interrupted(folder):
    emulator = start(folder / "interrupted")
    text = emulator.communicate()[0]
    print(text)
    figures = {name: float(value) for name, value in map(str.split, text.splitlines())}
    return (emulator.returncode == 0 and
            figures["taken"] + figures["queue_refused"] == figures["pushes"] and
            figures["samples_accepted"] == figures["taken"] > 0 and
            figures["samples_refused"] == 0 and
            figures["dearest_push_instructions"] <= MOST_PUSH_INSTRUCTIONS)


if __name__ == "__main__":
    checks = {"example": example, "interrupted": interrupted}
    if len(sys.argv) != 3 or sys.argv[1] not in checks:
        sys.exit(__doc__)
    sys.exit(0 if checks[sys.argv[1]](pathlib.Path(sys.argv[2])) else 1)
