#!/usr/bin/env python3
"""Gate on the source tree: include directions, forbidden words, file lengths, columns, unit
tests, numbered equations, names of types.

    check_sources.py ROOT [includes|words|lengths|columns|tests|equations|types]...

Prints one line for each offence, `file:line: what was found, what is allowed`, and exits 1
when there is any but warnings (long files); without a list every check runs. Reads C++ sources as text: comments and
string literals are taken out before words are looked for.
"""
import pathlib
import re
import subprocess
import sys

SOURCES = {".cpp", ".hpp", ".h", ".c", ".cc"}
TEXTS = SOURCES | {".py", ".sh", ".cmake", ".js", ".css", ".html", ".S", ".ld", ".toml"}

# Folder -> the folders whose headers it may include, besides third parties.
DIRECTIONS = {
    "lib/ident": {"ident"},
    "lib/wire": {"wire", "ident"},
    "lib/c": {"c", "wire", "ident"},
    "lib/config": {"config", "wire", "ident"},
    "hal": {"hal", "wire"},
    "firmware": {"firmware", "config", "hal", "wire", "ident"},
    "workbench/cli": {"workbench", "config", "hal", "wire", "ident"},
    "workbench": {"workbench", "config", "wire", "ident"},
    "python": {"python", "workbench", "config", "ident"},
}
# Folder of headers -> its rooms -> the rooms whose headers they may include, besides their
# own; "": what stands in no room, the public face, which may include all.
ROOMS = {
    "ident": {
        "base": set(),
        "signal": {"base"},
        "process": {"base", "signal"},
        "evidence": {"base", "signal", "process", "valve"},
        "two_path": {"base", "signal", "process"},
        "valve": {"base", "signal", "process"},
        "gap": {"base", "signal", "process"},
        "verdict": {"base", "signal", "process", "evidence", "two_path", "valve", "gap"},
    },
    "workbench/model": {
        "base": set(),
        "fit": {"base"},
        "judge": {"base", "fit"},
        "search": {"base", "fit", "judge"},
        "tell": {"base", "fit", "judge", "search"},
    },
    "workbench/recording": {
        "spelling": {""},
        "times": {"", "spelling"},
        "columns": {"", "spelling", "times"},
        "rows": {"", "spelling", "times", "columns"},
        "can": {"", "rows"},
        "formats": {"", "spelling"},
    },
}
OURS = {"ident", "wire", "c", "config", "hal", "firmware", "workbench", "python"}
# On the device only these third parties; the standard library has no slash and no suffix.
DEVICE = {"lib/ident": {"Eigen"}, "lib/wire": set()}

FORBIDDEN_HEADERS = {
    "iostream", "ostream", "istream", "sstream", "fstream", "iomanip", "vector", "string",
    "deque", "list", "map", "set", "unordered_map", "unordered_set", "memory", "functional",
    "chrono", "ctime", "thread", "mutex", "condition_variable", "future", "atomic", "random",
    "regex", "locale", "filesystem", "exception", "stdexcept", "typeinfo", "any", "cstdio",
}
FORBIDDEN_WORDS = [
    (r"\bnew\b", "new"),
    (r"(?<!=)(?<!= )\bdelete\b", "delete"),
    (r"\b(?:m|c|re)alloc\s*\(", "malloc"),
    (r"\bfree\s*\(", "free"),
    (r"\bthrow\b", "throw"),
    (r"\b(?:try|catch)\b", "try/catch"),
    (r"\b\w*printf\s*\(", "printf"),
    (r"\bstd::(?:function|string|vector|map|unique_ptr|shared_ptr|cout|cerr)\b", "std heap type"),
    (r"\bdynamic_cast\b", "dynamic_cast"),
    (r"\btypeid\b", "typeid"),
]

UNIT = pathlib.PurePath("host-tests/unit")
MIRRORED = [pathlib.PurePath(top) for top in ("lib", ".", "host-tests")]

EQUATIONS = pathlib.PurePath("docs/model.md")
COMPUTES = ["lib/ident", "workbench"]

WARNING = "warning: "
SHIPS = ["lib", "hal", "firmware", "workbench"]
MOST_SHIPPED_LINES = 400
MOST_FUNCTION_LINES = 60
# Where the name of a type is not used twice.
ONE_TYPE = ("lib", "hal", "firmware", "workbench")
MOST_LINES = 500
MOST_COLUMNS = 90  # ColumnLimit of .clang-format
MOST_MAIN_LINES = 99


def without_comments(text):
    """Blanks comments and literals; line breaks stay, so that line numbers hold."""
    token = re.compile(
        r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])*'""",
        re.DOTALL)
    return token.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def files(root, suffixes):
    """Tracked files and new ones that are not ignored; every file outside a repository."""
    try:
        listed = subprocess.run(
            ["git", "-C", str(root), "ls-files", "-co", "--exclude-standard", "-z"],
            capture_output=True, check=True).stdout.decode().split("\0")
        top = subprocess.run(["git", "-C", str(root), "rev-parse", "--show-toplevel"],
                             capture_output=True, check=True).stdout.decode().strip()
        if pathlib.Path(top).resolve() != root.resolve():
            raise FileNotFoundError
        paths = [root / name for name in listed if name]
    except (subprocess.CalledProcessError, FileNotFoundError):
        paths = [p for p in root.rglob("*") if "build" not in p.relative_to(root).parts]
    return sorted(p for p in paths if p.suffix in suffixes and p.is_file())


def folder_of(path, folders):
    return next((f for f in folders if path.as_posix().startswith(f + "/")), None)


def room_of(header, house):
    """Room of a header, the empty text for the public face; nothing outside the house."""
    if not header.startswith(house + "/"):
        return None
    inside = header[len(house) + 1:].split("/")
    return inside[0] if len(inside) > 1 else ""


def room_offence(name, header):
    """What a file of a room may not include, or nothing."""
    path = name.as_posix().removeprefix("lib/")
    for house, rooms in ROOMS.items():
        room, target = room_of(path, house), room_of(header, house)
        if not room or target is None:
            continue
        if room not in rooms:
            return f"is in no room of {', '.join(rooms)}"
        if target != room and target not in rooms[room]:
            allowed = ", ".join(sorted(rooms[room] - {""}))
            return f"includes {header}; {house}/{room} may include {allowed or 'no other room'}"
    return None


def check_includes(root):
    for path in files(root, SOURCES):
        name = path.relative_to(root)
        folder = folder_of(name, DIRECTIONS)
        if folder is None:
            continue
        allowed = DIRECTIONS[folder]
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*(["<])([^">]+)[">]', line)
            if not match:
                continue
            quoted, header = match.group(1) == '"', match.group(2)
            first = header.split("/")[0]
            where = f"{name}:{number}: includes {header}"
            offence = room_offence(name, header)
            if offence:
                yield f"{name}:{number}: {offence}"
            if first in OURS and "/" in header:
                if first not in allowed:
                    yield f"{where}; {folder} may include {', '.join(sorted(allowed))}"
            elif header.startswith(".") or "/../" in header:
                yield f"{where}; write the path from the root of the headers"
            elif folder in DEVICE:
                standard = "/" not in header and "." not in header and not quoted
                if not standard and first not in DEVICE[folder]:
                    third = ", ".join(sorted(DEVICE[folder] | {"the standard library"}))
                    yield f"{where}; {folder} may include {third}"


def check_words(root):
    for path in files(root, SOURCES):
        name = path.relative_to(root)
        if folder_of(name, DEVICE) is None:
            continue
        text = path.read_text(errors="replace")
        for number, line in enumerate(text.splitlines(), 1):
            match = re.match(r"\s*#\s*include\s*<([^>]+)>", line)
            if match and match.group(1) in FORBIDDEN_HEADERS:
                yield f"{name}:{number}: includes <{match.group(1)}>; not on the device"
        for number, line in enumerate(without_comments(text).splitlines(), 1):
            if re.match(r"\s*#\s*include", line):
                continue
            for pattern, word in FORBIDDEN_WORDS:
                if re.search(pattern, line):
                    yield f"{name}:{number}: {word}; not on the device"


def functions(text):
    """(head, first line, lines) of every function, told from types, namespaces and
    initialisers by what stands before its brace; lambdas and local types count to theirs."""
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: "\n" * m.group().count("\n"),
                  without_comments(text), flags=re.M)
    head, first, number, outside = "", 1, 1, []
    for c in text:
        number += c == "\n"
        if c == "{":
            words = re.sub(r"^template\s*<[^{]*?>\s*(?=\w)", "", " ".join(head.split()))
            is_type = re.match(r"(?:enum|class|struct|union|namespace|extern)\b", words)
            bare, parts = re.sub(r"operator\s*[=!<>]+", "operator", words), 1
            while parts:
                bare, parts = re.subn(r"\([^()]*\)", "", bare)
            is_function = "(" in words and not is_type and "=" not in bare
            outside.append((words, first if words else number, is_function))
            head = ""
        elif c == "}" and outside:
            words, began, is_function = outside.pop()
            if is_function and not any(other[2] for other in outside):
                yield words, began, number - began + 1
            head = ""
        elif c == ";" and head.count("(") == head.count(")"):
            head = ""
        else:
            if not head.strip() and not c.isspace():
                first = number
            head += c


def long_functions(path, name):
    for head, first, lines in functions(path.read_text(errors="replace")):
        if lines > MOST_FUNCTION_LINES:
            title = (re.findall(r"([\w:~<>, ]+)\(", head) or [head])[0].split()[-1]
            yield (f"{name}:{first}: {title}() has {lines} lines; what ships has at most "
                   f"{MOST_FUNCTION_LINES}")


def check_lengths(root):
    for path in files(root, TEXTS):
        name = path.relative_to(root)
        lines = len(path.read_text(errors="replace").splitlines())
        if path.name == "main.cpp" and lines > MOST_MAIN_LINES:
            yield f"{name}:{lines}: {lines} lines; a main.cpp has fewer than 100"
        elif path.suffix in SOURCES and folder_of(name, SHIPS):
            if lines > MOST_SHIPPED_LINES:
                yield (f"{name}:{lines}: {lines} lines; what ships has at most "
                       f"{MOST_SHIPPED_LINES}")
            yield from long_functions(path, name)
        elif lines > MOST_LINES:
            yield f"{WARNING}{name}: {lines} lines; a source file has at most {MOST_LINES}"


def check_columns(root):
    """Code that `./dev fmt` would break; comments and literals are as long as they are."""
    for path in files(root, SOURCES):
        text = re.sub(r'R"(\w*)\(.*?\)\1"', lambda m: "\n" * m.group().count("\n") + '""',
                      path.read_text(errors="replace"), flags=re.S)
        bare = without_comments(text).splitlines()
        for number, (line, code) in enumerate(zip(text.splitlines(), bare), 1):
            if len(code.rstrip()) > MOST_COLUMNS and '"' not in line:
                yield (f"{path.relative_to(root)}:{number}: {len(code.rstrip())} columns; a line "
                       f"has at most {MOST_COLUMNS}: run ./dev fmt")


def check_tests(root):
    """Unit tests stand as their headers do: unit/wire/test_isotp.cpp for lib/wire/isotp.hpp.
    What would be too long for one file has more words behind the name of the header."""
    for path in files(root, SOURCES):
        name = path.relative_to(root)
        if not name.is_relative_to(UNIT):
            continue
        room = name.relative_to(UNIT).parent
        folder = next((top / room for top in MIRRORED if (root / top / room).is_dir()), None)
        if folder is None:
            yield f"{name}: no source folder {room}; unit tests stand as their headers do"
            continue
        headers = [h.stem for h in (root / folder).iterdir() if h.suffix in {".h", ".hpp"}]
        words = name.stem.removeprefix("test_") + "_"
        if not name.name.startswith("test_") or name.suffix != ".cpp":
            yield f"{name}: no test_*.cpp; what tests share stands in host-tests/support"
        elif not any(words.startswith(header + "_") for header in headers):
            yield f"{name}: no header of {folder} begins its name after test_"


def cited(comment):
    """Numbers of the equations that a comment cites: (E1), (E1) – (E3), equation (8)."""
    letter = r"\(([A-Z])(\d{1,2})\)"
    for match in re.finditer(letter + r" – \(\1(\d{1,2})\)|" + letter, comment):
        first, last = match.group(2) or match.group(5), match.group(3) or match.group(5)
        for number in range(int(first), int(last or first) + 1):
            yield (match.group(1) or match.group(4)) + str(number)
    yield from re.findall(r"[Ee]quations? \((\d+)\)", comment)


def check_equations(root):
    """Each equation of docs/model.md is cited where it is computed, and each that a comment
    cites is there."""
    page = root / EQUATIONS
    numbers = set(re.findall(r"^(?:\| |- \*\*)\(([A-Z]?\d+)\)", page.read_text(), re.M))
    computed = set()
    for path in files(root, SOURCES):
        name = path.relative_to(root)
        lines = path.read_text(errors="replace").splitlines()
        for number, line in enumerate(lines, 1):
            comment = line.partition("//")[2]
            if comment and number < len(lines):  # a word and its number on two lines
                comment += lines[number].partition("//")[2].replace("/", "", 1)
            for equation in cited(comment):
                if equation in numbers:
                    computed |= {equation} if folder_of(name, COMPUTES) else set()
                elif equation in cited(line):
                    yield f"{name}:{number}: cites ({equation}), which is not in {EQUATIONS}"
    for equation in sorted(numbers - computed):
        yield f"{EQUATIONS}: ({equation}) is cited nowhere in {', '.join(COMPUTES)}"


def types_of(text):
    """(full name, line) of each type defined at namespace level, unnamed namespaces aside."""
    names = []
    for line, one in enumerate(text.splitlines(), 1):
        if opened := re.match(r"(?:inline )?namespace ?([\w:]*) ?{", one):
            names.append(opened[1])
        elif re.match(r"}\s*// namespace", one) and names:
            names.pop()
        elif all(names) and (found := re.match(
                r"(?:template <.*> )?(?:struct|class|enum class|enum|union) (\w+)"
                r"(?= ?(?:final )?(?:: |{|$))", one)):
            yield "::".join([*names, found[1]]), line


def check_types(root):
    """A name of a type means one type: of two, in files that never meet, a linker keeps the
    functions of either for both."""
    first = {}
    for path in files(root, SOURCES):
        name = path.relative_to(root)
        if name.parts[0] not in ONE_TYPE:
            continue
        for kind, line in types_of(path.read_text(errors="replace")):
            place = f"{name}:{line}"
            if first.setdefault(kind, place) != place:
                yield f"{place}: a second {kind}; the first is in {first[kind]}"


CHECKS = {"includes": check_includes, "words": check_words, "lengths": check_lengths,
          "columns": check_columns,
          "tests": check_tests, "equations": check_equations, "types": check_types}


def main(arguments):
    if not arguments or any(name not in CHECKS for name in arguments[1:]):
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[0])
    if not root.is_dir():
        print(f"{root}: expected the root of the source tree, found no folder", file=sys.stderr)
        return 2
    offences = [o for name in arguments[1:] or CHECKS for o in CHECKS[name](root)]
    print("\n".join(offences) if offences else "clean")
    return 1 if any(not o.startswith(WARNING) for o in offences) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
