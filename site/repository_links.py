"""Links out of docs/ into the repository become file names in the site, which has no such
pages; one to a file that does not exist ends the build."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"\[([^\]]*)\]\((\.\./[^)#\s]+)(?:#[^)]*)?\)")


def on_page_markdown(markdown, page, **_):
    def as_name(match):
        text, target = match.groups()
        file = (ROOT / "docs" / target).resolve()
        if not file.exists():
            raise SystemExit(f"docs/{page.file.src_path}: no such file: {target}")
        name = file.relative_to(ROOT).as_posix()
        return f"`{name}`" if text.strip("`") in name else f"{text} (`{name}`)"

    return LINK.sub(as_name, markdown)
