#!/usr/bin/env python3
"""Gate on archives and objects: none may need the heap, exceptions, text output or a clock.

    check_symbols.py NM FILE...

NM is the nm of the compiler that built the files. Prints `file(member): symbol, why` for each
undefined symbol that is forbidden and exits 1 when there is any.
"""
import pathlib
import re
import subprocess
import sys

FORBIDDEN = [
    (r"(?:__libc_|_)?(?:malloc|calloc|realloc|free)(?:_r)?|aligned_alloc|posix_memalign|_?sbrk(?:_r)?",
     "heap"),
    (r"_Zn[wa]\w*|_Zd[la]\w*", "operator new or delete"),
    (r"__cxa_(?:throw|rethrow|allocate_exception|begin_catch|end_catch|bad_\w+|throw_\w+)"
     r"|_ZSt\d+__throw_\w*|_Unwind_\w+|__gxx_personality_v0", "exceptions"),
    (r"__cxa_guard_\w+", "local static with a lock"),
    (r"__cxa_atexit|atexit", "static destructor"),
    (r"__dynamic_cast|_ZTVN10__cxxabiv\w*|_ZTI\w*", "run-time types"),
    (r"\w*printf\w*|\w*scanf\w*|puts|putchar|fwrite|fputs|fopen|_ZNSo\w*|_ZSt4c(?:out|err|in)"
     r"|_ZNSt8ios_base\w*", "text input or output"),
    (r"clock\w*|time|gettimeofday|nanosleep|_ZNSt6chrono\w*", "clock"),
    (r"__assert_\w+|abort|exit|_ZSt9terminatev", "abort"),
    (r"pthread_\w+", "threads"),
]
PATTERNS = [(re.compile(rf"(?:{pattern})\Z"), why) for pattern, why in FORBIDDEN]


def undefined(nm, path):
    """(member, symbol) pairs that the file leaves to others."""
    run = subprocess.run([nm, "-u", "-A", str(path)], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip())
    for line in run.stdout.splitlines():
        match = re.match(r"(.*):\s+[UwWv]\s+(\S+)$", line)
        if match:
            yield match.group(1), match.group(2).split("@")[0]


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    nm, names = arguments[0], arguments[1:]
    offences = []
    for name in names:
        if not pathlib.Path(name).is_file():
            print(f"{name}: expected an archive or object, found no file", file=sys.stderr)
            return 2
        for member, symbol in undefined(nm, name):
            why = next((why for pattern, why in PATTERNS if pattern.match(symbol)), None)
            if why:
                offences.append(f"{member}: {symbol}, {why}")
    print("\n".join(offences) if offences else "clean")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
