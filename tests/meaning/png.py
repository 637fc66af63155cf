"""PNG as rows of pixels, only by zlib: 1, 3 or 4 channels of 8 or 16 bits, not interlaced."""

import struct
import zlib


class Picture:
    def __init__(self, data):
        assert data[:8] == b"\x89PNG\r\n\x1a\n"
        at, packed = 8, b""
        while at < len(data):
            size, kind = struct.unpack_from(">I4s", data, at)
            body = data[at + 8:at + 8 + size]
            if kind == b"IHDR":
                self.width, self.height, self.depth, color, *_ = struct.unpack(">IIBBBBB", body)
            elif kind == b"IDAT":
                packed += body
            at += size + 12
        self.channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
        self.most = (1 << self.depth) - 1
        self._read(zlib.decompress(packed))

    def _read(self, raw):
        step = self.channels * self.depth // 8
        stride = self.width * step
        before = bytearray(stride)
        self.values = []
        for y in range(self.height):
            kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            for i in range(stride if kind else 0):
                a = row[i - step] if i >= step else 0
                b = before[i]
                c = before[i - step] if i >= step else 0
                if kind == 4:
                    p = a + b - c
                    near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                row[i] = (row[i] + (a, b, (a + b) // 2, near if kind == 4 else 0)[kind - 1]) & 255
            count = self.width * self.channels
            self.values.append(struct.unpack(f">{count}{'BH'[self.depth // 16]}", row))
            before = row

    def at(self, x, y):
        """All channels of a pixel; with one channel, its number."""
        if self.channels == 1:
            return self.values[y][x]
        return self.values[y][x * self.channels:(x + 1) * self.channels]
