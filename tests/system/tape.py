# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and alters tapes (docs/results.md) without a line of the project's own reader."""
import json
import struct
import zlib
from dataclasses import dataclass

WELCOME, INSERT, ADVANCE, PRESSURE, RESPONSE, FIELDS, SAVE, STATE, PROGRESS = 2, 11, 20, 21, 22, 31, 40, 41, 61
TAPE_HEADER, RECORD_HEADER, ENVELOPE = 48, 32, 64
SIZES = {"float64": 8, "int64": 8, "uint64": 8, "uint8": 1}


@dataclass
class TapedMessage:
    number: int
    offset: int  # of the record in the file
    direction: str  # ">" to the participant, "<" to the coupler
    time: float
    frames: list
    places: list  # of each frame in the file
    size: int  # of the record

    @property
    def type(self):
        return struct.unpack_from("<H", self.frames[0], 6)[0]

    @property
    def interval(self):
        return struct.unpack_from("<Q", self.frames[0], 40)[0]

    def arrays(self):
        """(name, dtype, shape, bytes) of each."""
        declared = json.loads(self.frames[1]).get("arrays", [])
        return [(each["name"], each["dtype"], each["shape"], frame)
                for each, frame in zip(declared, self.frames[2:])]


def messages(file):
    """Every whole message of a tape."""
    data = memoryview(file.read_bytes())
    assert data[:8] == b"FISTAPE1" and zlib.crc32(data[:44]) == struct.unpack_from("<I", data, 44)[0]
    offset, number = TAPE_HEADER, 0
    while offset + RECORD_HEADER <= len(data):
        magic, count, time, length, checksum, own = struct.unpack_from("<4sIdQII", data, offset)
        assert magic[:3] == b"FIS" and zlib.crc32(data[offset:offset + 28]) == own
        begin = offset + RECORD_HEADER
        if begin + length > len(data):
            return
        assert zlib.crc32(data[begin:begin + length]) == checksum
        place, frames, places = begin + 8 * count, [], []
        for size in struct.unpack_from(f"<{count}Q", data, begin):
            frames.append(bytes(data[place:place + size]))
            places.append(place)
            place += size
        yield TapedMessage(number, offset, magic[3:].decode(), time, frames, places, RECORD_HEADER + length)
        offset, number = place, number + 1


def flip_value(file, message, array, index, bit):
    """Inverts one bit (from the lowest) of a value, as if the message had been so: every checksum fits."""
    size = SIZES[message.arrays()[array][1]]
    frame = bytearray(message.frames[2 + array])
    frame[index * size + bit // 8] ^= 1 << (bit % 8)
    frames = [bytearray(each) for each in message.frames]
    frames[2 + array] = frame
    struct.pack_into("<I", frames[0], 60, zlib.crc32(b"".join([bytes(frames[0][:60]), *map(bytes, frames[1:])])))
    payload = struct.pack(f"<{len(frames)}Q", *map(len, frames)) + b"".join(map(bytes, frames))
    with open(file, "r+b") as stream:
        stream.seek(message.offset)
        head = bytearray(stream.read(RECORD_HEADER))
        struct.pack_into("<I", head, 24, zlib.crc32(payload))
        struct.pack_into("<I", head, 28, zlib.crc32(bytes(head[:28])))
        stream.seek(message.offset)
        stream.write(bytes(head) + payload)
