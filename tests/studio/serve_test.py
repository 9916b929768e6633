#!/usr/bin/env python3
"""The studio's server from outside: killed at random moments it has lost nothing that it acknowledged; malformed requests,
clients that vanish and wrong pages do it no harm; idle it does nothing.

usage: serve_test.py --seamount PROGRAM [--kills 50] [--malformed 10000]
"""

import argparse
import http.client
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

RECIPE = {"seamount": 1, "domain": {"width_m": 640, "height_m": 640, "cell_m": 10},
          "steps": [{"id": "land", "op": "terrain.noise"}]}
arguments = None


class Studio:
    """A server of its own, in a folder of its own."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        page = self.folder / "page"
        page.mkdir(exist_ok=True)
        (page / "index.html").write_text("<!doctype html><title>page</title>")
        if not (self.folder / "work/r.json").exists():
            (self.folder / "work").mkdir(exist_ok=True)
            (self.folder / "work/r.json").write_text(json.dumps(RECIPE))
        self.process = subprocess.Popen(
            [arguments.seamount, "studio", self.folder / "work/r.json", "--no-browser", "--no-cache", "--state",
             self.folder / "state", "--port", str(free_port())],
            env={**os.environ, "SEAMOUNT_STUDIO": str(page)}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        address = self.process.stdout.readline().strip()
        assert address.startswith("http://"), self.process.stderr.read()
        self.port, self.token = int(address.split(":")[2].split("/")[0]), address.split("#")[1]

    def request(self, method, path, body=None, headers=None, timeout=20):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        sent = {"Authorization": f"Bearer {self.token}", "Content-Type": "application/json"}
        sent.update(headers or {})
        try:
            connection.request(method, path, json.dumps(body) if body is not None else None,
                               {name: value for name, value in sent.items() if value is not None})
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def document(self):
        return json.loads(self.request("GET", "/api/document")[1])

    def memory_kb(self):
        for line in pathlib.Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith("VmRSS"):
                return int(line.split()[1])

    def seconds_of_processor(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        code = self.process.wait(30)
        errors = self.process.stderr.read()
        self.process.stdout.close()
        self.process.stderr.close()
        return code, errors


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class ServeTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def test_nothing_acknowledged_is_lost(self):
        chance = random.Random(1)
        acknowledged = 0  # of the edit that was answered last, and of the one that may have been under way
        asked = 0
        lost = 0
        for _ in range(arguments.kills):
            studio = Studio(self.folder.name)
            document = studio.document()
            value = document["recipe"]["steps"][0].get("params", {}).get("base_m", 0)
            self.assertIn(value, (acknowledged, asked))
            acknowledged = value
            killer = threading.Timer(chance.uniform(0.0, 0.12), studio.process.kill)
            killer.start()
            base = document["revision"]
            try:
                while True:
                    asked = acknowledged + 1
                    status, answer = studio.request("POST", "/api/edits", {
                        "window": "w", "base": base, "gesture": chance.choice(["", "g"]), "label": f"to {asked}",
                        "edits": [{"do": "set", "pointer": "/steps/land/params/base_m", "value": asked}]})
                    self.assertEqual(status, 200, answer)
                    base = json.loads(answer)["revision"]
                    acknowledged = asked
            except (OSError, http.client.HTTPException):
                lost += 1
            killer.join()
            studio.end(signal.SIGKILL)
        self.assertEqual(lost, arguments.kills)
        self.assertGreater(acknowledged, arguments.kills)
        print(f"{arguments.kills} kills, {acknowledged} edits acknowledged, none lost")

    def test_malformed_requests_do_no_harm(self):
        studio = Studio(self.folder.name)
        before = studio.document()
        chance = random.Random(2)
        good = (f"POST /api/edits HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\nAuthorization: Bearer {studio.token}\r\n"
                "Content-Type: application/json\r\nContent-Length: 40\r\n\r\n"
                '{"window":"w","base":1,"edits":[{"do":"}').encode()
        self.spray(studio, good, chance, arguments.malformed // 10)  # what it needs once is there
        memory = studio.memory_kb()
        self.spray(studio, good, chance, arguments.malformed)
        grown = studio.memory_kb() - memory
        self.assertEqual(studio.document(), before)
        self.assertLess(grown, 60000)
        code, errors = studio.end()
        self.assertEqual(code, 0, errors)
        print(f"{arguments.malformed} malformed requests, memory grew by {grown} kB")

    def spray(self, studio, good, chance, count):
        """Requests with a few bytes changed, left out, doubled or cut off, without waiting for what they bring."""
        for _ in range(count):
            bytes_ = bytearray(good)
            for _ in range(chance.randint(1, 6)):
                at = chance.randrange(len(bytes_))
                what = chance.randrange(5)
                if what == 0:
                    bytes_[at] = chance.randrange(256)
                elif what == 1:
                    del bytes_[at:at + chance.randint(1, 40)]
                elif what == 2:
                    bytes_[at:at] = bytes_[at:at + chance.randint(1, 60)]
                elif what == 3:
                    bytes_[at:at] = chance.choice([b"\r\n", b"\0", b"%00", b"../", b"Transfer-Encoding: chunked\r\n", b"A" * 9000,
                                                   b"Range: bytes=0-,0-,0-\r\n", b"Content-Length: 99999999999\r\n"])
                else:
                    del bytes_[at:]
                if not bytes_:
                    bytes_ = bytearray(b"x")
            with socket.socket() as client:
                client.settimeout(5)
                client.connect(("127.0.0.1", studio.port))
                try:
                    client.sendall(bytes_)
                    client.shutdown(socket.SHUT_WR)
                    answer = client.recv(64)
                    self.assertFalse(answer.startswith(b"HTTP/1.1 200"), bytes(bytes_))
                except OSError:
                    pass

    def test_endless_headers_are_cut_off(self):
        studio = Studio(self.folder.name)
        memory = studio.memory_kb()
        for piece in (b"X-More: " + b"y" * 4000 + b"\r\n", b"z" * 4000):  # lines without end, and one such line
            with socket.create_connection(("127.0.0.1", studio.port)) as client:
                client.settimeout(10)
                client.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\n".encode())
                sent = 0
                try:
                    while sent < 100_000_000:
                        client.sendall(piece)
                        sent += len(piece)
                except OSError:
                    pass
                self.assertLess(sent, 20_000_000, "the connection is closed")
        self.assertLess(studio.memory_kb() - memory, 20000)
        self.assertEqual(studio.request("GET", "/api/document")[0], 200)
        self.assertEqual(studio.end()[0], 0)

    def test_clients_that_vanish(self):
        studio = Studio(self.folder.name)
        head = (f"POST /api/upload?name=a.tif HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\nAuthorization: Bearer "
                f"{studio.token}\r\nContent-Type: application/octet-stream\r\nContent-Length: 10000000\r\n\r\n").encode()
        for _ in range(20):
            with socket.create_connection(("127.0.0.1", studio.port)) as client:
                client.sendall(head + b"x" * 100000)
        for window in range(20):  # streams that nobody reads
            with socket.create_connection(("127.0.0.1", studio.port)) as client:
                client.sendall(f"GET /api/events?window={window} HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\n"
                               f"Authorization: Bearer {studio.token}\r\n\r\n".encode())
        time.sleep(0.5)
        self.assertEqual(studio.request("GET", "/api/document")[0], 200)
        left = [path for path in (pathlib.Path(self.folder.name) / "work").rglob("*") if path.is_file()]
        self.assertEqual([path.name for path in left], ["r.json"])
        self.assertEqual(studio.end()[0], 0)

    def test_other_pages_are_refused(self):
        studio = Studio(self.folder.name)
        own = f"127.0.0.1:{studio.port}"
        for headers in ({"Host": "evil.example"}, {"Origin": "http://evil.example"}, {"Origin": "null"},
                        {"Sec-Fetch-Site": "cross-site"}, {"Host": f"{own}.evil.example"}):
            self.assertEqual(studio.request("GET", "/api/document", headers=headers)[0], 403, headers)
        self.assertEqual(studio.request("GET", "/api/document", headers={"Authorization": None})[0], 401)
        self.assertEqual(studio.request("GET", "/api/document", headers={"Origin": f"http://{own}"})[0], 200)
        for path in ("/../etc/passwd", "/..%2f..%2fetc/passwd", "/page/../index.html", "/%2e%2e/r.json", "//etc/passwd"):
            self.assertNotEqual(studio.request("GET", path)[0], 200, path)
        for path in ("../r.json", "/etc/passwd", "%2e%2e/state", "..%2fstate", "a%00b"):
            self.assertNotEqual(studio.request("GET", f"/api/download?path={path}")[0], 200, path)
        connection = http.client.HTTPConnection("127.0.0.1", studio.port)
        connection.request("GET", "/")
        headers = dict(connection.getresponse().getheaders())
        connection.close()
        self.assertIn("frame-ancestors 'none'", headers["Content-Security-Policy"])
        self.assertNotIn("Access-Control-Allow-Origin", headers)
        self.assertEqual(studio.end()[0], 0)

    def test_idle_it_does_nothing(self):
        studio = Studio(self.folder.name)
        studio.request("POST", "/api/want", {"window": "w", "sources": ["land"]})
        time.sleep(1)
        before = studio.seconds_of_processor()
        time.sleep(2)
        self.assertLess(studio.seconds_of_processor() - before, 0.1)
        self.assertEqual(studio.end()[0], 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--seamount", required=True)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--malformed", type=int, default=10000)
    arguments, rest = parser.parse_known_args()
    unittest.main(argv=[__file__, *rest])
