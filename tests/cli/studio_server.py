"""`pomona studio`, started as a user would: its address and its replies."""

import http.client
import json
import re
import subprocess


class Studio:
    def __init__(self, program, *words, folder):
        self.process = subprocess.Popen([str(program), "studio", *map(str, words)], cwd=folder, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})", self.address)
        if not found:
            raise AssertionError(f"no address: {self.address!r} {self.process.stderr.read()}")
        self.port, self.token = int(found[1]), found[2]

    def ask(self, path, body=None, method=None, headers=None):
        """Status and bytes."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        sent = {"X-Pomona-Token": self.token, **({"Content-Type": "application/json"} if body is not None else {}), **(headers or {})}
        data = json.dumps(body).encode() if isinstance(body, dict) else body
        connection.request(method or ("GET" if body is None else "POST"), path, data, {k: v for k, v in sent.items() if v is not None})
        reply = connection.getresponse()
        content = reply.read()
        connection.close()
        return reply.status, content

    def json(self, path, body=None):
        status, content = self.ask(path, body)
        if status != 200:
            raise AssertionError(f"{path}: {status} {content[:300]}")
        return json.loads(content)

    def end(self, how="kill"):
        getattr(self.process, how)()
        self.process.wait()
        self.process.stdout.close()
        self.process.stderr.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.end()
