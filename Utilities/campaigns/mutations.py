# SPDX-License-Identifier: GPL-3.0-or-later
"""Damages the bytes of a file: bytes changed, the end cut off, numbers of the header made untrue, pieces moved."""

import gzip
import re

HEADER = 600  # bytes at the beginning in which headers lie
NUMBERS = (b"0", b"-1", b"1", b"255", b"65536", b"2147483647", b"2147483648", b"4294967295", b"9223372036854775807",
           b"99999999999999999999999", b"1e308", b"-1e308", b"1e-320", b"nan", b"inf", b"0.5", b"", b"x")
INTEGERS = (0, 1, -1, 2, 3, 0x7F, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
            0x3F800000, 0x7F800000, 0x7FC00000, 0x7FFFFFFFFFFFFFFF)


def cut(data, random):
    return data[: random.randrange(len(data))]


def flip(data, random, end=None):
    data = bytearray(data)
    for _k in range(random.choice((1, 1, 2, 4, 16))):
        place = random.randrange(min(len(data), end or len(data)))
        data[place] = random.choice((data[place] ^ 1 << random.randrange(8), random.randrange(256), 0, 255))
    return bytes(data)


def flip_header(data, random):
    return flip(data, random, HEADER)


def lie(data, random):
    """A number in the header is another: a text number, or some bytes where the header is binary."""
    found = list(re.finditer(rb"-?\d[\d.eE+-]*", data[:HEADER]))
    if found and random.random() < 0.7:
        match = random.choice(found)
        number = random.choice(NUMBERS)
        if random.random() < 0.3 and match.group().isdigit():
            number = str(int(match.group()) + random.choice((-1, 1, 2, 1000))).encode()
        return data[: match.start()] + number + data[match.end() :]
    width = random.choice((1, 2, 4, 8))
    place = random.randrange(max(1, min(HEADER, len(data)) // 2)) * 2
    value = (random.choice(INTEGERS) & (256**width - 1)).to_bytes(width, random.choice(("little", "big")))
    return data[:place] + value + data[place + width :]


def move(data, random):
    """A piece is left out, doubled, or put elsewhere."""
    first, last = sorted(random.randrange(len(data) + 1) for _k in range(2))
    last = min(last, first + random.choice((1, 4, 50, 1000)))
    piece, rest = data[first:last], data[:first] + data[last:]
    way = random.randrange(3)
    if way == 0:
        return rest
    if way == 1:
        return data[:last] + piece + data[last:]
    place = random.randrange(len(rest) + 1)
    return rest[:place] + piece + rest[place:]


KINDS = {"cut": cut, "flip": flip, "flip_header": flip_header, "lie": lie, "move": move}


def mutated(data, random):
    """The kind of damage and the damaged bytes, which may by chance be the same."""
    kind = random.choice(list(KINDS))
    if data.startswith(b"\x1f\x8b") and kind != "cut" and random.random() < 0.5:
        return kind, gzip.compress(KINDS[kind](gzip.decompress(data), random), mtime=0)
    return kind, KINDS[kind](data, random)
