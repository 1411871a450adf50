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
        found |= {unescaped(key) for key in re.findall(r"\b(?:say\(\s*|own\[)" + STRING, text)}
    # What the server fills in is a whole sentence in its sources.
    server = joined_sources()
    for call in re.finditer(r'\b(?:filled|between)\(', server):
        for literal in re.findall(r'"((?:[^"\\]|\\.)*)"', arguments(server, call.end())):
            if re.search(r"\{\d\}", literal):
                found.add(literal.replace('\\"', '"').strip())
    # Names of effects and their parameters, what to do, and what a recording has too few of.
    words = (SOURCE / "workbench/model/tell/parameter_words.cpp").read_text()
    words = words[words.index("kWords[]"):words.index("words_of")]
    named = dict(re.findall(r'\{"(\w+)",\s*"([^"]+)"', words))
    found |= set(re.findall(r'"([^"]+)"', words)) - named.keys()
    for effect in (SOURCE / "workbench/effects").glob("*.cpp"):
        text = re.sub(r'"\s*\n\s*"', "", effect.read_text())
        found |= {named.get(name, name.replace("_", " ")) for name in re.findall(r'\.name = "(\w+)"', text)}
        found |= set(re.findall(r'\.(?:title|cure|split) =\s*"((?:[^"\\]|\\.)*)"', text))
        for body in re.findall(r"\bExcitation \w+\(.*?\n  ?\}", text, re.S):
            found |= set(re.findall(r'"([^"]* [^"]*)"', body))
    tasks = re.search(r"TASKS = \{(.*?)\}", (ASSETS / "doing.js").read_text(), re.S)[1]
    return found | set(re.findall(STRING, tasks))


def joined_sources():
    """The sources behind the page, neighbouring string literals joined."""
    text = ""
    for folder in ("lib/ident/verdict", "workbench"):
        for file in sorted((SOURCE / folder).rglob("*.cpp")):
            text += file.read_text()
    return re.sub(r'"\s*\n\s*"', "", text)


def arguments(text, start):
    """Up to the bracket that closes the call, those in strings aside."""
    depth = 1
    for match in re.finditer(r'"(?:[^"\\]|\\.)*"|[()]', text[start:]):
        depth += {"(": 1, ")": -1}.get(match[0], 0)
        if depth == 0:
            return text[start:start + match.start()]
    return ""


def said_by_the_server():
    return joined_sources().replace('\\"', '"')


def not_imported():
    """Calls of texts.js in scripts that do not import them; a browser tells only when it gets there."""
    for script in sorted(ASSETS.glob("*.js")):
        text = script.read_text()
        known = " ".join(" ".join(found) for found in re.findall(
            r"import \{([^}]*)\} from './texts.js'|export (?:const|function) (\w+)", text))
        for name in ("say", "translated"):
            if re.search(rf"(?<![.\w]){name}\(", text) and name not in re.findall(r"\w+", known):
                yield f"{script.name}: calls {name}() and does not import it"


def main():
    faults = list(not_imported())
    keys, server = wanted(), said_by_the_server()
    for file in sorted((ASSETS / "texts").glob("[a-z][a-z].js")):
        text = "".join(part.read_text() for part in sorted((ASSETS / "texts").glob(f"{file.stem}*.js")))
        table = dict((unescaped(k), unescaped(v)) for k, v in
                     re.findall(r"^  " + STRING + r":\s*" + STRING + ",$", text, re.M))
        lines = len(re.findall(r"^  '", text, re.M))
        if lines != len(table):
            faults.append(f"{file.name}: {lines} entries, {len(table)} of them understood")
        for key in sorted(keys - table.keys()):
            faults.append(f"{file.name}: lacks '{key}'")
        for key, value in table.items():
            gaps = lambda text: sorted(re.findall(r"\{\d\}", text))
            if gaps(key) != gaps(value):
                faults.append(f"{file.name}: other gaps in '{key}'")
            # The program may put a sentence together at its marks.
            pieces = re.split(r"\{\d\}|[;:()]", key)
            # Names of parameters and codes of effects have underscores in the program.
            name = key.replace(" ", "_")
            said = all(piece.strip() in server for piece in pieces) or \
                f'"{name}"' in server or f'.{name}"' in server
            if key not in keys and not said:
                faults.append(f"{file.name}: nobody says '{key}'")
    print("\n".join(faults) or f"{len(keys)} sentences of the page, all there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
