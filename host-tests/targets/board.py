"""The emulated board: how a recording gets onto it and its figures back."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import pack_recording

EMULATOR = ["qemu-system-arm", "-M", "mps2-an386", "-display", "none", "-monitor", "none",
            "-serial", "none", "-chardev", "stdio,id=sh,signal=off"]
COUNTING = ["-icount", "shift=6,sleep=off"]  # as in toolchains/cortex-m4f.cmake
SKIPPED = 77


def skip_unless(program, *files):
    """Ends this test as skipped, and says why, where a tool or an image is not there."""
    if shutil.which(program) is None:
        print(f"SKIPPED: no program {program}; toolchains/README.md lists the packages")
        sys.exit(SKIPPED)
    for file in files:
        if not pathlib.Path(file).is_file():
            print(f"SKIPPED: no file {file}; the build of this target was skipped or failed")
            sys.exit(SKIPPED)


def recording(stickband, scenario, seed, folder):
    """Path of a packed simulated recording."""
    csv = pathlib.Path(folder) / f"{scenario}-{seed}.csv"
    packed = csv.with_suffix(".rec")
    subprocess.run([stickband, "simulate", scenario, "--seed", str(seed), "-o", str(csv)],
                   check=True, capture_output=True)
    if pack_recording.main([str(csv), str(packed)]) != 0:
        raise RuntimeError(f"cannot pack {csv}")
    return packed


def figures(text):
    """Lines `name value` as a dictionary; lines `calls NAME …` under calls.NAME."""
    out = {}
    for line in text.splitlines():
        words = line.split()
        if words[0] == "calls":
            out[f"calls.{words[1]}"] = dict(
                zip(("calls", "instructions", "most", "stack_bytes"), map(int, words[2:])))
        else:
            out[words[0]] = words[1]
    return out


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: status {done.returncode}\n"
                           f"{done.stdout}{done.stderr}")
    return figures(done.stdout)


def on_board(image, mode, life, budget, packed):
    """Runs an image; with mode `count` its instructions are counted."""
    words = ["image", mode, life, str(budget), str(packed)]
    arguments = "".join(f",arg={word}" for word in words)
    counting = COUNTING if mode == "count" else []
    return run([*EMULATOR, *counting, "-semihosting-config",
                f"enable=on,target=native,chardev=sh{arguments}", "-kernel", str(image)])


def on_host(program, precision, life, budget, packed):
    return run([str(program), precision, life, str(budget), str(packed)])


def folder():
    return tempfile.TemporaryDirectory()
