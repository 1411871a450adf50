"""Mutation points of C++ sources: found with libclang, switched at run time.

points_of(root, files, arguments) parses the files and gives their points; instrument()
writes a source in which each point asks mutant.hpp whether it is on. Points stand only in
the bodies of functions, and never where the compiler itself evaluates: constexpr variables,
template arguments, case labels, static_assert, preprocessor lines and macros.
"""
import bisect
import dataclasses
import re
import sys

sys.path.append("/usr/lib/python3/dist-packages")  # Debian's, whatever python3 runs
try:
    from clang.cindex import Index, LibclangError, TypeKind
except ImportError:
    sys.exit("clang.cindex is missing: apt-get install python3-clang")

# Operator -> its helper in mutant.hpp, what it becomes between whole numbers, else.
OPERATORS = {
    "<": ("Less", "<=", ">="), "<=": ("LessEqual", "<", ">"),
    ">": ("Greater", ">=", "<="), ">=": ("GreaterEqual", ">", "<"),
    "==": ("Equal", "!=", "!="), "!=": ("NotEqual", "==", "=="),
    "+": ("Plus", "-", "-"), "-": ("Minus", "+", "+"),
    "*": ("Times", "/", "/"), "/": ("Over", "*", "*"),
    "<<": ("Left", ">>", None), ">>": ("Right", "<<", None),
    "&": ("BitAnd", "|", None), "|": ("BitOr", "&", None),
}
RELATIONS = {"<", "<=", ">", ">=", "==", "!="}
LITERALS = {"INTEGER_LITERAL", "FLOATING_LITERAL", "CHARACTER_LITERAL", "CXX_BOOL_LITERAL_EXPR"}
FUNCTIONS = {"FUNCTION_DECL", "CXX_METHOD", "CONSTRUCTOR", "DESTRUCTOR", "FUNCTION_TEMPLATE",
             "CONVERSION_FUNCTION"}
OUTSIDE = {"NAMESPACE", "CLASS_DECL", "STRUCT_DECL", "CLASS_TEMPLATE", "LINKAGE_SPEC",
           "CLASS_TEMPLATE_PARTIAL_SPECIALIZATION", "UNEXPOSED_DECL"}
CONSTANT = {"STATIC_ASSERT", "CXX_UNARY_EXPR", "PARM_DECL", "TYPE_REF", "TEMPLATE_REF",
            "TYPE_ALIAS_DECL", "TYPEDEF_DECL", "ENUM_DECL", "STRUCT_DECL", "CLASS_DECL"}
NUMBERS = {"INT", "REAL"}


@dataclasses.dataclass
class Point:
    """One place and one change; `edits` are (offset, order, text to put in, bytes to take)."""
    file: str
    line: int
    column: int
    offset: int
    change: str
    kind: str
    sure: bool  # else it counts only where a test reaches it: what looks like a product of
    # numbers may be one of matrices, and a number may be used by the compiler alone
    edits: list
    id: int = 0

    @property
    def name(self):
        return f"{self.file}:{self.line}:{self.column}: {self.change}"


def family(type_):
    """INT, REAL, OTHER, or "" where only an instantiation knows."""
    kind = type_.get_canonical().kind
    if kind == TypeKind.BOOL:
        return "BOOL"
    if TypeKind.CHAR_U.value <= kind.value <= TypeKind.INT128.value or kind == TypeKind.ENUM:
        return "INT"
    if kind in (TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE):
        return "REAL"
    spelling = type_.get_canonical().spelling.replace("const ", "")
    if re.fullmatch(r"type-parameter-\d+-\d+", spelling):
        return "REAL"
    return "" if "dependent" in spelling or kind == TypeKind.UNEXPOSED else "OTHER"


class Finder:
    """Walks the tree of one file."""

    def __init__(self, name, text):
        self.name, self.text, self.points = name, text, []
        self.lines = [m.end() for m in re.finditer(rb"\n", text)]
        self.closed = self.template_arguments(text)
        self.uncounted = False  # in a constexpr function
        self.bounds = set()  # whole numbers compared with: the comparison has its own point

    @staticmethod
    def template_arguments(text):
        """Extents of <...> behind a name that cannot be a comparison."""
        found = []
        pattern = re.compile(rb"\b(?:static_cast|template\s+\w+|numeric_limits|array|span|get|"
                             rb"Matrix|Map|optional|bit_cast|[A-Z]\w+|\w+_v|pow|rows|cols|head|"
                             rb"tail|segment|block|topRows|leftCols)<")
        for match in pattern.finditer(text):
            depth, at = 1, match.end()
            while depth and at < len(text) and text[at:at + 1] not in (b";", b"{"):
                depth += {b"<": 1, b">": -1}.get(text[at:at + 1], 0)
                at += 1
            if not depth:
                found.append((match.end() - 1, at))
        return found

    def between(self, first, last):
        blank = re.sub(rb"//[^\n]*|/\*.*?\*/", b"", self.text[first:last], flags=re.S)
        return blank.strip().decode()

    def words(self, first, last, most=48):
        words = " ".join(self.text[first:last].decode().split())
        return words if len(words) <= most else words[:most - 1] + "…"

    def is_open(self, first, last):
        return not any(first < end and begin < last for begin, end in self.closed)

    def add(self, kind, first, last, change, edits, sure=True, at=None):
        """`at`: the place that names it, where that is not the first."""
        if first < last and self.is_open(first, min(last, first + 1)):
            at = first if at is None else at
            line = bisect.bisect_right(self.lines, at)
            column = at - (self.lines[line - 1] if line else 0) + 1
            self.points.append(Point(self.name, line + 1, column, first, change, kind,
                                     sure and not self.uncounted, edits))

    def wrap(self, kind, first, last, rank, opening, change, closing=")", sure=True):
        self.add(kind, first, last, change,
                 [(first, (1, -last, rank), opening, 0), (last, (0, -first, -rank), closing, 0)],
                 sure)

    def declaration(self, cursor):
        if cursor.kind.name in FUNCTIONS:
            self.function(cursor)
        elif cursor.kind.name in OUTSIDE:
            for child in cursor.get_children():
                self.declaration(child)

    def function(self, cursor):
        first = cursor.extent.start.offset
        head = self.text[first:cursor.location.offset]
        if b"consteval" in head or not cursor.is_definition():
            return
        self.uncounted = b"constexpr" in head
        children = list(cursor.get_children())
        for before, child in zip([None] + children, children):
            is_initializer = before is not None and before.kind.name == "MEMBER_REF"
            if child.kind.name == "COMPOUND_STMT":
                self.statement(child)
            elif is_initializer and child.kind.is_expression():
                self.expression(child)
        self.uncounted = False

    def statement(self, cursor):
        """A statement, or an expression that stands as one."""
        kind, children = cursor.kind.name, list(cursor.get_children())
        if kind == "COMPOUND_STMT":
            for child in children:
                self.statement(child)
        elif kind in ("IF_STMT", "WHILE_STMT", "DO_STMT", "SWITCH_STMT", "FOR_STMT",
                      "CXX_FOR_RANGE_STMT"):
            self.control(kind, cursor, children)
        elif kind in ("CASE_STMT", "DEFAULT_STMT"):
            for child in children[1 if kind == "CASE_STMT" else 0:]:
                self.statement(child)
        elif kind == "DECL_STMT":
            for child in children:
                self.variable(child)
        elif kind in ("RETURN_STMT", "LABEL_STMT", "NULL_STMT"):
            for child in children:
                self.expression(child)
        elif cursor.kind.is_expression():
            self.deletion(cursor)
            self.expression(cursor)

    def control(self, kind, cursor, children):
        head = self.text[cursor.extent.start.offset:][:16]
        conditions = 0 if kind in ("FOR_STMT", "CXX_FOR_RANGE_STMT") else 1
        declared = 0
        for child in children:
            name, first = child.kind.name, child.extent.start.offset
            if name in ("VAR_DECL", "DECL_STMT"):
                self.variable(child) if name == "VAR_DECL" else self.statement(child)
                declared = child.extent.end.offset
            elif not child.kind.is_expression():
                self.statement(child)
            elif first < declared:
                conditions = 0  # what is declared is the condition
            elif conditions and kind != "DO_STMT":
                conditions = 0
                if not re.match(rb"if\s+constexpr", head):
                    if kind == "IF_STMT":
                        self.negation(child)
                    self.expression(child)
            elif kind == "DO_STMT" or "FOR" in kind and child != children[-1]:
                if name != "UNARY_OPERATOR":  # without ++i there is no end
                    self.expression(child)
            else:
                self.statement(child)

    def variable(self, cursor):
        if cursor.kind.name != "VAR_DECL":
            return
        name, first = cursor.location.offset, cursor.extent.start.offset
        head = self.text[max(first - 16, 0):name]
        if re.search(rb"\b(constexpr|static)\b[^;{}]*$", head):
            return
        for child in cursor.get_children():
            at = child.extent.start.offset
            if at >= name and self.text[name:at].rstrip()[-1:] != b"[":
                self.expression(child)

    def expression(self, cursor):
        kind, name = cursor.kind, cursor.kind.name
        if name in CONSTANT:
            return
        first, last = cursor.extent.start.offset, cursor.extent.end.offset
        if name == "LAMBDA_EXPR":
            for child in cursor.get_children():
                if child.kind.name == "COMPOUND_STMT":
                    self.statement(child)
            return
        children = list(cursor.get_children())
        if name == "BINARY_OPERATOR" and len(children) == 2:
            self.binary(first, last, *children)
        elif name == "CONDITIONAL_OPERATOR" and children:
            self.negation(children[0])
        elif name in LITERALS:
            self.number(first, last, family(cursor.type))
        elif name == "DECL_REF_EXPR":
            self.constant(cursor, first, last)
        for child in children:
            if child.kind.is_expression():
                self.expression(child)

    def binary(self, first, last, left, right):
        a, b = left.extent.end.offset, right.extent.start.offset
        operator = self.between(a, b)
        if operator in ("&&", "||"):
            at = a + self.text[a:b].index(operator.encode())
            self.logic(operator, at, first, last, left, right)
        if operator not in OPERATORS:
            return
        kinds = {family(left.type), family(right.type)}
        if "OTHER" in kinds and operator not in ("==", "!="):
            return
        whole = kinds <= {"INT", "BOOL"}
        helper, between_whole, else_ = OPERATORS[operator]
        becomes = between_whole if whole or operator in ("&", "|", "<<", ">>") else else_
        pair = f"mutant::{helper}, mutant::{OPERATORS[becomes][0]}"
        change = f"{self.words(first, last)}: {operator} becomes {becomes}"
        at = a + self.text[a:b].index(operator.encode())
        if operator in RELATIONS and whole:
            self.bounds |= {left.extent.start.offset, right.extent.start.offset}
        kind = "relation" if operator in RELATIONS else "arithmetic"
        self.add(kind, first, last, change,
                 [(first, (1, -last, 5), f"mutant::binary<@, {pair}>(", 0),
                  (at, (0, 0, 0), ",", len(operator)),
                  (last, (0, -first, -5), ")", 0)], "" not in kinds, at)

    def logic(self, operator, at, first, last, left, right):
        """By De Morgan: a or b is the opposite of the opposites of both."""
        becomes = {"&&": "||", "||": "&&"}[operator]
        edits = []
        for begin, end, rank in ((first, last, 4), (left.extent.start.offset,
                                 left.extent.end.offset, 3), (right.extent.start.offset,
                                 right.extent.end.offset, 3)):
            edits += [(begin, (1, -end, rank), "mutant::flip<@>(", 0),
                      (end, (0, -begin, -rank), ")", 0)]
        self.add("logic", first, last,
                 f"{self.words(first, last)}: {operator} becomes {becomes}", edits, at=at)
        for operand in (left, right):
            self.negation(operand)

    def negation(self, cursor):
        """The opposite of a condition that is no comparison; those have points of their own."""
        inner = cursor
        while inner.kind.name in ("UNEXPOSED_EXPR", "PAREN_EXPR"):
            children = [c for c in inner.get_children() if c.kind.is_expression()]
            if len(children) != 1 or children[0].extent.start.offset < inner.extent.start.offset:
                break
            inner = children[0]
        if inner.kind.name == "BINARY_OPERATOR":
            sides = list(inner.get_children())
            operator = len(sides) == 2 and self.between(sides[0].extent.end.offset,
                                                        sides[1].extent.start.offset)
            if operator in RELATIONS | {"&&", "||"}:
                return
        first, last = cursor.extent.start.offset, cursor.extent.end.offset
        self.wrap("condition", first, last, 2, "mutant::flip<@>(",
                  f"{self.words(first, last)}: negated")

    def number(self, first, last, kind):
        before = self.text[max(first - 24, 0):first]
        is_real = kind == "REAL" or re.search(rb"\b(Real|double|float)\s*[({]$", before)
        self.value("literal", first, last, "REAL" if is_real else kind)

    def value(self, what, first, last, kind):
        text = self.text[first:last].decode()
        if what == "literal" and not re.fullmatch(r"[\d.][\w.']*|'.*'|true|false", text):
            return  # out of a macro
        if first in self.bounds and kind != "REAL":
            return
        nought = re.fullmatch(r"[0.]+[fF]?", text)
        if kind == "REAL":
            function, becomes = "twice", "1" if nought else "twice that"
        else:
            function = "next"
            becomes = {"true": "false", "false": "true"}.get(text, "one more")
        self.wrap(what, first, last, 6, f"mutant::{function}<@>(", f"{text} becomes {becomes}",
                  sure=False)

    def constant(self, cursor, first, last):
        declared = cursor.referenced
        if declared is None or declared.kind.name != "VAR_DECL":
            return
        kind = family(declared.type)
        start, at = declared.extent.start, declared.location.offset
        if kind not in NUMBERS or start.file is None:
            return
        with open(start.file.name, "rb") as file:
            head = file.read()[start.offset:at]
        if b"constexpr" in head:
            self.value("constant", first, last, kind)

    def deletion(self, cursor):
        name = cursor.kind.name
        first, last = cursor.extent.start.offset, cursor.extent.end.offset
        if name in ("UNEXPOSED_EXPR", "PAREN_EXPR", "CSTYLE_CAST_EXPR", "CXX_STATIC_CAST_EXPR"):
            if self.text[first:first + 5] == b"(void" or name != "UNEXPOSED_EXPR":
                return
        self.wrap("deletion", first, last, 0, "mutant::is(@) ? void() : void(",
                  f"{self.words(first, last)}; deleted")


def points_of(root, files, arguments):
    """Points of files (paths below root), numbered from 1 in the order of file and place."""
    try:
        index = Index.create()
    except LibclangError as error:
        sys.exit(f"libclang is missing: apt-get install python3-clang ({error})")
    finders = {str(root / name): Finder(name, (root / name).read_bytes()) for name in files}
    headers = "\n".join(f'#include "{root / name}"' for name in files if name.endswith(".hpp"))
    everything = (str(root / "headers_of_the_copy.cpp"), headers)
    for path in [everything[0]] + [p for p in finders if p.endswith(".cpp")]:
        unit = index.parse(path, ["-x", "c++", *arguments], unsaved_files=[everything])
        errors = [d for d in unit.diagnostics if d.severity >= d.Error]
        if errors:
            sys.exit(f"libclang cannot read {path}: {errors[0]}")
        for child in unit.cursor.get_children():
            here = child.location.file and child.location.file.name
            if here in finders and (here == path or path == everything[0]):
                finders[here].declaration(child)
    points = [point for finder in finders.values() for point in finder.points]
    points.sort(key=lambda p: (p.file, p.offset, p.kind, p.change))
    for number, point in enumerate(points, 1):
        point.id = number
    return points


def instrument(text, points):
    """The source with every point in it switchable."""
    edits = sorted((offset, order, put.replace("@", str(point.id)), take)
                   for point in points for offset, order, put, take in point.edits)
    pieces, at = [], 0
    for offset, _, put, take in edits:
        pieces += [text[at:offset], put.encode()]
        at = offset + take
    return b"".join(pieces + [text[at:]])
