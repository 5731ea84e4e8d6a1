# SPDX-License-Identifier: MIT
"""A PNG beside a PPM, for viewers that do not know PPM. The PPM may be a student's: everything about it is checked."""

import pathlib
import struct
import zlib

LARGEST = 100_000_000  # pixels


def convert(path: pathlib.Path) -> pathlib.Path | None:
    """Writes path with .png at its end; None when the file is no PPM (P3 or P6) of 8 bits."""
    try:
        width, height, pixels = read(path.read_bytes())
    except (ValueError, IndexError):
        return None
    out = path.with_suffix(".png")
    out.write_bytes(encoded(width, height, pixels))
    return out


def encoded(width: int, height: int, pixels: bytes) -> bytes:
    """As PNG: red, green, blue of each pixel, without filters."""
    rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b"")


def read(data: bytes) -> tuple[int, int, bytes]:
    kind, *size, most = data[:200].split(maxsplit=4)[:4]
    width, height = (int(word) for word in size)
    if kind not in (b"P3", b"P6") or most != b"255" or not 0 < width * height <= LARGEST or width < 0:
        raise ValueError
    start = 0
    for word in (kind, *size, most):
        start = data.index(word, start) + len(word)
    pixels = bytes(int(word) for word in data[start:].split()) if kind == b"P3" else data[start + 1:]
    if len(pixels) != 3 * width * height:
        raise ValueError
    return width, height, pixels


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
