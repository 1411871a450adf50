"""Screens an archive with many processes or machines, on Dask distributed.

    python3 -m stickband.screen archive/ -o plant.html -o plant.parquet
    python3 -m stickband.screen /nfs/archive --scheduler tcp://head:8786 -o plant.sqlite

>>> from stickband.screen import screen
>>> frame = screen(["archive/"])          # doctest: +SKIP

The frame is of pandas, one row a loop, ranked.

The files are divided into sets that share no loop (``stickband screen --plan``); each task
screens some of them with the program ``stickband`` on one processor and hands back its
journal; the program then joins the journals, finds the groups and writes the results. So
they are those of ``stickband screen`` on one machine, whatever the workers do: a task whose
worker dies is done again by another.

Every worker must see the files under the same names and have the program of the same
version, on its PATH or where the environment variable STICKBAND says. Without
``scheduler`` a cluster of this machine is started and stopped again.
"""
# mypy: allow-untyped-calls
# (Dask is not annotated.)
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas

__all__ = ["ScreeningFailed", "main", "screen"]

#: Loops in one task: some seconds of work, so that starting it costs little, and a worker
#: that dies loses little.
LOOPS_PER_TASK = 40
#: What a long table, whose tags are not known yet, is taken for.
BYTES_PER_LOOP = 200_000
#: Endings that the program writes itself.
WRITTEN_BY_PROGRAM = {".html", ".htm", ".jsonl", ".ndjson", ".json", ".csv", ".sqlite",
                      ".sqlite3", ".db"}


class ScreeningFailed(RuntimeError):
    """The program ended with another exit code than 0; ``code`` has it."""

    def __init__(self, code: int, message: str) -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self) -> tuple[type, tuple[int, str]]:
        return type(self), (self.code, str(self))  # workers send it to who waits for them


def program() -> str:
    """Path of the program: STICKBAND, or the one on the PATH."""
    found = os.environ.get("STICKBAND") or shutil.which("stickband")
    if not found:
        raise ScreeningFailed(1, "expected the program stickband on the PATH, found none; "
                                 "install it, or set STICKBAND to its path")
    return found


def _run(arguments: Iterable[str]) -> "subprocess.CompletedProcess[str]":
    done = subprocess.run([program(), "screen", *arguments], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise ScreeningFailed(done.returncode, done.stderr.strip())
    return done


def _seen_from_anywhere(options: Iterable[str]) -> list[str]:
    """The options with the file of ``--pairs`` by its whole path: a worker has another
    folder. Rules, as ``*.OP/*.PV``, stay."""
    def whole(value: str) -> str:
        return os.path.abspath(value) if "*" not in value and os.path.exists(value) else value

    words: list[str] = []
    for word in options:
        if words and words[-1] == "--pairs":
            word = whole(word)
        elif word.startswith("--pairs="):
            word = "--pairs=" + whole(word[len("--pairs="):])
        words.append(word)
    return words


def _screen_some(files: Iterable[str], options: Iterable[str]) -> str:
    """A task: the journal of these files."""
    with tempfile.TemporaryDirectory(prefix="stickband-") as folder:
        listed = pathlib.Path(folder) / "files"
        listed.write_text("".join(f"{os.path.abspath(file)}\n" for file in files))
        journal = pathlib.Path(folder) / "journal"
        # Without files that could be read the exit code is 3: the journal says why.
        _run(["@" + str(listed), "--threads", "1", "--journal", str(journal), *options,
              "--json"])
        return journal.read_text()


def _tasks(sets: Iterable[dict[str, Any]], loops_per_task: int) -> list[list[str]]:
    """Sets of files, put together until they are worth a task; the largest first."""
    def size(one: dict[str, Any]) -> int:
        return int(one["loops"] or max(1, one["bytes"] // BYTES_PER_LOOP))

    tasks: list[list[str]] = []
    files: list[str] = []
    loops = 0
    for one in sorted(sets, key=size, reverse=True):
        files += one["files"]
        loops += size(one)
        if loops >= loops_per_task:
            tasks.append(files)
            files, loops = [], 0
    return tasks + [files] if files else tasks


def screen(paths: Iterable[str | os.PathLike[str]], *, client: Any = None,
           options: Iterable[str] = (), outputs: Sequence[str] = (),
           loops_per_task: int = LOOPS_PER_TASK,
           progress: Callable[[int, int], object] | None = None) -> "pandas.DataFrame":
    """Screens ``paths`` (files, folders, patterns, @LIST) and returns a pandas frame.

    ``client``: a ``distributed.Client``; None starts a cluster of this machine for the
    time of the call. ``options``: further options of ``stickband screen``, as words.
    ``outputs``: files to write; .parquet needs pyarrow or fastparquet. ``progress``:
    called with (done, all) tasks. Raises :class:`ScreeningFailed`.
    """
    import pandas
    from distributed import Client, LocalCluster, as_completed

    words = [("@" + os.path.abspath(p[1:])) if p.startswith("@") else os.path.abspath(p)
             for p in map(str, paths)]
    options = _seen_from_anywhere(options)
    parquet = [out for out in outputs if pathlib.Path(out).suffix == ".parquet"]
    for out in outputs:
        if out not in parquet and pathlib.Path(out).suffix.lower() not in WRITTEN_BY_PROGRAM:
            raise ValueError(f"{out}: expected an ending of "
                             f"{', '.join(sorted(WRITTEN_BY_PROGRAM))}, .parquet")
    if parquet:
        _need_parquet()
    plan = _run([*words, "--plan", *options]).stdout
    tasks = _tasks([json.loads(line) for line in plan.splitlines()], loops_per_task)
    own = None
    if client is None:
        own = LocalCluster(threads_per_worker=1, dashboard_address=":0")
        client = Client(own)
    try:
        futures = client.map(_screen_some, tasks, options=options, pure=False, retries=3)
        with tempfile.TemporaryDirectory(prefix="stickband-") as folder:
            journal = pathlib.Path(folder) / "journal"
            done = 0
            with journal.open("w") as joined:
                for future, text in as_completed(futures, with_results=True):
                    joined.write(text)
                    future.release()
                    done += 1
                    if progress:
                        progress(done, len(tasks))
            lines = pathlib.Path(folder) / "result.jsonl"
            written = [word for out in outputs if out not in parquet for word in ("-o", out)]
            last = _run([*words, "--journal", str(journal), *options, "-o", str(lines),
                         *written])
            frame = pandas.DataFrame(
                [_flat(json.loads(line)) for line in lines.read_text().splitlines()])
            frame.attrs["exit_code"] = last.returncode
    finally:
        if own is not None:
            client.close()
            own.close()
    for out in parquet:
        frame.to_parquet(out)
    return frame


def _flat(loop: dict[str, Any]) -> dict[str, Any]:
    """One level of names, as in the CSV file; lists stay lists."""
    flat: dict[str, Any] = {}
    for name, value in loop.items():
        if isinstance(value, dict):
            for inner, part in _flat(value).items():
                flat[f"{name}_{inner}"] = part
        elif name == "trend":
            flat[name] = json.dumps(value)
        elif name != "schema":
            flat[name] = value
    return flat


def _need_parquet() -> None:
    for engine in ("pyarrow", "fastparquet"):
        try:
            __import__(engine)
            return
        except ImportError:
            continue
    raise ScreeningFailed(1, "a Parquet file needs pyarrow or fastparquet, found neither; "
                             "install one, or write .csv or .sqlite")


def main(arguments: Sequence[str] | None = None) -> int:
    """The command line; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="python3 -m stickband.screen",
        description="Screen an archive on Dask: which of many loops have a valve that sticks.")
    parser.add_argument("paths", nargs="+", metavar="PATH",
                        help="files, folders, patterns, or @LIST")
    parser.add_argument("-o", "--output", action="append", default=[], metavar="FILE",
                        help="result: .html, .jsonl, .csv, .sqlite, .parquet; repeatable")
    parser.add_argument("--scheduler", metavar="ADDRESS",
                        help="of a running cluster, tcp://HOST:PORT; without it, a local one")
    parser.add_argument("--pairs", metavar="RULES", help="as in stickband screen")
    parser.add_argument("--ts", metavar="SECONDS", help="as in stickband screen")
    parser.add_argument("--date-order", choices=["dmy", "mdy", "ymd"])
    parser.add_argument("--decimal", choices=["point", "comma"])
    parser.add_argument("--same-clock", action="store_true", help="as in stickband screen")
    parser.add_argument("--apart", action="store_true", help="as in stickband screen")
    parser.add_argument("--loops-per-task", type=int, default=LOOPS_PER_TASK, metavar="N")
    parser.add_argument("--json", action="store_true", help="print the frame as JSON lines")
    given = parser.parse_args(arguments)
    options = []
    for name in ("pairs", "ts", "date_order", "decimal"):
        if getattr(given, name) is not None:
            options += ["--" + name.replace("_", "-"), getattr(given, name)]
    options += [flag for flag in ("--same-clock", "--apart")
                if getattr(given, flag[2:].replace("-", "_"))]
    try:
        from distributed import Client
    except ImportError:
        print("stickband.screen: expected Dask distributed, found none; install "
              "python3-distributed and python3-pandas", file=sys.stderr)
        return 1

    def progress(done: int, all_tasks: int) -> None:
        if sys.stderr.isatty():
            end = "\n" if done == all_tasks else ""
            print(f"\rtask {done} of {all_tasks}", end=end, file=sys.stderr, flush=True)

    client = None
    try:
        if given.scheduler:
            client = Client(given.scheduler)
            print(f"stickband.screen: dashboard {client.dashboard_link}", file=sys.stderr)
        frame = screen(given.paths, client=client, options=options, outputs=given.output,
                       loops_per_task=given.loops_per_task, progress=progress)
    except ValueError as error:
        print(f"stickband.screen: {error}", file=sys.stderr)
        return 2
    except (ScreeningFailed, OSError) as error:
        print(f"stickband.screen: {error}", file=sys.stderr)
        return error.code if isinstance(error, ScreeningFailed) else 1
    finally:
        if client is not None:
            client.close()
    if given.json:
        print(frame.to_json(orient="records", lines=True), end="")
    elif not given.output:
        columns = ["loop", "verdict", "cost", "stick_band_ascending_value", "group", "error"]
        print(frame[columns].head(40).to_string(index=False))
    return int(frame.attrs["exit_code"])


if __name__ == "__main__":
    sys.exit(main())
