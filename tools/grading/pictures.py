# SPDX-License-Identifier: MIT
"""The pictures of a student's program, which runs in the sandbox: their bytes are checked, and written anew."""

import io
import pathlib
import re
import struct
import tarfile
import zlib

import ppm_to_png
from grading.sandbox import MIB, Limits, Sandbox

DRAWING = Limits(cpu=60, wall=90, memory=1024 * MIB, processes=32, file_size=16 * MIB, output=48 * MIB)
MOST = 16
LARGEST = 16_000_000  # pixels


def drawn(program: pathlib.Path, box: Sandbox, to: pathlib.Path) -> tuple[list[str], str]:
    """Runs the program and keeps its pictures; their names, and a note when something went wrong."""
    # The pictures leave the sandbox as one stream of bounded size. What the program prints goes nowhere.
    script = "mkdir -p /tmp/out; cd /tmp; timeout 60 /program out >/dev/null 2>&1 </dev/null; echo $? >/tmp/out/status; exec tar -C /tmp/out -cf - ."
    limits = DRAWING
    done = box.run(["/bin/sh", "-c", script], limits, readable={"/program": program}, system=True)
    names: list[str] = []
    status = b"?"
    try:
        with tarfile.open(fileobj=io.BytesIO(done.printed), mode="r|") as archive:
            for entry in archive:
                name = entry.name.removeprefix("./")
                if not entry.isreg() or len(names) >= MOST:
                    continue
                data = archive.extractfile(entry).read()
                if name == "status":
                    status = data.strip()[:8]
                elif re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,60}\.(png|ppm)", name):
                    clean = as_png(data)
                    if clean is not None:
                        to.mkdir(parents=True, exist_ok=True)
                        target = to / (name.rsplit(".", 1)[0] + ".png")
                        if target.name not in names:
                            target.write_bytes(clean)
                            names.append(target.name)
    except tarfile.TarError:
        pass
    if done.status is None or status == b"124":
        return sorted(names), "The lab's program did not finish in time."
    if status != b"0":
        return sorted(names), "The lab's program did not end well: it crashed, or said so by its exit status."
    return sorted(names), "" if names else "The lab's program drew no picture."


def as_png(data: bytes) -> bytes | None:
    """A PNG or PPM, as a PNG that holds nothing but its pixels; None when it is neither."""
    if data.startswith(b"P"):
        try:
            width, height, pixels = ppm_to_png.read(data)
        except (ValueError, IndexError):
            return None
        if width * height > LARGEST:
            return None
        rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
        return written(struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0), rows)
    return again(data)


def again(data: bytes) -> bytes | None:
    """Of a PNG of 8 bits, grey or colour, the header and the rows: whatever else it holds is left out."""
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        return None
    header, packed, at = b"", b"", 8
    while at + 12 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            header = body
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    if len(header) != 13:
        return None
    width, height, bits, colour, *rest = struct.unpack(">IIBBBBB", header)
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(colour)
    if bits != 8 or channels is None or any(rest) or not 0 < width * height <= LARGEST or not width < 1 << 20:
        return None
    size = height * (1 + channels * width)
    try:
        rows = zlib.decompressobj().decompress(packed, size + 1)
    except zlib.error:
        return None
    if len(rows) != size or any(rows[y * (1 + channels * width)] > 4 for y in range(height)):
        return None
    return written(header, rows)


def written(header: bytes, rows: bytes) -> bytes:
    return (b"\x89PNG\r\n\x1a\n" + ppm_to_png.chunk(b"IHDR", header) + ppm_to_png.chunk(b"IDAT", zlib.compress(rows, 6)) +
            ppm_to_png.chunk(b"IEND", b""))
