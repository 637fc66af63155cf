"""OpenEXR as arrays of floats, only by zlib: rows packed by ZIP, or not packed."""

import itertools
import struct
import zlib

FLOAT, PLAIN, ZIP = 2, 0, 3


class Layers:
    """`channels` by name, each row by row; `texts` are the header's."""

    def __init__(self, data):
        assert struct.unpack_from("<I", data) == (20000630,)
        self.data, self.at, self.texts = data, 8, {}
        while name := self._word():
            kind = self._word()
            size = self._number()
            self._attribute(name, kind, data[self.at:self.at + size])
            self.at += size
        self.channels = {name: [] for name in self.names}
        rows = 16 if self.packing == ZIP else 1
        for block in range(-(-self.height // rows)):
            place, = struct.unpack_from("<Q", data, self.at + 8 * block)
            self._read(place, min(rows, self.height - block * rows))

    def _word(self):
        end = self.data.index(0, self.at)
        word = self.data[self.at:end].decode()
        self.at = end + 1
        return word

    def _number(self):
        self.at += 4
        return struct.unpack_from("<i", self.data, self.at - 4)[0]

    def _attribute(self, name, kind, value):
        if kind == "string":
            self.texts[name] = value.decode()
        elif name == "compression":
            self.packing = value[0]
            assert self.packing in (PLAIN, ZIP)
        elif name == "dataWindow":
            left, top, right, bottom = struct.unpack("<4i", value)
            self.width, self.height = right - left + 1, bottom - top + 1
        elif name == "channels":
            self.names, at = [], 0
            while value[at]:
                end = value.index(0, at)
                self.names.append(value[at:end].decode())
                assert struct.unpack_from("<i", value, end + 1) == (FLOAT,)
                at = end + 17

    def _read(self, place, rows):
        _, size = struct.unpack_from("<2i", self.data, place)
        raw, whole = self.data[place + 8:place + 8 + size], rows * len(self.names) * self.width * 4
        if size < whole:
            raw = zlib.decompress(raw)
            raw = bytes(itertools.accumulate(raw, lambda before, step: (before + step - 128) & 255))
            half = (whole + 1) // 2
            mixed = bytearray(whole)
            mixed[0::2], mixed[1::2] = raw[:half], raw[half:]
            raw = bytes(mixed)
        values = struct.unpack(f"<{whole // 4}f", raw)
        at = 0
        for _ in range(rows):
            for name in self.names:
                self.channels[name].extend(values[at:at + self.width])
                at += self.width
