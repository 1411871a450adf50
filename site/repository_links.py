"""Links out of docs/ into the repository become file names in the site, which has no such
pages; one to a file that does not exist ends the build."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
LINK = re.compile(r"\[([^\]]*)\]\((\.\./[^)#\s]+)(?:#[^)]*)?\)")


def on_page_markdown(markdown, page, **_):
    def as_name(match):
        text, target = match.groups()
        file = (DOCS / page.file.src_path).parent.joinpath(target).resolve()
        if not file.exists():
            raise SystemExit(f"docs/{page.file.src_path}: no such file: {target}")
        if file.is_relative_to(DOCS):
            return match.group()
        name = file.relative_to(ROOT).as_posix()
        return f"`{name}`" if text.strip("`") in name else f"{text} (`{name}`)"

    return LINK.sub(as_name, markdown)
