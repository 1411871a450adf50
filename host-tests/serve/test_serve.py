#!/usr/bin/env python3
"""`stickband serve` over HTTP: from a recording to the explained model, and what is refused.

    test_serve.py STICKBAND [TEST...]
"""
import http.client
import json
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

STICKBAND = sys.argv[1]
PATIENCE_S = 60


class Served:
    """A running `stickband serve`; ends with the block."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([STICKBAND, "serve", *arguments], text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        line = self.process.stdout.readline()
        match = re.search(r"http://127\.0\.0\.1:(\d+)/", line)
        if not match:
            raise AssertionError(f"no address in {line!r}: {self.process.communicate()}")
        self.port = int(match.group(1))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def ask(self, method, path, body=None, headers=None):
        """(status, headers, body) of one request as a program sends it."""
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", data=body,
                                         method=method, headers=headers or {})
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE_S) as response:
                return response.status, response.headers, response.read()
        except urllib.error.HTTPError as error:
            return error.code, error.headers, error.read()

    def get(self, path):
        status, _, body = self.ask("GET", path)
        return status, json.loads(body)

    def post(self, path, body=b""):
        """Posts, waits until what it started is done, returns the answer."""
        status, _, answer = self.ask("POST", path, body)
        self.wait()
        return status, json.loads(answer)

    def wait(self):
        end = time.monotonic() + PATIENCE_S
        while True:
            state = self.get("/api/state")[1]
            if state["job"] is None:
                return state
            if time.monotonic() > end:
                raise AssertionError(f"still under way: {state['job']}")
            time.sleep(0.02)


class ServeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.csv = cls.path("loop.csv")
        cls.run_program("simulate", "stiction-setpoint", "--seed", "2", "-o", cls.csv)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return str(pathlib.Path(cls.folder.name) / name)

    @staticmethod
    def run_program(*arguments):
        return subprocess.run([STICKBAND, *arguments], capture_output=True, text=True,
                              timeout=PATIENCE_S)

    def test_from_a_recording_to_the_explained_model(self):
        with Served("--port", "0") as served:
            self.assertIsNone(served.wait()["recording"])
            recording = pathlib.Path(self.csv).read_bytes()
            status, _ = served.post("/api/recording?name=loop.csv", recording)
            self.assertEqual(status, 202)
            _, before = served.get("/api/compare")
            self.assertEqual(before["effects"], [])
            self.assertTrue(before["failures"])
            self.assertEqual(served.post("/api/explain")[0], 202)
            _, explained = served.get("/api/explain")
            best = explained["candidates"][0]
            self.assertEqual((best["effect"], best["status"]), ("valve.stiction", "accepted"))
            added = json.dumps({"effect": best["effect"], "with": best["with"]}).encode()
            self.assertEqual(served.post("/api/add", added)[0], 202)
            _, after = served.get("/api/compare")
            self.assertLess(after["rmse_validation"], 0.5 * before["rmse_validation"])
            self.assertAlmostEqual(after["rmse_validation"], best["rmse_validation_after"],
                                   delta=0.05 * after["rmse_validation"])
            served.post("/api/explain")
            _, headers, report = served.ask("GET", "/api/report")
            self.assertIn("loop.report.html", headers["Content-Disposition"])
            self.assertIn(b"</html>", report)
            model = self.path("page.json")
            pathlib.Path(model).write_bytes(served.ask("GET", "/api/model")[2])
            again = self.run_program("compare", self.csv, "--model", model, "--json")
            self.assertEqual(json.loads(again.stdout), after)

    def test_answers_as_the_command_line_does(self):
        model = self.path("m.json")
        self.run_program("model", self.csv, "-o", model)
        with Served(self.csv, "--port", "0") as served:
            served.wait()
            served.post("/api/explain")
            for command in ("compare", "explain"):
                told = self.run_program(command, self.csv, "--model", model, "--json")
                answer = json.loads(told.stdout)
                answer.pop("identify", None)  # the page asks for its verdict by itself
                self.assertEqual(served.get(f"/api/{command}")[1], answer)

    def test_serves_a_page_that_needs_nothing_else(self):
        with Served("--port", "0") as served:
            status, headers, page = served.ask("GET", "/")
            self.assertEqual(status, 200)
            self.assertIn("text/html", headers["Content-Type"])
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
            links = re.findall(r'(?:src|href)="([^"]*)"', page.decode())
            for link in [*links, "/api.js", "/charts.js"]:
                self.assertTrue(link.startswith("/"), link)
                if not link.startswith("/api/"):
                    self.assertEqual(served.ask("GET", link)[0], 200, link)
            self.assertEqual(served.ask("GET", "/../etc/passwd")[0], 404)
            self.assertEqual(served.ask("GET", "/none")[0], 404)

    def test_keeps_connections_open_and_ends_at_once_all_the_same(self):
        with Served("--port", "0") as served:
            held = [http.client.HTTPConnection("127.0.0.1", served.port) for _ in range(12)]
            for connection in held:
                for _ in range(20):
                    connection.request("GET", "/app.js")
                    answer = connection.getresponse()
                    answer.read()
                    self.assertFalse(answer.will_close)
            began = time.monotonic()
            served.process.send_signal(signal.SIGINT)
            self.assertEqual(served.process.wait(timeout=30), 0)
            self.assertLess(time.monotonic() - began, 2)  # they would stay for 5 s

    def test_wastes_no_time_on_compression(self):
        with Served(self.csv, "--port", "0") as served:
            served.wait()
            for path in ("/api/signals", "/uplot/uPlot.iife.min.js"):
                _, headers, body = served.ask("GET", path, headers={"Accept-Encoding": "br, gzip"})
                self.assertIsNone(headers["Content-Encoding"], path)
                self.assertEqual(int(headers["Content-Length"]), len(body), path)

    def test_refuses_other_names_and_other_sites(self):
        with Served(self.csv, "--port", "0") as served:
            served.wait()
            here = f"127.0.0.1:{served.port}"
            for path in ("/", "/api/state", "/api/model"):
                status, _, body = served.ask("GET", path, headers={"Host": "evil.example"})
                self.assertEqual(status, 403, path)
                self.assertIn(here, json.loads(body)["error"]["message"])
            for origin in ("http://evil.example", "null", "http://127.0.0.1:1"):
                status, _, _ = served.ask("POST", "/api/explain", b"",
                                          {"Origin": origin, "Content-Type": "text/plain"})
                self.assertEqual(status, 403, origin)
            self.assertIsNone(served.wait()["explained"])
            status, headers, _ = served.ask("POST", "/api/explain", b"",
                                            {"Origin": f"http://{here}"})
            self.assertEqual(status, 202)
            self.assertIsNone(headers["Access-Control-Allow-Origin"])
            served.wait()

    def test_listens_on_this_machine_only(self):
        with Served("--port", "0") as served:
            listening = pathlib.Path("/proc/net/tcp").read_text()
            port = f"{served.port:04X}"
            self.assertIn(f"0100007F:{port} ", listening)
            self.assertNotIn(f"00000000:{port} 00000000", listening)

    def test_bad_bodies_are_refused_with_the_reason(self):
        with Served("--port", "0") as served:
            status, answer = served.post("/api/recording?name=bad.csv",
                                         b"t,u,y\n0,1,2\n1,abc,3\n")
            self.assertEqual(status, 400)
            error = answer["error"]
            self.assertEqual((error["file"], error["line"], error["column"]),
                             ("bad.csv", 3, 3))
            # What curl and urllib send by default is no form here.
            status, _, body = served.ask("POST", "/api/recording", b"t,u,y\n" + b"1,2\n" * 9000)
            self.assertEqual((status, json.loads(body)["error"]["line"]), (400, 2))
            form = b'--x\r\nContent-Disposition: form-data; name="f"\r\n\r\n1\r\n--x--\r\n'
            status, _, _ = served.ask("POST", "/api/recording", form,
                                      {"Content-Type": "multipart/form-data; boundary=x"})
            self.assertEqual(status, 415)
            self.assertEqual(served.post("/api/add", b"{]")[0], 400)
            self.assertEqual(served.ask("DELETE", "/api/model")[0] // 100, 4)

    def test_a_body_without_end_is_refused(self):
        with Served("--port", "0") as served:
            connection = http.client.HTTPConnection("127.0.0.1", served.port,
                                                    timeout=PATIENCE_S)
            connection.putrequest("POST", "/api/recording")
            connection.putheader("Content-Length", str(10**12))
            connection.endheaders()
            response = connection.getresponse()
            self.assertEqual(response.status, 413)
            self.assertIn("MiB", json.loads(response.read())["error"]["message"])
            connection.close()
            self.assertEqual(served.get("/api/state")[0], 200)

    def test_a_body_in_pieces_is_capped_while_it_is_read(self):
        with Served("--port", "0") as served:
            piece = b"1,2,3\n" * 20000
            head = b"%x\r\n" % len(piece)
            connection = http.client.HTTPConnection("127.0.0.1", served.port,
                                                    timeout=PATIENCE_S)
            connection.putrequest("POST", "/api/recording")
            connection.putheader("Transfer-Encoding", "chunked")
            connection.endheaders()
            for _ in range(2**30 // len(piece)):
                connection.send(head + piece + b"\r\n")
            connection.send(b"0\r\n\r\n")
            response = connection.getresponse()
            self.assertEqual(response.status, 413)
            self.assertIn("MiB", json.loads(response.read())["error"]["message"])
            connection.close()
            status = pathlib.Path(f"/proc/{served.process.pid}/status").read_text()
            peak_kb = int(re.search(r"VmHWM:\s+(\d+)", status).group(1))
            self.assertLess(peak_kb, 150_000)
            self.assertEqual(served.get("/api/state")[0], 200)

    def test_a_post_without_length_is_empty(self):
        with Served("--port", "0") as served:
            with socket.create_connection(("127.0.0.1", served.port), PATIENCE_S) as raw:
                raw.sendall(f"POST /api/cancel HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n"
                            "Connection: close\r\n\r\n".encode())
                self.assertIn(b" 200 ", raw.makefile("rb").readline())

    def test_nonsense_does_not_end_it(self):
        with Served("--port", "0") as served:
            for nonsense in (b"\r\n\r\n", b"GARBAGE\r\n\r\n", b"\x00\xff" * 50 + b"\r\n\r\n",
                             b"GET / HTTP/1.1\r\n", b""):
                with socket.create_connection(("127.0.0.1", served.port), PATIENCE_S) as raw:
                    raw.sendall(nonsense)
            self.assertEqual(served.get("/api/state")[0], 200)

    def test_a_port_in_use_is_said_and_another_is_found(self):
        with Served("--port", "0") as served:
            taken = self.run_program("serve", "--port", str(served.port))
            self.assertEqual(taken.returncode, 1)
            self.assertIn(f"port {served.port}", taken.stderr)
            self.assertIn("--port", taken.stderr)
        with Served() as first, Served() as second:
            self.assertNotEqual(first.port, second.port)

    def test_wrong_usage_and_bad_recordings_end_it_at_once(self):
        for port in ("-1", "65536", "http", "1.5", ""):
            self.assertEqual(self.run_program("serve", "--port", port).returncode, 2, port)
        for words in (("--ts", "1"), ("--output", "x"), ("--u", "M.S")):
            outcome = self.run_program("serve", *words)
            self.assertEqual(outcome.returncode, 2, words)
            self.assertIn("REC", outcome.stderr)
        bad = pathlib.Path(self.path("bad.csv"))
        bad.write_text("t,u,y\n0,1,2\n1,abc,3\n")
        short = pathlib.Path(self.path("short.csv"))
        short.write_text("t,u,y\n0,1,2\n1,2,3\n2,3,1\n")
        for file, where, code in ((bad, f"{bad}:3:3:", 3), (short, "short.csv", 4),
                                  (self.path("none.csv"), "none.csv", 3)):
            outcome = self.run_program("serve", str(file), "--port", "0")
            self.assertEqual(outcome.returncode, code, outcome.stderr)
            self.assertIn(where, outcome.stderr)
            self.assertEqual(outcome.stdout, "")

    def test_ends_cleanly_even_while_it_works(self):
        for way in (signal.SIGINT, signal.SIGTERM):
            with Served(self.csv, "--port", "0") as served:
                served.wait()
                served.ask("POST", "/api/ladder", b"")
                served.process.send_signal(way)
                self.assertEqual(served.process.wait(timeout=30), 0)
                self.assertEqual(served.process.stderr.read(), "")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
