#!/usr/bin/env python3
"""Gate on a bare-metal archive: what it takes from elsewhere, and where it uses double.

    check_device_archive.py TOOLS ARCHIVE...     TOOLS: prefix, e.g. arm-none-eabi-

A symbol that the archive leaves to others must be one of memcpy and its kin, of libm, or a
helper of the processor's ABI; of libm in float an exact function, for expf and its kin differ
in the last bit between libraries: lib/ident/base/elementary.hpp. Code that is not an instance for
double may not compute in double, which is emulated there and 20 times as slow, but for the
functions in DOUBLE.
"""
import re
import subprocess
import sys

MEMORY = {"memcpy", "memmove", "memset", "memcmp", "memchr", "strlen"}
LIBM = {"acos", "asin", "atan", "atan2", "cbrt", "ceil", "cos", "exp", "exp2", "expm1", "fabs",
        "floor", "fmod", "frexp", "hypot", "ldexp", "log", "log10", "log1p", "log2", "lround",
        "llround", "nearbyint", "pow", "rint", "round", "sin", "sqrt", "tan", "tanh", "trunc"}
EXACT = {"ceilf", "fabsf", "floorf", "fmodf", "frexpf", "ldexpf", "lroundf", "llroundf",
         "nearbyintf", "rintf", "roundf", "sqrtf", "truncf"}
ABI = re.compile(r"__aeabi_\w+\Z")
OURS = re.compile(r"_Z\w*(?:5ident|4wire)\w*\Z")

DOUBLE_ABI = re.compile(r"__aeabi_(?:d\w+|cd\w+|f2d|u?[il]2d)\Z")
# Function without its parameters -> why it computes in double.
DOUBLE = {
    "ident::judge<float>": "once in an identification: one set of thresholds, not rounded, "
                           "decides in both precisions",
    "better_in_most_cycles<float>": "the same",
    "confirmation<float>": "the same",
    "nothing_found<float>": "the same",
    "qualified<float>": "the same",
    "steadily_better<float>": "the same",
    "ident::cause_of<float>": "the same",
    "ident::setpoint_moves<float>": "the same",
    "ident::fitted_valve_sticks<float>": "the same",
    "SensorHoldSearch::bend": "a record is checked on a desk, in double alone",
    "ident::was_compressed": "the same",
    "::Depths": "the same",
}
# Whole namespaces: CAN signals and decimal numbers are double by definition of their formats.
DOUBLE_NAMESPACES = ("wire::",)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def references(tools, archive):
    """Symbols that each section needs, with a function's section under the function's name."""
    out, section = {}, None
    for line in run(f"{tools}objdump", "-r", archive).splitlines():
        match = re.match(r"RELOCATION RECORDS FOR \[(\S+)\]:", line)
        if match:
            section = function_of(match.group(1))
            continue
        match = re.match(r"[0-9a-f]+\s+R_\w+\s+(\S+?)(?:[+-]0x[0-9a-f]+)?\s*$", line)
        if match:
            out.setdefault(section, set()).add(function_of(match.group(1)))
    return out


def function_of(section):
    match = re.match(r"\.text\.(?:unlikely\.|hot\.|startup\.)?(\S+)\Z", section)
    return match.group(1) if match else section


def reached(needs):
    """The functions that are ours, and what they call in turn; a copy of a library's inline
    function that nobody calls is left out by the linker."""
    found = {name for name in needs
             if OURS.match(name) or re.match(r"\.(?:rodata|data|init_array)", name)}
    todo = list(found)
    while todo:
        for name in needs[todo.pop()] & needs.keys() - found:
            found.add(name)
            todo.append(name)
    return found


def defined_in(tools, archive):
    """Also of an archive that is prepared for link-time optimisation, of whose code nm shows
    what others may use alone."""
    lines = (re.match(r"[0-9a-f]{8,16} .{7} (\S+)\t[0-9a-f]+ (?:\.hidden )?(\S+)\s*$", line)
             for line in run(f"{tools}objdump", "-t", archive).splitlines())
    return {line.group(2) for line in lines if line and line.group(1) != "*UND*"}


def foreign_symbols(tools, archive):
    """Each symbol that the archive may not leave to others, once."""
    needs = references(tools, archive)
    used = set().union(*(needs[name] for name in reached(needs)))
    for symbol in sorted(used - defined_in(tools, archive)):
        libm = symbol in LIBM or symbol in EXACT
        section = symbol.startswith(".")  # of the same object
        if not (libm or section or symbol in MEMORY or ABI.match(symbol) or OURS.match(symbol)):
            yield symbol


def uses_of_double(tools, archive):
    """(function, symbol) for each call that computes in double."""
    needs = references(tools, archive)
    for name in reached(needs):
        for symbol in needs[name]:
            if DOUBLE_ABI.match(symbol) or symbol in LIBM:
                yield name, symbol


def plain(tools, mangled):
    return run(f"{tools}c++filt", mangled).strip()


def is_for_double(name):
    return bool(re.search(r"<double|, double|\(double|span<(?:const )?double", name))


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    tools, archives = arguments[0], arguments[1:]
    offences, excepted = [], set()
    for archive in archives:
        offences += [f"{archive}: {symbol}, neither a memory function nor of libm, exact in float"
                     for symbol in foreign_symbols(tools, archive)]
        names = {}
        for mangled, symbol in uses_of_double(tools, archive):
            name = names.setdefault(mangled, plain(tools, mangled))
            if is_for_double(name) or name.startswith(DOUBLE_NAMESPACES):
                continue
            known = next((known for known in DOUBLE if known in name), None)
            if known:
                excepted.add(known)
            else:
                offences.append(f"{archive}: {name}: {symbol}, double in float code")
    for name in sorted(set(DOUBLE) - excepted):
        if any("ident" in archive for archive in archives):
            offences.append(f"{name}: an exception that nothing needs any more")
    print("\n".join(sorted(set(offences))) if offences else "clean")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
