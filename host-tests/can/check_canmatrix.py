#!/usr/bin/env python3
"""Holds our DBC reader against canmatrix on random layouts, and canmatrix against our DBC.

    check_canmatrix.py READ_SIGNALS STICKBAND_DBC [FRAMES]

Signals are placed at random without overlap, in both byte orders, signed, unsigned, float
and multiplexed; canmatrix writes the DBC and decodes random data, so does READ_SIGNALS.
Exits 77 where canmatrix is not installed.
"""
import contextlib
import io
import math
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        import canmatrix
        import canmatrix.formats
except ImportError:
    print("skipped: needs the Debian package python3-canmatrix")
    sys.exit(77)

FACTORS = ["1", "0.01", "0.5", "-0.25", "2", "1E-3", "12.5"]
OFFSETS = ["0", "-40", "100.5", "0.001"]


def positions(start, size, little, room):
    """Bits of a signal in DBC numbering, least significant first for Intel; None: outside."""
    bits, at = [], start
    for _ in range(size):
        if not 0 <= at < room:
            return None
        bits.append(at)
        at = at + 1 if little else (at - 1 if at % 8 else at + 15)
    return bits


def place(random_, taken, size, little, room):
    """A start bit at which the signal fits between the others, or None."""
    for _ in range(60):
        start = random_.randrange(room)
        bits = positions(start, size, little, room)
        if bits and not taken & set(bits):
            taken |= set(bits)
            return start
    return None


def signal_at(random_, name, start, size, little, is_float=False, **more):
    signal = canmatrix.Signal(
        name, size=size, is_little_endian=little, is_float=is_float,
        is_signed=is_float or random_.random() < 0.5,
        factor=random_.choice(FACTORS), offset=random_.choice(OFFSETS), **more)
    signal.set_startbit(start, bitNumbering=1)
    return signal


def random_frame(random_, number):
    extended = random_.random() < 0.5
    size = random_.choice([8, 8, 12, 20, 64])  # beyond 8: CAN FD
    identifier = number + 1 if not extended else 0x18000000 + number
    frame = canmatrix.Frame(
        f"Frame{number}", size=size, is_fd=size > 8,
        arbitration_id=canmatrix.ArbitrationId(identifier, extended=extended))
    taken = set()
    multiplexed = random_.random() < 0.3
    if multiplexed:
        little = random_.random() < 0.5
        selector = canmatrix.Signal("Selector", size=2, is_little_endian=little,
                                    is_signed=False, multiplex="Multiplexor")
        selector.set_startbit(place(random_, taken, 2, little, 8 * size), bitNumbering=1)
        frame.add_signal(selector)
    for i in range(random_.randint(1, 8)):
        little = random_.random() < 0.5
        is_float = random_.random() < 0.15
        bits = random_.choice([32, 64]) if is_float else random_.choice(
            [1, 2, 3, 7, 8, 9, 12, 13, 16, 17, 24, 31, 32, 33, 48, random_.randint(1, 64)])
        start = place(random_, taken, bits, little, 8 * size)
        if start is None:
            continue
        more = {"multiplex": random_.randrange(4)} if multiplexed and i % 2 else {}
        frame.add_signal(signal_at(random_, f"S{i}", start, bits, little, is_float, **more))
    return frame


def ask(reader, dbc, questions):
    answers = subprocess.run([reader, str(dbc)], input="\n".join(questions) + "\n",
                             capture_output=True, text=True)
    if answers.returncode != 0:
        sys.exit(f"read_signals: {answers.stderr}")
    return answers.stdout.splitlines()


def same(ours, theirs):
    if not math.isfinite(theirs):
        return ours == "refused"
    try:
        return math.isclose(float(ours), theirs, rel_tol=1e-12, abs_tol=1e-12)
    except ValueError:
        return False


def check_random_layouts(reader, frames):
    random_ = random.Random(1)
    matrix = canmatrix.CanMatrix()
    for number in range(frames):
        matrix.add_frame(random_frame(random_, number))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "random.dbc"
        canmatrix.formats.dumpp({"": matrix}, str(path))
        questions, expected = [], []
        for frame in matrix.frames:
            for _ in range(4):
                data = bytes(random_.randrange(256) for _ in range(frame.size))
                decoded = frame.decode(bytearray(data))
                for signal in frame.signals:
                    questions.append(f"{frame.name}.{signal.name} {data.hex()}")
                    value = decoded.get(signal.name)
                    expected.append(None if value is None else float(value.phys_value))
        answers = ask(reader, path, questions)
    wrong = [(q, a, e) for q, a, e in zip(questions, answers, expected)
             if (a != "not selected" if e is None else not same(a, e))]
    if wrong or len(answers) != len(questions):
        sys.exit(f"{len(wrong)} of {len(questions)} differ, the first: {wrong[:3]}")
    left_out = sum(e is None for e in expected)
    print(f"{len(questions)} values of {frames} random frames agree, {left_out} not selected")


def check_own_dbc(path):
    """The golden frame of host-tests/unit/wire/test_diagnostics.cpp, decoded by canmatrix."""
    matrix = canmatrix.formats.loadp_flat(str(path))
    frame = matrix.frame_by_name("StickbandLoop1")
    assert frame.arbitration_id.id == 0x191, frame.arbitration_id
    decoded = frame.decode(bytearray.fromhex("0404C30001F501F2"))
    found = {name: float(value.phys_value) for name, value in decoded.items()}
    expected = {"verdict": 4, "ne107": 4, "confidence_pct": 97.5, "input_status": 0,
                "stick_band_ascending_pct": 5.01, "stick_band_descending_pct": 4.98}
    if found.keys() != expected.keys() or any(
            not math.isclose(found[k], expected[k]) for k in expected):
        sys.exit(f"{path}: expected {expected}, canmatrix found {found}")
    if decoded["verdict"].named_value != "stiction" or len(matrix.frames) != 93:
        sys.exit(f"{path}: expected 93 frames, verdicts named")
    print("canmatrix reads our own DBC")


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    check_random_layouts(arguments[0], int(arguments[2]) if len(arguments) == 3 else 400)
    check_own_dbc(arguments[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
