#!/usr/bin/env python3
"""stickband.screen on a Dask cluster of its own.

    test_dask.py STICKBAND BUILT_PACKAGE SOURCE_FOLDER [LOOPS]

The package as built, or where there is none the one module that needs no build.

A scheduler and two workers on free ports of 127.0.0.1; one worker is killed in the middle.
The results must be those of one process, byte for byte. Exits with 77 without Dask.
"""
import json
import os
import pathlib
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import time

try:
    import distributed
    import pandas  # noqa: F401, the module under test needs it
except ImportError as missing:
    print(f"dask: skipped: {missing}; install python3-distributed and python3-pandas")
    sys.exit(77)

stickband = os.path.abspath(sys.argv[1])
built = list(pathlib.Path(sys.argv[2], "stickband").glob("_core*.so"))
package = os.path.abspath(sys.argv[2] if built else sys.argv[3])
sys.path.insert(0, package)
os.environ["STICKBAND"] = stickband
os.environ["PYTHONPATH"] = package
loops = int(sys.argv[4]) if len(sys.argv) > 4 else 12
from stickband import screen as screening  # noqa: E402


PATIENCE = 240  # s, for a machine that is busy


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def check(holds, what):
    if not holds:
        raise SystemExit(f"dask: FAILED: {what}")


class Cluster:
    """Scheduler and workers as processes of their own, ended by their ids."""

    def __init__(self, workers):
        port = free_port()
        self.address = f"tcp://127.0.0.1:{port}"
        self.processes = []
        self.log = tempfile.TemporaryFile()
        self.start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port),
                   "--dashboard-address", f"127.0.0.1:{free_port()}", "--no-show")
        self.workers = [self.worker() for _ in range(workers)]
        try:
            with distributed.Client(self.address, timeout=PATIENCE) as client:
                client.wait_for_workers(workers, timeout=PATIENCE)
        except BaseException:
            self.stop()
            self.log.seek(0)
            print(self.log.read().decode(errors="replace")[-2000:])
            raise

    def start(self, module, *arguments):
        process = subprocess.Popen([sys.executable, "-m", module, *arguments],
                                   stdout=self.log, stderr=self.log)
        self.processes.append(process)
        return process

    def worker(self):
        return self.start("distributed.cli.dask_worker", self.address, "--nthreads", "1",
                          "--no-nanny", "--no-dashboard", "--host", "127.0.0.1")

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
        for process in self.processes:
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


with tempfile.TemporaryDirectory() as folder:
    plant = os.path.join(folder, "plant")
    subprocess.run([stickband, "simulate", "plant", "--loops", str(loops), "--seed", "3",
                    "--samples", "1200", "--files", "-o", plant], check=True,
                   capture_output=True)
    pathlib.Path(plant, "broken.csv").write_text("this is no table\n")
    alone = os.path.join(folder, "alone.jsonl")
    before = children_seconds()
    subprocess.run([stickband, "screen", plant, "--threads", "1", "-o", alone], check=True,
                   capture_output=True)
    one_process = children_seconds() - before

    cluster = Cluster(2)
    try:
        with distributed.Client(cluster.address) as client:
            together = os.path.join(folder, "together.jsonl")
            killed = []

            def kill_one(done, all_tasks):
                if not killed:
                    killed.append(True)
                    os.kill(cluster.workers[0].pid, signal.SIGKILL)

            frame = screening.screen([plant], client=client, outputs=[together],
                                     loops_per_task=2, progress=kill_one)
            check(killed, "no task was done before the last")
            check(len(client.scheduler_info()["workers"]) == 1, "the worker did not die")
    finally:
        cluster.stop()
    wanted = [json.loads(line) for line in open(alone)]
    found = [json.loads(line) for line in open(together)]
    check(wanted == found, "the results differ from those of one process")
    check(len(frame) == len(wanted) and list(frame["loop"]) == [w["loop"] for w in wanted],
          "the frame has other rows")
    check(frame["error"].notna().sum() == 1, "the broken file is one row with an error")

    # Processor time: tasks of usual size against one process.
    cluster = Cluster(1)
    begin = time.time()
    try:
        before = sum(os.times()[2:4])
        with distributed.Client(cluster.address) as client:
            used = client.run(lambda: __import__("resource").getrusage(
                __import__("resource").RUSAGE_CHILDREN).ru_utime)
            screening.screen([plant], client=client, outputs=[together])
            after = client.run(lambda: __import__("resource").getrusage(
                __import__("resource").RUSAGE_CHILDREN).ru_utime)
        spent = sum(after.values()) - sum(used.values()) + sum(os.times()[2:4]) - before
    finally:
        cluster.stop()
    print(f"dask: {loops} loops, a worker killed: identical; processor time {spent:.1f} s, one "
          f"process {one_process:.1f} s ({100 * (spent / one_process - 1):+.0f} %), "
          f"{time.time() - begin:.0f} s elapsed")
