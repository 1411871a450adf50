#!/usr/bin/env python3
"""The gates must fail where they should: feeds each one an offence and a clean twin.

    test_gates.py CXX NM
"""
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import check_loops
import check_sources
import check_symbols

CXX, NM = sys.argv[1:3]
FLAGS = ["-std=c++20", "-O2", "-DNDEBUG", "-fno-rtti", "-c"]


class Sources(unittest.TestCase):
    def offences(self, check, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True)
            path.write_text(text)
            return list(check(pathlib.Path(folder)))

    def expect(self, check, name, text, count):
        found = self.offences(check, name, text)
        self.assertEqual(len(found), count, f"{name}: {text!r} gave {found}")

    def test_include_directions(self):
        includes = check_sources.check_includes
        for name, header, count in [
            ("lib/ident/a.cpp", '"ident/b.hpp"', 0),
            ("lib/ident/a.cpp", "<cmath>", 0),
            ("lib/ident/a.cpp", "<Eigen/Core>", 0),
            ("lib/ident/a.cpp", '"wire/b.hpp"', 1),
            ("lib/ident/a.cpp", '"workbench/b.hpp"', 1),
            ("lib/ident/a.cpp", "<hal/b.hpp>", 1),
            ("lib/ident/a.cpp", "<unistd.h>", 1),
            ("lib/ident/a.cpp", "<nlohmann/json.hpp>", 1),
            ("lib/ident/a.cpp", '"../wire/b.hpp"', 1),
            ("lib/ident/valve/a.cpp", '"ident/valve/b.hpp"', 0),
            ("lib/ident/valve/a.cpp", '"ident/process/b.hpp"', 0),
            ("lib/ident/valve/a.cpp", '"ident/gap/b.hpp"', 1),
            ("lib/ident/base/a.cpp", '"ident/signal/b.hpp"', 1),
            ("lib/ident/verdict/a.cpp", '"ident/monitor.hpp"', 1),
            ("lib/ident/cellar/a.cpp", '"ident/base/b.hpp"', 1),
            ("lib/ident/a.cpp", '"ident/gap/b.hpp"', 0),
            ("workbench/model/search/a.cpp", '"workbench/model/judge/b.hpp"', 0),
            ("workbench/model/judge/a.cpp", '"workbench/model/search/b.hpp"', 1),
            ("workbench/model/judge/a.cpp", '"workbench/effects/b.hpp"', 0),
            ("lib/wire/a.hpp", '"ident/b.hpp"', 0),
            ("lib/wire/a.hpp", "<Eigen/Core>", 1),
            ("lib/wire/a.hpp", '"hal/b.hpp"', 1),
            ("hal/linux/a.cpp", "<linux/can.h>", 0),
            ("hal/linux/a.cpp", '"ident/b.hpp"', 1),
            ("firmware/a.cpp", '"hal/b.hpp"', 0),
            ("firmware/a.cpp", '"workbench/b.hpp"', 1),
            ("workbench/cli/a.cpp", '"wire/b.hpp"', 0),
            ("workbench/cli/a.cpp", "<vector>", 0),
            ("workbench/cli/a.cpp", '"hal/b.hpp"', 0),
            ("workbench/pull/a.cpp", '"hal/b.hpp"', 1),
            ("workbench/cli/a.cpp", '"firmware/b.hpp"', 1),
            ("workbench/model/a.cpp", '"python/b.hpp"', 1),
            ("python/core/a.cpp", '"workbench/b.hpp"', 0),
            ("python/core/a.cpp", '"hal/b.hpp"', 1),
            ("host-tests/unit/a.cpp", '"workbench/b.hpp"', 0),
        ]:
            self.expect(includes, name, f"  #include {header}\n", count)

    def test_words(self):
        words = check_sources.check_words
        for text, count in [
            ("int* p = new int;", 1),
            ("delete p;", 1),
            ("delete[] p;", 1),
            ("A(const A&) = delete;", 0),
            ("// new → push, throw nothing", 0),
            ("/* new\n throw */ int renewed;", 0),
            ('auto s = "new throw";', 0),
            ("int n = 1'000'000; p = new int; int m = 2'000;", 1),
            ("throw 1;", 1),
            ("p = malloc(3);", 1),
            ("std::free(p);", 1),
            ("std::printf(x);", 1),
            ("snprintf(a, 3, b);", 1),
            ("std::function<void()> f;", 1),
            ("dynamic_cast<B&>(a);", 1),
            ("typeid(a);", 1),
            ("free_run(a);", 0),
            ("#include <vector>", 1),
            ("#include <chrono>", 1),
            ("#include <array>", 0),
        ]:
            self.expect(words, "lib/ident/a.cpp", text + "\n", count)
            self.expect(words, "lib/wire/a.cpp", text + "\n", count)
            self.expect(words, "workbench/x/a.cpp", text + "\n", 0)

    def test_warnings_do_not_fail(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "long.cpp"
            path.write_text("\n" * 501)
            with contextlib.redirect_stdout(io.StringIO()) as said:
                self.assertEqual(check_sources.main([folder, "lengths"]), 0)
                self.assertIn("501 lines", said.getvalue())
                path.rename(path.with_name("main.cpp"))
                self.assertEqual(check_sources.main([folder, "lengths"]), 1)

    def test_lengths(self):
        lengths = check_sources.check_lengths
        self.expect(lengths, "workbench/main.cpp", "\n" * 99, 0)
        self.expect(lengths, "workbench/main.cpp", "\n" * 100, 1)
        self.expect(lengths, "lib/ident/a.cpp", "\n" * 400, 0)
        self.expect(lengths, "lib/ident/a.cpp", "\n" * 401, 1)
        self.expect(lengths, "host-tests/a.cpp", "\n" * 500, 0)
        self.expect(lengths, "host-tests/a.cpp", "\n" * 501, 1)
        for head, tail, count in [
            ("void f() {", "}", 1),
            ("template <class T>\nint A<T>::f(int a,\n int b) const {", "}", 1),
            ("A::A(int a) : a_(a) {", "}", 1),
            ("bool operator==(const A& a) {", "}", 1),
            ("class A {\n void g() { if (a) {", "} } };", 1),
            ("class A {", "};", 0),
            ("namespace a {\nenum class B {", "}; }", 0),
            ("constexpr std::array kA = to_array<int>({", "});", 0),
            ("const int a[] = {", "};", 0),
            ("#define A(b) {", "", 0),
            ('void f() { "{"; }  // {', "", 0),
        ]:
            for lines in (56, 60):
                text = head + "\n" * lines + tail + "\n"
                self.expect(lengths, "lib/ident/a.cpp", text, count if lines == 60 else 0)


    def test_columns(self):
        columns = check_sources.check_columns
        code = "int a" + "b" * 85 + ";"
        self.expect(columns, "workbench/a.cpp", "\n" + code, 1)
        self.expect(columns, "workbench/a.cpp", code.replace("bb", "b", 1), 0)
        self.expect(columns, "workbench/a.cpp", "/// " + code, 0)
        self.expect(columns, "workbench/a.cpp", f'f("{code}");', 0)
        self.expect(columns, "workbench/a.cpp", f'f(R"(x\n{code}\n)");\n{code}', 1)

    def test_tests(self):
        for name, count in [
            ("host-tests/unit/ident/base/test_nnls.cpp", 0),
            ("host-tests/unit/ident/base/test_nnls_large.cpp", 0),
            ("host-tests/unit/ident/base/test_nnlsx.cpp", 1),
            ("host-tests/unit/ident/base/nnls.hpp", 1),
            ("host-tests/unit/ident/cellar/test_nnls.cpp", 1),
            ("host-tests/unit/test_nnls.cpp", 1),
        ]:
            with tempfile.TemporaryDirectory() as folder:
                for path in [name, "lib/ident/base/nnls.hpp"]:
                    path = pathlib.Path(folder) / path
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_text("")
                found = list(check_sources.check_tests(pathlib.Path(folder)))
                self.assertEqual(len(found), count, f"{name} gave {found}")


    def test_types(self):
        for one, other, count in [
            ("namespace a {\nstruct Part {\n};\n}  // namespace a",
             "namespace a {\nenum class Part { kU };\n}  // namespace a", 1),
            ("namespace a {\nclass Part : public B {\n};\n}  // namespace a",
             "namespace a {\nstruct Part final {\n};\n}  // namespace a", 1),
            ("namespace a {\nstruct Part {\n};\n}  // namespace a",
             "namespace b {\nstruct Part {\n};\n}  // namespace b", 0),
            ("namespace a {\nstruct Part {\n};\n}  // namespace a",
             "namespace a {\nclass Part;\nstruct Part::Inner {\n};\n}  // namespace a", 0),
            ("namespace a {\nstruct Part {\n};\n}  // namespace a",
             "namespace a {\nnamespace {\nstruct Part {\n};\n}  // namespace\n"
             "}  // namespace a", 0),
        ]:
            with tempfile.TemporaryDirectory() as folder:
                room = pathlib.Path(folder) / "workbench"
                room.mkdir()
                (room / "one.hpp").write_text(one)
                (room / "other.hpp").write_text(other)
                found = list(check_sources.check_types(pathlib.Path(folder)))
            self.assertEqual(len(found), count, f"{one!r} and {other!r} gave {found}")

    def test_equations(self):
        page = "| (8) | a |\n- **(E1)** b\n- **(E2)** c (E9)\n"
        for name, text, count in [
            ("lib/ident/a.cpp", "// equation (8), (E1) – (E2)", 0),
            ("workbench/a.cpp", "/// Equation\n/// (8), (E1), (E2)", 0),
            ("lib/ident/a.cpp", "// (8), (E1), (E2)", 1),
            ("lib/ident/a.cpp", "// equation (8), (E1)", 1),
            ("lib/ident/a.cpp", "f(E1, E2);  // equation (8)", 2),
            ("lib/ident/a.cpp", "// equation (8), (E1) – (E3)", 1),
            ("lib/ident/a.cpp", "// equations (8), (E1), (E2), equation (9)", 1),
            ("lib/wire/a.cpp", "// equation (8), (E1) – (E2)", 3),
        ]:
            with tempfile.TemporaryDirectory() as folder:
                for path, content in [("docs/model.md", page), (name, text + "\n")]:
                    path = pathlib.Path(folder) / path
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_text(content)
                found = list(check_sources.check_equations(pathlib.Path(folder)))
                self.assertEqual(len(found), count, f"{text} gave {found}")


class Loops(unittest.TestCase):
    def offences(self, text, page=""):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "lib/ident").mkdir(parents=True)
            (root / "docs").mkdir()
            (root / "lib/ident/a.cpp").write_text(text)
            (root / "docs/memory.md").write_text(page)
            return list(check_loops.check(root))

    def test_loops(self):
        for text, count in [
            ("for (int i = 0; i < n; ++i) {}", 0),
            ("for (int i = n; i-- > 0;) {}", 0),
            ("for (const A& a : list()) {}", 0),
            ("// while (true)\n", 0),
            ("while (more()) {}", 1),
            ("for (;;) {}", 1),
            ("for (int i = 0; i < n;) {}", 1),
            ("do {\n} while (more());", 1),
        ]:
            self.assertEqual(len(self.offences(text)), count, text)
        page = "| `a.cpp` | `more()` | it ends |\n"
        self.assertEqual(self.offences("while (more()) {}", page), [])
        self.assertEqual(len(self.offences("while (others()) {}", page)), 1)


class Symbols(unittest.TestCase):
    def status(self, text):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "a.cpp"
            target = pathlib.Path(folder) / "a.o"
            source.write_text(text)
            subprocess.run([CXX, *FLAGS, str(source), "-o", str(target)], check=True)
            with contextlib.redirect_stdout(io.StringIO()):
                return check_symbols.main([NM, str(target)])

    def test_offences(self):
        for text in [
            "#include <cstdlib>\nvoid* f(int n) { return std::malloc(n); }",
            "#include <cstdlib>\nvoid f(void* p) { std::free(p); }",
            "int* f(int n) { return new int[n]; }",
            "void f(int* p) { delete p; }",
            "void f() { throw 1; }",
            "#include <cstdio>\nvoid f(int n) { std::printf(\"%d\", n); }",
            "#include <ctime>\nlong f() { return std::clock(); }",
            "#include <ctime>\nlong f() { return std::time(nullptr); }",
            "#include <chrono>\nauto f() { return std::chrono::steady_clock::now(); }",
            "#include <iostream>\nvoid f() { std::cout << 1; }",
            "#include <string>\nstd::string f(int n) { return std::string(n, 'a'); }",
            "struct A { ~A(); }; A& f() { static A a; return a; }",
            "#include <cstdlib>\nvoid f() { std::abort(); }",
        ]:
            self.assertEqual(self.status(text), 1, text)

    def test_clean(self):
        for text in [
            "#include <cmath>\ndouble f(double x) { return std::exp(x) + std::sqrt(x); }",
            "void g(); void f() { g(); }",
            "int f(int n) { return n + 1; }",
            "double timeout(); double f() { return timeout(); }",
        ]:
            self.assertEqual(self.status(text), 0, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
