# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells whether a PLY file has all the elements that its header promises."""

import os

import numpy

from volume_lengths import FileLengthError

MAXIMUM_HEADER = 1 << 20  # bytes
TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
         "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
         "double": "f8", "float64": "f8"}


def check_ply(path):
    with open(path, "rb") as stream:
        encoding, elements = _header(stream)
        start = stream.tell()
        if encoding == "ascii":
            _check_lines(stream, elements)
            return
    order = ">" if encoding == "binary_big_endian" else "<"
    data = numpy.memmap(path, mode="r") if os.path.getsize(path) else numpy.empty(0, "u1")
    for name, count, properties in elements:
        start = _end_of_element(data, start, name, count, properties, order)


def _header(stream):
    """The encoding, and per element its name, number and properties: (type,) or (count type, type)."""
    encoding, elements = "", []
    while stream.tell() < MAXIMUM_HEADER:
        line = stream.readline(MAXIMUM_HEADER)
        words = line.decode("latin-1").split() or [""]
        try:
            if words[0] == "format":
                encoding = words[1]
            elif words[0] == "element":
                elements.append((words[1], int(words[2]), []))
                if int(words[2]) < 0:
                    raise ValueError
            elif words[0] == "property":
                names = words[2:4] if words[1] == "list" else words[1:2]
                elements[-1][2].append([TYPES[name] for name in names])
        except (IndexError, KeyError, ValueError):
            raise FileLengthError(f"the header is damaged: {' '.join(words)[:80]}") from None
        if words[0] == "end_header":
            return encoding, elements
        if not line:
            break
    raise FileLengthError("the header has no end: the file is cut short or damaged")


def _check_lines(stream, elements):
    promised = sum(count for _name, count, _properties in elements)
    found = sum(1 for line in stream if line.strip())
    if found < promised:
        raise FileLengthError(
            f"the file is cut short: its header promises {promised:,} lines of elements, but it has {found:,}"
        )


def _end_of_element(data, start, name, count, properties, order):
    """The place after all elements of one name."""
    size = _same_size(data, start, count, properties, order)
    if size is not None:
        end = start + size * count
    else:
        end = start
        for _k in range(count):
            end = _end_of_one(data, end, properties, order)
            if end > len(data):
                break
    if end > len(data):
        raise FileLengthError(f"the file is cut short: its header promises {count:,} elements {name}, but it ends "
                              "before the last of them")
    return end


def _end_of_one(data, place, properties, order):
    for types in properties:
        repeats = 1
        if len(types) == 2:
            counter = numpy.dtype(order + types[0])
            if place + counter.itemsize > len(data):
                return len(data) + 1
            repeats = int(data[place : place + counter.itemsize].view(counter)[0])
            place += counter.itemsize
            if repeats < 0:
                raise FileLengthError("the file is damaged: a list has a negative length")
        place += repeats * numpy.dtype(types[-1]).itemsize
    return place


def _same_size(data, start, count, properties, order):
    """The bytes per element if the lists of all are as long as those of the first; else None."""
    end = _end_of_one(data, start, properties, order) if count else start
    size = end - start
    if count * size > len(data) - start:
        lists = any(len(types) == 2 for types in properties)
        return None if lists else size
    rows = data[start : start + count * size].reshape(count, size) if count and size else None
    place = 0
    for types in properties if rows is not None else ():
        if len(types) == 2:
            width = numpy.dtype(types[0]).itemsize
            counters = rows[:, place : place + width]
            if (counters != counters[0]).any():
                return None
            repeats = int(numpy.ascontiguousarray(counters[0]).view(order + types[0])[0])
            place += width + repeats * numpy.dtype(types[1]).itemsize
        else:
            place += numpy.dtype(types[0]).itemsize
    return size
