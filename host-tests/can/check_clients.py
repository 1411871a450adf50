#!/usr/bin/env python3
"""The daemon's diagnostics as seen by clients that nobody here wrote.

    check_clients.py STICKBANDD STICKBAND [KEPT_LOG]

Starts the daemon with its slcan backend on a loopback port, feeds a loop, lets scapy's UDS
client (over python-can and scapy's own ISO-TP) ask for every service, `stickband pull` fetch
the recording, and tshark dissect all frames that were seen: nothing may be malformed, and
every service must be named.
Exits 77 where scapy, python-can or tshark is not installed.
"""
import hashlib
import hmac
import math
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import warnings
import zlib

warnings.simplefilter("ignore")
try:
    from scapy.config import conf
    conf.contribs["ISOTP"] = {"use-can-isotp-kernel-module": False}
    conf.contribs["CANSocket"] = {"use-python-can": True}
    import can
    from scapy.contrib.automotive import uds
    from scapy.contrib.cansocket_python_can import PythonCANSocket
    from scapy.contrib.isotp import ISOTPSoftSocket
except ImportError as missing:
    print(f"skipped: needs the Debian packages python3-scapy and python3-can ({missing})")
    sys.exit(77)
if shutil.which("tshark") is None:
    print("skipped: needs the Debian package tshark")
    sys.exit(77)

KEY = bytes(range(32))
CONFIGURATION = """
[gateway]
name = "gw-17"
[bus.lab]
backend = "slcan"
port = {port}
[uds]
bus = "lab"
writes = true
key_file = "uds.key"
[broadcast]
bus = "lab"
[[loop]]
id = 1
tag = "FIC-211"
sample_period_s = 0.01
u = {{ source = "can", bus = "lab", frame_id = 0x18E, start = 7, length = 16, byte_order = "big_endian", scale = 0.01, unit = "%" }}
y = {{ source = "can", bus = "lab", frame_id = 0x18F, start = 7, length = 16, byte_order = "big_endian", scale = 0.01, unit = "%" }}
"""
REQUEST, RESPONSE, FUNCTIONAL = 0x7E0, 0x7E8, 0x7DF


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: expected {wanted!r}, found {found!r}")


class Bus:
    """A plain slcan client: keeps every frame as candump line, sends the loop's frames."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.lines = []
        self.thread = threading.Thread(target=self.listen, daemon=True)
        self.thread.start()

    def listen(self):
        rest = b""
        while data := self.socket.recv(4096):
            *commands, rest = (rest + data).split(b"\r")
            for command in commands:
                self.keep(command.decode())

    def keep(self, command):
        digits = {"t": 3, "T": 8}.get(command[:1])
        if digits is None:
            return
        identifier, payload = command[1:1 + digits], command[2 + digits:]
        length = 2 * int(command[1 + digits])
        self.lines.append(f"({time.time():.6f}) lab {identifier}#{payload[:length]}")

    def send(self, identifier, data):
        line = f"t{identifier:03X}{len(data)}{data.hex().upper()}"
        self.keep(line)
        self.socket.sendall(line.encode() + b"\r")

    def feed(self, seconds):
        for k in range(int(100 * seconds)):
            u = 50 + 10 * math.sin(0.1 * k)
            self.send(0x18E, struct.pack(">H", int(100 * u)))
            self.send(0x18F, struct.pack(">H", int(100 * (u - 5))))
            time.sleep(0.01)


class Client:
    def __init__(self, port):
        self.port = port
        self.physical = self.link(REQUEST)

    def link(self, request_id):
        bus = PythonCANSocket(
            bustype="slcan", channel=f"socket://127.0.0.1:{self.port}", bitrate=500000,
            sleep_after_open=0, can_filters=[{"can_id": RESPONSE, "can_mask": 0x7FF}])
        return ISOTPSoftSocket(bus, tx_id=request_id, rx_id=RESPONSE, basecls=uds.UDS)

    def ask(self, packet, timeout=2):
        """The response, or None."""
        return self.physical.sr1(packet, timeout=timeout, verbose=False)

    def ask_all(self, packet):
        functional = self.link(FUNCTIONAL)
        answer = functional.sr1(packet, timeout=0.3, verbose=False)
        functional.close()
        return answer

    def positive(self, packet):
        answer = self.ask(packet)
        if answer is None:
            sys.exit(f"{packet!r}: expected an answer, found none")
        if answer.service != packet.service + 0x40:
            sys.exit(f"{packet!r}: expected a positive response, found {bytes(answer).hex()}")
        return answer

    def refused(self, packet, code):
        answer = self.ask(packet)
        if answer is None:
            sys.exit(f"{packet!r}: expected NRC {code:02X}, found no answer")
        expect(repr(packet), bytes(answer), bytes([0x7F, packet.service, code]))


def read(client, did):
    answer = client.positive(uds.UDS() / uds.UDS_RDBI(identifiers=[did]))
    expect("dataIdentifier", answer.dataIdentifier, did)
    return bytes(answer)[3:]


def check_reading(client):
    expect("F18C", read(client, 0xF18C), b"gw-17")
    expect("F186", read(client, 0xF186), b"\x01")
    expect("tag", read(client, 0xFD11), b"FIC-211".ljust(32, b"\0"))
    directory = read(client, 0xFD01)
    for at in range(0, len(directory), 4):
        did, length = struct.unpack_from(">HH", directory, at)
        if did not in (0xFD17, 0xFD19):  # as long as their content
            expect(f"length of {did:04X}", len(read(client, did)), length)
    both = client.positive(uds.UDS() / uds.UDS_RDBI(identifiers=[0xFD10, 0xF195]))
    expect("two at once", bytes(both)[23:25], b"\xF1\x95")
    client.refused(uds.UDS() / uds.UDS_RDBI(identifiers=[0x1234]), 0x31)


def check_sessions(client):
    client.positive(uds.UDS() / uds.UDS_TP(subFunction=0))
    answer = client.positive(uds.UDS() / uds.UDS_DSC(diagnosticSessionType=3))
    expect("P2 and P2*", bytes(answer), bytes.fromhex("5003003201F4"))
    expect("F186", read(client, 0xF186), b"\x03")
    silent = client.ask(uds.UDS() / uds.UDS_TP(subFunction=0x80), timeout=0.2)
    expect("tester present without response", silent, None)
    for packet in (uds.UDS() / uds.UDS_RDBI(identifiers=[0x1234]),
                   uds.UDS() / uds.UDS_CC(controlType=0)):
        expect("functional refusal", client.ask_all(packet), None)
    expect("functional", bytes(client.ask_all(uds.UDS() / uds.UDS_TP(subFunction=0))),
           b"\x7E\x00")
    client.refused(uds.UDS() / uds.UDS_CC(controlType=0), 0x11)


def check_writing(client):
    parameters = bytes([0, 3, 0, 9, 0, 100, 4, 3, 0, 1])
    write = uds.UDS() / uds.UDS_WDBI(dataIdentifier=0xFD15) / parameters
    client.positive(uds.UDS() / uds.UDS_DSC(diagnosticSessionType=1))
    client.refused(write, 0x7F)
    client.positive(uds.UDS() / uds.UDS_DSC(diagnosticSessionType=3))
    client.refused(write, 0x33)
    wrong = uds.UDS() / uds.UDS_SA(securityAccessType=2, securityKey=bytes(16))
    seed = client.positive(uds.UDS() / uds.UDS_SA(securityAccessType=1)).securitySeed
    expect("seed", len(seed), 16)
    client.refused(wrong, 0x35)
    seed = client.positive(uds.UDS() / uds.UDS_SA(securityAccessType=1)).securitySeed
    key = hmac.new(KEY, bytes(seed), hashlib.sha256).digest()[:16]
    client.positive(uds.UDS() / uds.UDS_SA(securityAccessType=2, securityKey=key))
    client.positive(write)
    expect("parameters", read(client, 0xFD15), parameters)


def check_routines(client):
    """Unlocked in the extended session, as check_writing() leaves it."""
    start = uds.UDS_RC(routineControlType=1, routineIdentifier=0xF002)
    client.positive(uds.UDS() / start / bytes([1, 4]))
    time.sleep(0.2)
    expect("simulated verdict and NE107", read(client, 0xFD10)[:2], b"\x04\x02")
    client.positive(uds.UDS() / uds.UDS_RC(routineControlType=2, routineIdentifier=0xF002))
    client.positive(uds.UDS() / uds.UDS_RC(routineControlType=1, routineIdentifier=0xF001)
                    / bytes([1]))
    client.refused(uds.UDS() / uds.UDS_RC(routineControlType=1, routineIdentifier=0xF001)
                   / bytes([2]), 0x31)


def check_upload(client):
    answer = client.positive(uds.UDS() / uds.UDS_RU(
        dataFormatIdentifier=0, memorySizeLen=4, memoryAddressLen=4, memoryAddress4=1,
        memorySize4=0xFFFFFFFF))
    longest = struct.unpack(">H", bytes(answer)[2:4])[0]
    image, counter = b"", 1
    while True:
        block = client.ask(uds.UDS() / uds.UDS_TD(blockSequenceCounter=counter & 0xFF), timeout=5)
        if block is None or block.service != 0x76:
            break
        expect("counter", block.blockSequenceCounter, counter & 0xFF)
        image += bytes(block)[2:]
        counter += 1
        if len(bytes(block)) < longest:
            break
    end = client.positive(uds.UDS() / uds.UDS_RTE())
    expect("CRC-32", bytes(end)[1:], struct.pack(">I", zlib.crc32(image)))
    magic, version, loop, _, _, samples = struct.unpack_from(">4sBBBBI", image)
    expect("header", (magic, version, loop), (b"SBRW", 1, 1))
    expect("length", len(image), 24 + 12 * samples)
    if samples < 100:
        sys.exit(f"recording: expected over 100 samples, found {samples}")
    # u and y arrive one after the other: a sample may fall in between.
    pairs = [struct.unpack_from(">ff", image, 24 + 12 * k) for k in range(samples)]
    right = sum(abs(u - y - 5) < 0.02 for u, y in pairs)
    if right < 0.5 * samples:
        sys.exit(f"recording: expected u - y = 5 in most of {samples} samples, found {right}")
    return samples


def check_pull(stickband, port, folder):
    """Our own client gets the recording, and refusals end it with a message."""
    def pull(loop):
        return subprocess.run([stickband, "pull", "--can", f"slcan:{port}", "--loop", loop, "-o",
                               str(folder / "pulled.csv")], capture_output=True, text=True)
    done = pull("1")
    expect("stickband pull " + done.stderr, done.returncode, 0)
    rows = (folder / "pulled.csv").read_text().splitlines()
    expect("header of the CSV file", rows[0], "t,u,y")
    if len(rows) < 100 or not done.stdout.startswith("FIC-211: "):
        sys.exit(f"stickband pull: expected FIC-211 and 100 samples, found {done.stdout}")
    refused = pull("2")
    if refused.returncode != 1 or "NRC 31" not in refused.stderr:
        sys.exit(f"stickband pull --loop 2: expected NRC 31, found {refused.stderr}")


def check_dtcs(client):
    answer = client.positive(uds.UDS() / uds.UDS_RDTCI(reportType=0x0A))
    dtcs = bytes(answer)[3:]
    expect("supported DTCs", len(dtcs), 4 * 8)
    expect("first DTC", dtcs[:3].hex(), "510118")
    client.positive(uds.UDS() / uds.UDS_RDTCI(reportType=1, DTCStatusMask=0xFF))
    client.positive(uds.UDS() / uds.UDS_RDTCI(reportType=2, DTCStatusMask=0x08))
    client.positive(uds.UDS() / uds.UDS_RDTCI(
        reportType=4, DTCHighByte=0x51, DTCMiddleByte=1, DTCLowByte=0x87,
        DTCSnapshotRecordNumber=0xFF))
    client.positive(uds.UDS() / uds.UDS_RDTCI(
        reportType=6, DTCHighByte=0x51, DTCMiddleByte=1, DTCLowByte=0x87,
        DTCExtendedDataRecordNumber=1))
    client.positive(uds.UDS() / uds.UDS_CDTCI(groupOfDTCHighByte=0xFF, groupOfDTCMiddleByte=0xFF,
                                              groupOfDTCLowByte=0xFF))


def slowest_ms(lines):
    """From a request of one frame to the first frame of its answer, as seen on the bus."""
    slowest, asked = 0.0, None
    for line in lines:
        stamp, _, frame = line.split()
        if frame.startswith(f"{REQUEST:03X}#0") and "#023E80" not in frame:
            asked = float(stamp[1:-1])
        elif frame.startswith(f"{RESPONSE:03X}#") and asked is not None:
            slowest, asked = max(slowest, 1000 * (float(stamp[1:-1]) - asked)), None
    return slowest


def check_dissection(lines, log):
    """tshark's view: no frame malformed, every service recognised in both directions."""
    names = {f"{identifier:03X}#" for identifier in (REQUEST, RESPONSE, FUNCTIONAL)}
    lines = [line for line in lines if line.split()[2][:4] in names]
    log.write_text("".join(line + "\n" for line in lines))
    shark = ["tshark", "-r", str(log), "-d", "can.subdissector,iso15765",
             "-d", "iso15765.subdissector,uds"]
    text = subprocess.run(shark + ["-V"], capture_output=True, text=True).stdout
    for bad in ("Malformed", "Dissector bug"):
        if bad in text:
            sys.exit(f"tshark: {bad} in {log}")
    fields = subprocess.run(shark + ["-Y", "uds", "-T", "fields", "-e", "uds.sid",
                                     "-e", "uds.reply"],
                            capture_output=True, text=True).stdout.split("\n")
    requests = {int(line.split("\t")[0], 16) for line in fields if line.split("\t")[0]}
    wanted = {0x10, 0x14, 0x19, 0x22, 0x27, 0x2E, 0x31, 0x35, 0x36, 0x37, 0x3E}
    if not wanted <= requests:
        sys.exit(f"tshark: expected services {wanted}, found {requests}")
    return len(lines), len(fields)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def connect(port, daemon):
    for _ in range(100):
        try:
            return Bus(port)
        except ConnectionRefusedError:
            if daemon.poll() is not None:
                sys.exit(f"stickbandd ended with {daemon.returncode}: {daemon.stderr.read()}")
            time.sleep(0.05)
    sys.exit("stickbandd: expected to listen within 5 s")


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder_name:
        folder = pathlib.Path(folder_name)
        port = free_port()
        (folder / "uds.key").write_text(KEY.hex() + "\n")
        (folder / "uds.key").chmod(0o600)
        (folder / "gateway.toml").write_text(CONFIGURATION.format(port=port))
        daemon = subprocess.Popen([arguments[0], "--config", str(folder / "gateway.toml")],
                                  stderr=subprocess.PIPE, text=True)
        try:
            bus = connect(port, daemon)
            bus.feed(2)
            client = Client(port)
            check_reading(client)
            check_sessions(client)
            samples = check_upload(client)  # writing starts the recording anew
            check_pull(arguments[1], port, folder)
            check_writing(client)
            check_routines(client)
            check_dtcs(client)
        finally:
            daemon.terminate()
            daemon.wait(10)
        log = pathlib.Path(arguments[2]) if len(arguments) == 3 else folder / "seen.log"
        frames, messages = check_dissection(bus.lines, log)
    print(f"scapy: every service answered, {samples} samples uploaded, slowest answer "
          f"{slowest_ms(bus.lines):.1f} ms; tshark: {frames} frames, "
          f"{messages} messages, none malformed")
    return 0


if __name__ == "__main__":
    status = 1
    try:
        status = main(sys.argv[1:])
    except SystemExit as complaint:
        print(complaint.code)
    sys.stdout.flush()
    os._exit(status)  # scapy's threads would go on reading from the closed bus
