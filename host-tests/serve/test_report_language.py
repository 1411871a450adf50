#!/usr/bin/env python3
"""`stickband report --language`: no text of the report stays English.

    test_report_language.py STICKBAND
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile

STICKBAND = sys.argv[1]
READ = ("aria-label", "title", "placeholder", "data-label", "data-more", "data-at")
# Names that are the same in every language.
NAMES = {"na, nb, nk"}
ENGLISH = re.compile(r"\b(the|and|with|of|is|from|to|are|samples|not|by|or)\b")
# Scenario, and the effects of a model of it; None: the report on the valve.
REPORTS = [("stiction-setpoint", None), ("backlash", None), ("setpoint", None),
           ("random-load", None), ("stiction-setpoint", "valve.stiction"),
           ("healthy", "valve.positioner_lag,disturbance.step"), ("quantised", "")]
# The first is fitted, the last judges, and one between them has a pause.
PARTS = {"a.csv": [(0, 1000)], "b.csv": [(1000, 1400), (1500, 2100)], "c.csv": [(2100, 2900)]}


class Texts(html.parser.HTMLParser):
    def __init__(self, page):
        super().__init__()
        self.found, self.silent, self.language = [], 0, None
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        self.silent += tag in ("style", "script", "code")
        for name, value in attributes:
            if name == "lang":
                self.language = value
            if name in READ and value:
                self.found.append(value)

    def handle_endtag(self, tag):
        self.silent -= tag in ("style", "script", "code")

    def handle_data(self, data):
        if data.strip() and not self.silent:
            self.found.append(" ".join(data.split()))


def run(*words, code=0):
    done = subprocess.run([STICKBAND, *words], capture_output=True, text=True, check=False)
    assert done.returncode == code, (words, done.returncode, done.stderr)
    return done


def recorded(folder, scenario, effects):
    """Words of the command line for the report of a scenario, or of a model of it."""
    recording, truth = folder / f"{scenario}.csv", folder / f"{scenario}.json"
    run("simulate", scenario, "--seed", "2", "-o", recording, "--truth", truth)
    if effects is None:
        return [recording, "--truth", truth]
    model = folder / f"{scenario}.model.json"
    run("model", recording, "-o", model, *(["--with", effects] if effects else []))
    return [recording, "--model", model]


def several(folder):
    """The same for several recordings of one loop, and for a model of them."""
    head, *rows = (folder / "stiction-setpoint.csv").read_text().splitlines()
    for name, parts in PARTS.items():
        kept = [row for first, last in parts for row in rows[first:last]]
        (folder / name).write_text("\n".join([head, *kept]) + "\n")
    fitted = [folder / "a.csv", folder / "b.csv"]
    judged = [*fitted, "--validate", folder / "c.csv"]
    model = folder / "model.json"
    run("model", *judged, "-o", model)
    return [fitted, [*judged, "--model", model]]


def pages(folder, words):
    out = {}
    for language in ("en", "de"):
        target = folder / f"{language}.html"
        run("report", *words, "--language", language, "-o", target)
        out[language] = target.read_text()
    run("report", *words, "-o", folder / "none.html")
    without_time = lambda text: re.sub(r"Identified in \d+ ms", "", text)
    assert without_time((folder / "none.html").read_text()) == without_time(out["en"]), \
        "without --language the report is English"
    return Texts(out["en"]), Texts(out["de"])


def main():
    left = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        reports = [recorded(folder, *report) for report in REPORTS] + several(folder)
        for words in reports:
            english, german = pages(folder, words)
            assert (english.language, german.language) == ("en", "de")
            assert len(english.found) == len(german.found) > 100
            for was, now in zip(english.found, german.found):
                same = was == now and re.search("[A-Za-z]{2}", was) and was not in NAMES
                if same or ENGLISH.search(now):
                    left.append(f"{words[0].name}: {was!r} became {now!r}")
        refused = run("report", folder / "setpoint.csv", "--language", "xx", "-o",
                      folder / "no.html", code=2)
        assert "de" in refused.stderr and not (folder / "no.html").exists(), refused.stderr
    print("\n".join(left) or f"{len(reports)} reports, no English left")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
