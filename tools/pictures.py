# SPDX-License-Identifier: MIT
"""Pictures that the labs' programs write: read, compared, and shown in a terminal."""

import base64
import os
import pathlib
import struct
import sys
import zlib
from dataclasses import dataclass

import ppm_to_png

LARGEST = 50_000_000  # pixels


@dataclass
class Picture:
    """Eight bits a channel: red, green, blue; row after row, the top row first."""
    width: int
    height: int
    pixels: bytes


def read(path: pathlib.Path) -> Picture:
    """A PPM, or a PNG of 8 bits without interlacing, which is what our programs write. ValueError for anything else."""
    data = path.read_bytes()
    if data.startswith(b"\x89PNG\r\n\x1a\n"):
        return read_png(data)
    try:
        return Picture(*ppm_to_png.read(data))
    except IndexError as error:
        raise ValueError("no PPM") from error


def read_png(data: bytes) -> Picture:
    """W3C, Portable Network Graphics (2003), sections 5, 9 and 11."""
    at, packed, header = 8, b"", b""
    while at + 8 <= len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            header = body
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    if len(header) != 13:
        raise ValueError("no header")
    width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", header)
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(colour)
    if bits != 8 or channels is None or interlaced or not 0 < width * height <= LARGEST:
        raise ValueError("a PNG of a kind that our programs do not write")
    stride = channels * width
    try:
        raw = zlib.decompressobj().decompress(packed, (stride + 1) * height)
    except zlib.error as error:
        raise ValueError("broken") from error
    if len(raw) != (stride + 1) * height:
        raise ValueError("rows are missing")
    before, rows = bytearray(stride), []
    for y in range(height):
        start = y * (stride + 1)
        before = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + stride]), before, channels)
        rows.append(bytes(before))
    everything = b"".join(rows)
    if channels <= 2:
        grey = everything[::channels]
        return Picture(width, height, bytes(x for x in grey for _ in range(3)))
    if channels == 4:
        everything = b"".join(everything[i:i + 3] for i in range(0, len(everything), 4))
    return Picture(width, height, everything)


def unfiltered(kind: int, row: bytearray, above: bytearray, step: int) -> bytearray:
    """A row without its filter (section 9.2)."""
    if kind == 0:
        return row
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        up = above[i]
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        elif kind == 4:
            corner = above[i - step] if i >= step else 0
            p = left + up - corner
            guess = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
        else:
            raise ValueError("a filter that there is not")
        row[i] = (row[i] + guess) & 255
    return row


def png(picture: Picture) -> bytes:
    return ppm_to_png.encoded(picture.width, picture.height, picture.pixels)


def signed_difference(mine: Picture, reference: Picture) -> tuple[Picture, int, int]:
    """Red where mine is brighter, blue where it is darker, white where they agree, four times as strong as it is; how many
    pixels differ, and by how much at the most (of 255). The pictures have the same size."""
    out = bytearray()
    count = most = 0
    a, b = mine.pixels, reference.pixels
    for i in range(0, len(a), 3):
        off = [a[i + k] - b[i + k] for k in range(3)]
        largest = max(map(abs, off))
        if largest:
            count += 1
            most = max(most, largest)
        total = sum(off)
        rest = max(0, 255 - 4 * largest)
        out += bytes((255, rest, rest) if total > 0 else (rest, rest, 255) if total < 0 or largest else (255, 255, 255))
    return Picture(mine.width, mine.height, bytes(out)), count, most


# ---- in a terminal ----------------------------------------------------------------------------------------------------


def protocol(environment=os.environ) -> str:
    """How this terminal shows pictures: "iterm", "kitty", "blocks" (two pixels a character, in colours), or "" for not at all."""
    if environment.get("TERM_PROGRAM") in ("iTerm.app", "WezTerm", "mintty"):
        return "iterm"
    if environment.get("KITTY_WINDOW_ID") or environment.get("TERM") == "xterm-kitty":
        return "kitty"
    return "blocks" if environment.get("COLORTERM") in ("truecolor", "24bit") else ""


def shown(path: pathlib.Path, columns: int, how: str) -> str:
    """The picture as characters for the terminal, `columns` wide; empty where it cannot be."""
    if not how:
        return ""
    try:
        picture = read(path)
    except (OSError, ValueError):
        return ""
    if how == "iterm":
        return f"\033]1337;File=inline=1;width={columns}:{base64.b64encode(png(picture)).decode()}\a\n"
    if how == "kitty":
        data = base64.b64encode(png(picture)).decode()
        pieces = [data[i:i + 4096] for i in range(0, len(data), 4096)]
        text = ""
        for i, piece in enumerate(pieces):
            first = f"a=T,f=100,c={columns}," if i == 0 else ""
            text += f"\033_G{first}m={0 if i + 1 == len(pieces) else 1};{piece}\033\\"
        return text + "\n"
    return blocks(picture, columns)


def blocks(picture: Picture, columns: int) -> str:
    """Half a character a pixel: the upper one in the colour of the text, the lower one in that of the paper."""
    columns = min(columns, picture.width)
    rows = max(1, round(picture.height * columns / picture.width / 2))

    def mean(x: int, y: int) -> tuple[int, int, int]:
        x0, x1 = x * picture.width // columns, max((x + 1) * picture.width // columns, x * picture.width // columns + 1)
        y0, y1 = y * picture.height // (2 * rows), max((y + 1) * picture.height // (2 * rows), y * picture.height // (2 * rows) + 1)
        points = [3 * (row * picture.width + column) for row in range(y0, y1) for column in range(x0, x1)]
        return tuple(sum(picture.pixels[p + k] for p in points) // len(points) for k in range(3))

    lines = []
    for y in range(rows):
        line = ""
        for x in range(columns):
            upper, lower = mean(x, 2 * y), mean(x, 2 * y + 1)
            line += "\033[38;2;{};{};{};48;2;{};{};{}m▀".format(*upper, *lower)
        lines.append(line + "\033[0m")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":  # pictures.py FILE [COLUMNS]: a look at a picture
    print(shown(pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 80, protocol() or "blocks"), end="")
