#!/usr/bin/env python3
"""The page's words: every language has every sentence of the page, and no other.

    test_texts.py SOURCE [--missing]
"""
import html.parser
import pathlib
import re
import sys

SOURCE = pathlib.Path(sys.argv[1])
ASSETS = SOURCE / "workbench/serve/assets"
STRING = r"'((?:[^'\\]|\\.)*)'"


def unescaped(text):
    return re.sub(r"\\(u[0-9a-f]{4}|.)",
                  lambda m: chr(int(m[1][1:], 16)) if len(m[1]) > 1 else m[1], text)


class Texts(html.parser.HTMLParser):
    """Texts and labels of the page, as the browser's text nodes."""

    def __init__(self):
        super().__init__()
        self.found, self.silent = set(), 0

    def handle_starttag(self, tag, attributes):
        self.silent += tag in ("script", "style", "code", "title", "noscript")
        for name, value in attributes:
            if name in ("aria-label", "title", "placeholder"):
                self.found.add(value)

    def handle_endtag(self, tag):
        self.silent -= tag in ("script", "style", "code", "title", "noscript")

    def handle_data(self, data):
        text = " ".join(data.split())
        if not self.silent and re.search(r"[A-Za-z]{2}", text) and text != "Stickband":
            self.found.add(text)


def wanted():
    page = Texts()
    page.feed((ASSETS / "index.html").read_text())
    found = page.found
    for script in ASSETS.glob("*.js"):
        text = script.read_text()
        found |= {unescaped(key) for key in re.findall(r"\bsay\(\s*" + STRING, text)}
    tasks = re.search(r"TASKS = \{(.*?)\}", (ASSETS / "doing.js").read_text(), re.S)[1]
    return found | set(re.findall(STRING, tasks))


def said_by_the_server():
    """All string literals of the sources behind the page, neighbours joined."""
    text = ""
    for folder in ("lib/ident/verdict", "workbench"):
        for file in sorted((SOURCE / folder).rglob("*.cpp")):
            text += file.read_text()
    text = re.sub(r'"\s*\n\s*"', "", text)
    return text.replace('\\"', '"')


def main():
    faults = []
    keys, server = wanted(), said_by_the_server()
    for file in sorted((ASSETS / "texts").glob("*.js")):
        table = dict((unescaped(k), unescaped(v)) for k, v in
                     re.findall(r"^  " + STRING + r":\s*" + STRING + ",$", file.read_text(), re.M))
        lines = len(re.findall(r"^  '", file.read_text(), re.M))
        if lines != len(table):
            faults.append(f"{file.name}: {lines} entries, {len(table)} of them understood")
        for key in sorted(keys - table.keys()):
            faults.append(f"{file.name}: lacks '{key}'")
        for key, value in table.items():
            gaps = lambda text: sorted(re.findall(r"\{\d\}", text))
            if gaps(key) != gaps(value):
                faults.append(f"{file.name}: other gaps in '{key}'")
            pieces = re.split(r"\{\d\}", key)
            if key not in keys and not all(piece.strip() in server for piece in pieces):
                faults.append(f"{file.name}: nobody says '{key}'")
    print("\n".join(faults) or f"{len(keys)} sentences of the page, all there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
