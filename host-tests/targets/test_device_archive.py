#!/usr/bin/env python3
"""The gate on bare-metal archives must fail where it should.

    test_device_archive.py TOOLS
"""
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import board
import check_device_archive

TOOLS = sys.argv[1] if len(sys.argv) > 1 else "arm-none-eabi-"
FLAGS = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-std=c++20",
         "-Os", "-DNDEBUG", "-fno-math-errno", "-ffunction-sections", "-c"]


class DeviceArchive(unittest.TestCase):
    def said(self, text):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "a.cpp"
            archive = pathlib.Path(folder) / "a.a"
            source.write_text(f"#include <cmath>\n#include <cstdlib>\nnamespace ident {{\n{text}\n}}\n")
            subprocess.run([f"{TOOLS}g++", *FLAGS, str(source), "-o", str(source) + ".o"], check=True)
            subprocess.run([f"{TOOLS}ar", "rcs", str(archive), str(source) + ".o"], check=True)
            with contextlib.redirect_stdout(io.StringIO()) as out:
                status = check_device_archive.main([TOOLS, str(archive)])
            return status, out.getvalue()

    def test_offences(self):
        for text, word in [
            ("float f(float x) { return float(double(x) * 1.1); }", "double in float code"),
            ("template <class R> R f(R x) { return std::exp(double(x)); }"
             "template float f<float>(float);", "double in float code"),
            ("void* f(int n) { return std::malloc(n); }", "malloc"),
            ("float f(float x) { return std::exp(x); }", "expf"),
            ("extern \"C\" int rand(); int f() { return rand(); }", "rand"),
        ]:
            status, out = self.said(text)
            self.assertEqual(status, 1, text)
            self.assertIn(word, out)

    def test_clean(self):
        for text in [
            "float f(float x) { return std::floor(x) + std::sqrt(x); }",
            "template <class R> R f(R x) { return x * R(1.5); } template double f<double>(double);",
            "struct A { int a[40]; }; void f(A& x, const A& y) { x = y; }",
            "long long f(long long a, long long b) { return a / b; }",
        ]:
            status, out = self.said(text)
            self.assertEqual(status, 0, f"{text}: {out}")


if __name__ == "__main__":
    board.skip_unless(f"{TOOLS}g++")
    unittest.main(argv=sys.argv[:1])
