#!/usr/bin/env python3
"""Boots a throw-away Linux in an emulator, runs a script there, exits with its status.

    boot.py MACHINE SCRIPT [FILE=PATH | FILE]...

MACHINE is the folder that `fetch` filled. SCRIPT runs as /test under busybox; every FILE is
there too, in / or at PATH, programs with the shared libraries they need. Everything that the
script prints goes to stdout. Exits 77 where there is no emulator, 1 if the guest hangs.
"""
import gzip
import io
import lzma
import os
import pathlib
import re
import secrets
import shutil
import stat
import subprocess
import sys
import threading


MODULES = """can can-raw can-bcm can-gw can-isotp can-dev vcan configfs gpio-sim industrialio
kfifo_buf industrialio-triggered-buffer i2c-dev i2c-stub ti-adc081c""".split()
PARAMETERS = {"i2c-stub": "chip_addr=0x50,0x51"}
TOOLS = """usr/bin/candump usr/bin/cansend usr/bin/canplayer usr/bin/isotpsend usr/bin/isotprecv
usr/bin/gpioinfo usr/bin/gpiodetect usr/bin/gpioget usr/sbin/i2cset usr/sbin/i2cdetect""".split()
TRIPLETS = {"amd64": "x86_64-linux-gnu", "arm64": "aarch64-linux-gnu"}
SECONDS = 300

INIT = """#!/bin/sh
export PATH=/bin:/sbin:/usr/bin LD_LIBRARY_PATH=/lib
/bin/busybox mkdir -p /proc /sys /dev /tmp
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
mount -t tmpfs tmp /tmp
{insmod}
mount -t configfs none /sys/kernel/config
ip link set lo up
cd /
sh /test </dev/null 2>&1
echo "{tag} $?"
poweroff -f
"""


class Archive:
    """A cpio archive (newc), the form in which the kernel takes its first root."""

    def __init__(self):
        self.out = io.BytesIO()
        self.inode = 0
        self.known = set()

    def add(self, name, mode, data=b""):
        if name in self.known:
            return
        self.known.add(name)
        parent = os.path.dirname(name)
        if parent:
            self.add(parent, stat.S_IFDIR | 0o755)
        self.inode += 1
        fields = [self.inode, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name) + 1, 0]
        head = b"070701" + "".join(f"{f:08X}" for f in fields).encode() + name.encode() + b"\0"
        self.out.write(head + b"\0" * (-len(head) % 4) + data + b"\0" * (-len(data) % 4))

    def finish(self):
        self.add("TRAILER!!!", 0)
        return gzip.compress(self.out.getvalue(), 1)


def libraries(program, machine):
    """(place in the guest, file) of the loader and the shared libraries of a program."""
    triplet = TRIPLETS[arch_of(machine)]
    folders = [*sorted((machine / "root/usr/lib").glob(triplet)),
               *(pathlib.Path(p) for p in (f"/usr/{triplet}/lib", f"/lib/{triplet}",
                                           f"/usr/lib/{triplet}"))]
    waiting, known = [pathlib.Path(program)], set()
    while waiting:
        listed = subprocess.run(["readelf", "-ld", str(waiting.pop())], capture_output=True,
                                text=True, env=dict(os.environ, LC_ALL="C")).stdout
        names = re.findall(r"\(NEEDED\).*\[(.*)\]", listed)
        loader = re.search(r"program interpreter: (\S+)\]", listed)
        for name in names + ([loader.group(1)] if loader else []):
            where = next((f / os.path.basename(name) for f in folders
                          if (f / os.path.basename(name)).exists()), None)
            if name in known or where is None:
                continue
            known.add(name)
            waiting.append(where)
            yield (name.lstrip("/") if "/" in name else "lib/" + name), where


def add_program(archive, name, path, machine):
    archive.add(name, stat.S_IFREG | 0o755, path.read_bytes())
    for place, where in libraries(path, machine):
        archive.add(place, stat.S_IFREG | 0o755, where.read_bytes())


def module_files(machine):
    return {re.sub(r"\.ko(\.xz)?$", "", p.name).replace("-", "_"): p
            for p in (machine / "modules").resolve().rglob("*.ko*")}


def load_order(machine):
    """(name, content) of each module after those it depends on; built-in ones are left out."""
    files, order, seen = module_files(machine), [], set()

    def visit(name):
        key = name.replace("-", "_")
        if key in seen or key not in files:
            return
        seen.add(key)
        data = files[key].read_bytes()
        if files[key].suffix == ".xz":
            data = lzma.decompress(data)
        depends = re.search(rb"\0depends=([^\0]*)\0", data)
        for other in depends.group(1).decode().split(",") if depends else []:
            if other:
                visit(other)
        order.append((name, data))

    for module in MODULES:
        visit(module)
    return order


def make_root(machine, script, files, tag):
    archive = Archive()
    root = machine / "root"
    busybox = next(p for p in (root / "bin/busybox", root / "usr/bin/busybox") if p.exists())
    archive.add("bin/busybox", stat.S_IFREG | 0o755, busybox.read_bytes())
    archive.add("bin/sh", stat.S_IFLNK | 0o777, b"busybox")
    insmod = []
    for name, data in load_order(machine):
        archive.add(f"modules/{name}.ko", stat.S_IFREG | 0o644, data)
        insmod.append(f"insmod /modules/{name}.ko {PARAMETERS.get(name, '')}")
    for tool in TOOLS:
        add_program(archive, "bin/" + os.path.basename(tool), root / tool, machine)
    archive.add("init", stat.S_IFREG | 0o755,
                INIT.format(insmod="\n".join(insmod), tag=tag).encode())
    archive.add("test", stat.S_IFREG | 0o755, pathlib.Path(script).read_bytes())
    for entry in files:
        source, _, place = entry.partition("=")
        path = pathlib.Path(source)
        place = place.lstrip("/") or path.name
        if path.read_bytes()[:4] == b"\x7fELF":
            add_program(archive, place, path, machine)
        else:
            archive.add(place, stat.S_IFREG | 0o644, path.read_bytes())
    return archive.finish()


def arch_of(machine):
    return (machine / "arch").read_text().strip()


def emulator(machine):
    names = {"amd64": ["qemu-system-x86_64", "-M", "q35", "-cpu", "max"],
             "arm64": ["qemu-system-aarch64", "-M", "virt", "-cpu", "cortex-a53"]}
    command = names.get(arch_of(machine))
    return command if command and shutil.which(command[0]) else None


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    machine = pathlib.Path(arguments[0])
    command = emulator(machine)
    if command is None:
        print("vm: no emulator (qemu-system-x86 or qemu-system-arm)", file=sys.stderr)
        return 77
    tag = secrets.token_hex(16)
    initramfs = machine / f"initramfs-{os.getpid()}.gz"
    initramfs.write_bytes(make_root(machine, arguments[1], arguments[2:], tag))
    console = "ttyAMA0" if arch_of(machine) == "arm64" else "ttyS0"
    command += ["-accel", "tcg,thread=multi", "-smp", "2", "-m", "256", "-nodefaults",
                "-display", "none", "-serial", "stdio", "-no-reboot",
                "-kernel", str(machine / "vmlinuz"), "-initrd", str(initramfs),
                "-append", f"console={console} quiet loglevel=0 panic=-1"]
    status = None
    guest = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    try:
        timer = threading.Timer(SECONDS, guest.kill)
        timer.start()
        for raw in guest.stdout:
            line = raw.decode(errors="replace").rstrip()
            match = re.match(tag + r" (\d+)", line)
            if match:
                status = int(match.group(1))
                break
            print(line, flush=True)
    finally:
        timer.cancel()
        guest.kill()
        guest.wait()
        initramfs.unlink()
    if status is None:
        print("vm: the guest ended without a status", file=sys.stderr)
        return 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
