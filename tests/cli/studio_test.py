#!/usr/bin/env python3
"""The studio's server, without a browser: access, edits, and recovery.

    studio_test.py PROGRAM TEMPLATES
"""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from studio_server import Studio  # noqa: E402

PROGRAM, TEMPLATES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


class WithAFruit(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        for name in ("cherry.toml", "cherry.svg"):
            shutil.copy(TEMPLATES / name, self.folder)

    def studio(self, *words):
        studio = Studio(PROGRAM, *(words or ("cherry.toml",)), folder=self.folder)
        self.addCleanup(studio.__exit__)
        return studio

    def wider(self, studio):
        """The texts of a larger cherry, and the version before them."""
        document = studio.json("/api/document")
        svg = document["svg"].replace('label="scale 24mm"', 'label="scale 25mm"')
        self.assertNotEqual(svg, document["svg"])
        return {"seen": document["version"], "toml": document["toml"], "svg": svg}


class Strangers(WithAFruit):
    def setUp(self):
        super().setUp()
        self.server = self.studio()
        self.host = f"127.0.0.1:{self.server.port}"

    def refused(self, status, *args, **kwargs):
        got, body = self.server.ask(*args, **kwargs)
        self.assertEqual(got, status, body[:200])
        self.assertTrue(json.loads(body)["errors"][0]["message"])

    def test_only_who_has_the_token_is_answered(self):
        for path in ("/", "/?token=", "/?token=" + "0" * 32, "/?token=" + self.server.token[:-1], "/?token=" + self.server.token + "0"):
            self.refused(403, path, headers={"X-Pomona-Token": None})
        self.refused(403, "/api/document", headers={"X-Pomona-Token": "0" * 32})
        self.refused(403, "/api/document?token=" + self.server.token, headers={"X-Pomona-Token": None})
        self.assertEqual(self.server.ask("/?token=" + self.server.token, headers={"X-Pomona-Token": None})[0], 200)

    def test_no_other_origin_and_no_other_name_of_this_machine(self):
        for origin in ("http://evil.example", "null", "http://127.0.0.1:1", "http://localhost:" + str(self.server.port)):
            self.refused(403, "/api/document", headers={"Origin": origin})
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=10) as wire:
            wire.sendall(f"GET /api/document HTTP/1.1\r\nHost: {self.host}\r\nX-Pomona-Token: {self.server.token}\r\n"
                         f"Origin: http://{self.host}\r\nOrigin: http://evil.example\r\n\r\n".encode())
            self.assertIn(b" 403 ", wire.recv(4096))
        for host in ("evil.example", "localhost:" + str(self.server.port), "127.0.0.1", "127.0.0.1:1"):
            self.refused(421, "/api/document", headers={"Host": host})
        self.assertEqual(self.server.ask("/api/document", headers={"Origin": "http://" + self.host})[0], 200)

    def test_no_name_of_a_fruit_shows_the_token_or_is_a_mark(self):
        for name in ("@TOKEN@", "@SCRIPT@", "@NONCE@"):
            shutil.copy(self.folder / "cherry.toml", self.folder / f"{name}.toml")
            studio = self.studio(f"./{name}.toml")
            page = studio.ask("/?token=" + studio.token)[1].decode()
            self.assertTrue(f"<title>{name} " in page, page[:600])
            self.assertEqual(page.count(studio.token), 1, "the page holds the token where its script reads it")
            self.assertEqual(page.count("<script"), 3)

    def test_it_listens_on_the_loopback_address_alone(self):
        listening = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
        port = f"{self.server.port:04X}"
        self.assertEqual([row[1] for row in listening if row[3] == "0A" and row[1].endswith(":" + port)], [f"0100007F:{port}"])

    def test_other_methods_kinds_and_lengths_of_bodies(self):
        self.refused(405, "/api/save", method="PUT", body=b"{}")
        self.refused(405, "/api/document", method="DELETE")
        for kind in ("text/plain", "application/jsonfoo", "application/json, text/plain"):
            self.refused(415, "/api/save", body=b"{}", headers={"Content-Type": kind})
        self.refused(400, "/api/save", body=b"[1]", headers={"Content-Type": "application/json; charset=utf-8"})
        self.refused(411, "/api/save", body=b"{}", headers={"Content-Encoding": "gzip"})
        self.refused(400, "/api/save", body=b"[1]")
        self.refused(400, "/api/section", body={"toml": "", "svg": "", "size": 1e9})
        self.refused(400, "/api/section", body=b"[" * 100000)
        self.refused(404, "/api/nothing")
        self.refused(414, "/" + "a" * 200)

    def test_a_huge_body_is_refused_before_it_is_sent(self):
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=10) as wire:
            wire.sendall(f"POST /api/change HTTP/1.1\r\nHost: {self.host}\r\nX-Pomona-Token: {self.server.token}\r\n"
                         "Content-Type: application/json\r\nContent-Length: 99000000000\r\n\r\n{".encode())
            self.assertIn(b" 413 ", wire.recv(4096))

    def test_a_slow_client_is_dropped_and_others_are_served_meanwhile(self):
        slow = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(8)]
        for wire in slow:
            wire.sendall(b"GET /api/document HT")
        began = time.monotonic()
        self.server.json("/api/state")
        self.assertLess(time.monotonic() - began, 3)
        self.assertIn(slow[0].recv(100)[:1], (b"", b"H"))  # closed, or told that it was too slow
        self.assertLess(time.monotonic() - began, 12)
        for wire in slow:
            wire.close()

    def test_any_number_of_slow_clients_keeps_nobody_out(self):
        slow = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(240)]
        for wire in slow:
            wire.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n")
        began = time.monotonic()
        for k in range(3):  # a line each second, from all of them: none is ever silent for long
            self.server.json("/api/state")
            self.assertLess(time.monotonic() - began, k + 1)
            time.sleep(max(0, k + 1 - (time.monotonic() - began)))
            for wire in slow:
                with contextlib.suppress(OSError):
                    wire.sendall(b"X: y\r\n")
        last = slow[-1]
        with contextlib.suppress(ConnectionError):
            while time.monotonic() - began < 9 and last.recv(100):
                pass
        self.assertLess(time.monotonic() - began, 8, "who sends slowly has five seconds for the whole head")
        for wire in slow:
            wire.close()

    def test_any_number_of_slow_bodies_keeps_nobody_out(self):
        slow = [socket.create_connection(("127.0.0.1", self.server.port), timeout=20) for _ in range(60)]
        for wire in slow:
            wire.sendall(f"POST /api/change HTTP/1.1\r\nHost: {self.host}\r\nX-Pomona-Token: {self.server.token}\r\n"
                         "Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n{".encode())
        time.sleep(0.5)
        began = time.monotonic()
        self.server.json("/api/state")
        self.assertLess(time.monotonic() - began, 3)
        replies = []
        for wire in slow:
            wire.settimeout(0.1)
            with contextlib.suppress(OSError):
                replies.append(wire.recv(100)[:12])
            wire.close()
        self.assertIn(b"HTTP/1.1 503", replies)

    def test_a_head_without_end_is_not_kept(self):
        with socket.create_connection(("127.0.0.1", self.server.port), timeout=10) as wire, self.assertRaises(OSError):
            for _ in range(1000):
                wire.sendall(b"X: " + 1000 * b"y" + b"\r\n")
                time.sleep(0.001)

    def most_memory(self):
        """Peak memory of the studio so far, bytes."""
        status = pathlib.Path(f"/proc/{self.server.process.pid}/status").read_text()
        return 1024 * int(next(line for line in status.splitlines() if line.startswith("VmHWM")).split()[1])

    @unittest.skipIf("SANITIZED" in os.environ, "sanitizers keep what is freed")
    def test_a_request_takes_little_more_memory_than_it_has_bytes(self):
        self.server.json("/api/document")
        for body in (b"[" + 4_000_000 * b"[]," + b"0]", b'{"toml": {' + b",".join(b'"%d":0' % i for i in range(1_200_000)) + b"}}",
                     b"{" + b",".join(b'"%d":0' % i for i in range(1_200_000)) + b"}", 12_000_000 * b"["):
            before = self.most_memory()
            self.refused(400, "/api/change", body=body)
            self.assertLess(self.most_memory() - before, 4 * len(body) + (8 << 20), body[:10])

    def test_a_million_mistakes_take_little_more_than_their_text(self):
        document = self.server.json("/api/document")
        before = self.most_memory()
        toml = "".join(f"a{i}=0\n" for i in range(1_000_000))
        status, told = self.server.ask("/api/section", {"toml": document["toml"] + toml, "svg": document["svg"]})
        self.assertEqual(status, 422)
        self.assertLess(len(told), 1 << 20)
        self.assertLess(self.most_memory() - before, 512 << 20)

    def test_edits_are_kept_while_fruit_are_grown(self):
        document = self.server.json("/api/document")
        asked = [threading.Thread(target=self.server.ask, daemon=True, args=("/api/section", {
            "toml": document["toml"], "svg": document["svg"], "final": True, "detail": 0.5, "seed": k, "size": 64})) for k in range(40)]
        for one in asked:
            one.start()
        time.sleep(0.3)
        began = time.monotonic()
        self.server.json("/api/change", {"seen": document["version"], "toml": document["toml"] + "# more\n", "svg": document["svg"]})
        self.assertLess(time.monotonic() - began, 1.5)
        for one in asked:
            one.join()

    def test_only_pictures_beside_the_template_are_given_out(self):
        (self.folder / "photo.png").write_bytes(b"\x89PNG\r\n\x1a\n....")
        (self.folder / "secret.png").write_bytes(b"not a picture")
        (self.folder / "way_out.png").symlink_to("/etc/passwd")
        self.assertEqual(self.server.ask("/api/picture?href=photo.png")[0], 200)
        for href in ("secret.png", "way_out.png", "../photo.png", "%2e%2e/photo.png", "/etc/passwd", "cherry.svg", "", ".", "%00"):
            self.refused(404, "/api/picture?href=" + href)

    def test_the_page_asks_nobody_else(self):
        page = self.server.ask("/?token=" + self.server.token)[1].decode()
        # Names of XML vocabularies are not fetched.
        addresses = set(__import__("re").findall(r"https?://[\w.]+", page))
        self.assertLessEqual(addresses, {"http://www.w3.org"})


class Edits(WithAFruit):
    def test_what_is_saved_is_what_cut_and_grow_make_to_the_byte(self):
        studio = self.studio()
        edit = self.wider(studio)
        studio.json("/api/change", edit)
        seen = studio.json("/api/state")["version"]
        texts = {"toml": edit["toml"], "svg": edit["svg"]}
        studio.ask("/api/section", {**texts, "seed": 9, "ripeness": 1.5, "final": True, "size": 32})  # another of these texts
        status, asset = studio.ask("/api/asset", {**texts, "seed": 3, "ripeness": 0.5, "final": True})
        self.assertEqual(status, 200)
        studio.json("/api/save", {"seen": seen})
        self.assertEqual((self.folder / "cherry.svg").read_text(), edit["svg"])
        subprocess.run([PROGRAM, "grow", "cherry.toml", "--seed", "3", "--ripeness", "0.5", "-o", "out.pomona", "--quiet"], cwd=self.folder, check=True)
        self.assertEqual((self.folder / "out.pomona").read_bytes(), asset)
        self.assertFalse((self.folder / "cherry.toml.unsaved").exists())

    def test_a_quick_answer_holds_what_the_slow_one_holds(self):
        import zlib
        studio = self.studio()
        document = studio.json("/api/document")
        _, asset = studio.ask("/api/asset", {"toml": document["toml"], "svg": document["svg"]})
        subprocess.run([PROGRAM, "grow", "cherry.toml", "--quality", "draft", "-o", "out.pomona", "--quiet"], cwd=self.folder, check=True)
        self.assertEqual(zlib.decompress(asset[8:]), zlib.decompress((self.folder / "out.pomona").read_bytes()[8:]))

    def test_edits_survive_a_kill(self):
        studio = self.studio()
        edit = self.wider(studio)
        studio.json("/api/change", edit)
        studio.end("kill")
        again = self.studio()
        document = again.json("/api/document")
        self.assertTrue(document["recovered"] and document["unsaved"])
        self.assertFalse(document["changed_outside"], "no other program has changed anything")
        self.assertEqual(document["svg"], edit["svg"])
        self.assertNotEqual((self.folder / "cherry.svg").read_text(), edit["svg"])
        again.json("/api/revert", {"seen": document["version"]})
        self.assertFalse((self.folder / "cherry.toml.unsaved").exists())

    def test_edits_of_a_long_sketch_survive_a_kill_too(self):
        studio = self.studio()
        edit = self.wider(studio)
        edit["svg"] += "<!--" + 13 * 2**20 * "x" + "-->"
        studio.json("/api/change", edit)
        studio.end("kill")
        document = self.studio().json("/api/document")
        self.assertTrue(document["recovered"])
        self.assertEqual(len(document["svg"]), len(edit["svg"]))

    def test_a_sketch_that_could_not_be_opened_again_is_not_taken(self):
        studio = self.studio()
        edit = self.wider(studio)
        edit["svg"] += "<!--" + 25 * 2**20 * "x" + "-->"
        status, told = studio.ask("/api/change", edit)
        self.assertGreaterEqual(status, 400)
        self.assertIn(b"larger than the studio holds", told)
        self.assertFalse((self.folder / "cherry.toml.unsaved").exists())

    def test_two_windows_do_not_lose_each_others_edits(self):
        studio = self.studio()
        one, two = self.wider(studio), self.wider(studio)
        studio.json("/api/change", one)
        two["toml"] += "# other\n"
        self.assertEqual(studio.ask("/api/change", two)[0], 409)
        self.assertEqual(studio.json("/api/document")["svg"], one["svg"])
        self.assertEqual(studio.ask("/api/save", {"seen": two["seen"]})[0], 409)

    def test_a_second_studio_of_a_file_is_refused_until_the_first_has_ended(self):
        first = self.studio()
        (self.folder / "same").symlink_to(self.folder)
        for path in ("cherry.toml", self.folder / "cherry.toml", "same/cherry.toml", "./cherry.toml"):
            second = subprocess.run([PROGRAM, "studio", str(path)], cwd=self.folder, capture_output=True, text=True, timeout=60)
            self.assertEqual(second.returncode, 75, second.stderr)
            self.assertIn("is open in another studio", second.stderr)
            self.assertEqual(second.stdout, "")
        edit = self.wider(first)
        first.json("/api/change", edit)
        other = self.studio("plum.toml")  # of another file there may be one
        other.end("kill")
        first.end("kill")
        self.assertEqual(self.studio().json("/api/document")["svg"], edit["svg"])

    def test_another_editors_change_is_taken_in(self):
        studio = self.studio()
        before = studio.json("/api/document")
        (self.folder / "cherry.toml").write_text(before["toml"] + "# theirs\n")
        after = studio.json("/api/document")
        self.assertGreater(after["version"], before["version"])
        self.assertIn("# theirs", after["toml"])

    def test_another_editors_change_is_told_and_not_written_over(self):
        studio = self.studio()
        edit = self.wider(studio)
        version = studio.json("/api/change", edit)["version"]
        theirs = edit["toml"] + "# theirs\n"
        (self.folder / "cherry.toml").write_text(theirs)
        self.assertTrue(studio.json("/api/state")["changed_outside"])
        self.assertEqual(studio.ask("/api/save", {"seen": version})[0], 409)
        self.assertEqual((self.folder / "cherry.toml").read_text(), theirs)
        studio.json("/api/save", {"seen": version, "over": True})
        self.assertEqual((self.folder / "cherry.toml").read_text(), edit["toml"])

    def test_mistakes_are_the_readers_at_the_curve(self):
        studio = self.studio()
        document = studio.json("/api/document")
        svg = document["svg"].replace('inkscape:label="stone"', 'inkscape:label="stones"', 1)
        status, body = studio.ask("/api/section", {"toml": document["toml"], "svg": svg})
        self.assertEqual(status, 422)
        error = json.loads(body)["errors"][0]
        self.assertEqual(error["file"], "cherry.toml")
        self.assertGreater(error["line"], 0)
        self.assertNotIn(str(self.folder), body.decode())
        status, body = studio.ask("/api/section", {"toml": document["toml"] + "[[[", "svg": document["svg"]})
        self.assertEqual(status, 422)

    def test_a_section_is_inside_where_cut_finds_it(self):
        studio = self.studio()
        document = studio.json("/api/document")
        status, reply = studio.ask("/api/section", {"toml": document["toml"], "svg": document["svg"], "size": 200, "final": True})
        self.assertEqual(status, 200)
        length = int.from_bytes(reply[:4], "little")
        head, pixels = json.loads(reply[4:4 + length]), reply[4 + length:]
        side = head["pictures"][0]
        width, height = side["width"], side["height"]
        inside = sum(pixels[4 * i + 3] for i in range(width * height)) / 255
        area = inside / (width * height) * side["right"][0] * -side["down"][1]
        subprocess.run([PROGRAM, "cut", "cherry.toml", "--knife", "half", "--section", "-o", "out.ply", "--quiet"], cwd=self.folder, check=True)
        self.assertAlmostEqual(area / ply_area(self.folder / "out.ply"), 1, delta=0.01)

    def test_a_new_fruit_and_a_copy_of_a_shipped_one(self):
        new = self.studio("plum.toml", "--folds", "5")
        document = new.json("/api/document")
        self.assertFalse((self.folder / "plum.toml").exists())
        self.assertEqual(new.ask("/api/section", {"toml": document["toml"], "svg": document["svg"]})[0], 200)
        new.json("/api/save", {"seen": document["version"]})
        subprocess.run([PROGRAM, "check", "plum.toml", "--quiet"], cwd=self.folder, check=True)
        copy = self.studio("lemon")
        copy.json("/api/save", {"seen": copy.json("/api/document")["version"]})
        for name in ("lemon.toml", "lemon.svg"):
            self.assertEqual((self.folder / name).read_bytes(), (TEMPLATES / name).read_bytes())

    def test_a_copy_brings_its_meshes(self):
        copy = self.studio("kidney")
        document = copy.json("/api/document")
        self.assertEqual(copy.ask("/api/section", {"toml": document["toml"], "svg": document["svg"]})[0], 200)
        self.assertEqual((self.folder / "kidney.ply").read_bytes(), (TEMPLATES / "kidney.ply").read_bytes())
        self.assertFalse((self.folder / "kidney.toml").exists(), "nothing is saved yet")

    def test_another_mesh_of_its_name_is_not_written_over(self):
        (self.folder / "kidney.ply").write_bytes(b"mine")
        ended = subprocess.run([PROGRAM, "studio", "kidney"], cwd=self.folder, capture_output=True, text=True, timeout=20)
        self.assertEqual(ended.returncode, 73, ended.stderr)
        self.assertIn("kidney.ply", ended.stderr)
        self.assertEqual((self.folder / "kidney.ply").read_bytes(), b"mine")

    def test_control_c_ends_it(self):
        studio = self.studio()
        studio.process.send_signal(signal.SIGINT)
        self.assertEqual(studio.process.wait(timeout=5), -signal.SIGINT)


def ply_area(file):
    """The area of all triangles of a binary section file, square metres."""
    import struct
    data = file.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    sizes = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
             "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    at, position, area = end, [], 0.0
    for name, count, properties in elements:
        for _ in range(count):
            row = {}
            for words in properties:
                if words[0] == "list":
                    n = struct.unpack_from("<" + sizes[words[1]], data, at)[0]
                    at += struct.calcsize(sizes[words[1]])
                    row[words[3]] = struct.unpack_from(f"<{n}{sizes[words[2]]}", data, at)
                    at += n * struct.calcsize(sizes[words[2]])
                else:
                    row[words[1]] = struct.unpack_from("<" + sizes[words[0]], data, at)[0]
                    at += struct.calcsize(sizes[words[0]])
            if name == "vertex":
                position.append((row["x"], row["y"], row["z"]))
            elif name == "face":
                a, b, c = (position[i] for i in row.get("vertex_indices", row.get("vertex_index")))
                u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
                n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                area += 0.5 * sum(x * x for x in n) ** 0.5
    return area


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
