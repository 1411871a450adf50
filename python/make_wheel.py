#!/usr/bin/env python3
"""Packs the built package as a wheel, with the standard library alone.

    make_wheel.py FOLDER LICENSE OUT

FOLDER holds the package and its .dist-info/METADATA as the build leaves them. Writes
OUT/NAME-VERSION-TAGS.whl for the Python that runs this, and prints its path. The same files
make the same wheel.
"""
import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

EARLIEST = (1980, 1, 1, 0, 0, 0)  # of a ZIP archive


def tags():
    """Interpreter, its binary interface, and the machine."""
    python = "cp{0.major}{0.minor}".format(sys.version_info)
    return f"{python}-{python}-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")


def line_of(name, content):
    """A line of RECORD."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def contents(folder, licence):
    """{name in the archive: bytes} of all but RECORD, and the name of that."""
    found = sorted(folder.glob("*.dist-info"))
    if len(found) != 1:
        raise SystemExit(f"{folder}: expected one .dist-info folder, found "
                         f"{', '.join(one.name for one in found) or 'none'}; build `python` "
                         "in a new folder")
    info = found[0]
    package = folder / info.name.split("-")[0]
    files = {path.relative_to(folder).as_posix(): path.read_bytes()
             for path in sorted(package.iterdir()) if path.is_file()}
    if not any(name.endswith(".so") for name in files):
        raise SystemExit(f"{package}: expected the compiled module, found none; build `python`")
    files[f"{info.name}/METADATA"] = (info / "METADATA").read_bytes()
    files[f"{info.name}/LICENSE"] = licence.read_bytes()
    files[f"{info.name}/WHEEL"] = (
        "Wheel-Version: 1.0\nGenerator: stickband\nRoot-Is-Purelib: false\n"
        f"Tag: {tags()}\n").encode()
    return files, f"{info.name}/RECORD"


def main(arguments):
    if len(arguments) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    folder, licence, out = map(pathlib.Path, arguments)
    files, record = contents(folder, licence)
    lines = [line_of(name, content) for name, content in files.items()]
    files[record] = "".join([*lines, f"{record},,\n"]).encode()
    out.mkdir(parents=True, exist_ok=True)
    wheel = out / f"{record.split('.dist-info')[0]}-{tags()}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            archive.writestr(entry, content)
    print(wheel)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
