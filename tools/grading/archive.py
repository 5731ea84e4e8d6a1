# SPDX-License-Identifier: MIT
"""Reading a submission: a folder or an archive becomes a dictionary of its headers. Nothing is unpacked to the disk."""

import io
import os
import pathlib
import stat
import tarfile
import unicodedata
import zipfile

from labs import Lab, Problem, all_labs

ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tbz2")
KEPT = (".hpp", ".h", ".hxx", ".hh", ".ipp", ".inl")
LARGEST_FILE = 1 << 20      # bytes, of a header
LARGEST_ALL = 64 << 20      # bytes, of all that an archive holds, unpacked
MOST_ENTRIES = 5000
SKIPPED_FOLDERS = {"__MACOSX", ".git", "build", "solutions", "node_modules"}


class Refused(Exception):
    """This submission is not graded; says why, for the student to read."""


Files = dict[pathlib.PurePosixPath, bytes]


def read(path: pathlib.Path) -> Files:
    """The headers of a submission, by their paths within it."""
    if path.is_symlink():
        raise Refused("a submission is a folder or an archive, not a link")
    if path.is_dir():
        return _folder(path)
    name = path.name.lower()
    if not path.is_file():
        raise Refused("a submission is a folder, an archive, or a header")
    try:
        if name.endswith(".zip"):
            return _zip(path)
        if name.endswith(ARCHIVES):
            return _tar(path)
    except Refused:
        raise
    except Exception as problem:  # a broken archive raises nearly anything in zipfile, tarfile, zlib, lzma
        raise Refused(f"the archive cannot be read: {plain(str(problem))[:200]}") from None
    if name.endswith(KEPT):
        if path.stat().st_size > LARGEST_FILE:
            raise Refused("the file is larger than 1 MiB")
        return {pathlib.PurePosixPath(path.name): path.read_bytes()}
    raise Refused(f"I read folders, headers and archives ({', '.join(ARCHIVES)})")


def plain(text: str) -> str:
    """Without control characters, and such as turn the direction of writing."""
    return "".join(c if unicodedata.category(c)[0] != "C" else "�" for c in text)


def _name(name: str) -> pathlib.PurePosixPath:
    """An entry's path, if it stays within the archive."""
    path = pathlib.PurePosixPath(name.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or (path.parts and ":" in path.parts[0]) or "\0" in name:
        raise Refused(f"the archive holds a path that leads out of it: {plain(name)[:100]}")
    return path


class _Kept:
    """Keeps the headers, and counts what all entries take."""

    def __init__(self):
        self.files: Files = {}
        self.entries = self.size = 0

    def count(self) -> None:
        self.entries += 1
        if self.entries > MOST_ENTRIES:
            raise Refused(f"the archive holds more than {MOST_ENTRIES} entries")

    def wants(self, path: pathlib.PurePosixPath) -> bool:
        return path.suffix.lower() in KEPT and not SKIPPED_FOLDERS & set(path.parts)

    def add(self, path: pathlib.PurePosixPath, stream: io.BufferedIOBase) -> None:
        data = stream.read(LARGEST_FILE + 1)
        self.size += len(data)
        if len(data) > LARGEST_FILE:
            raise Refused(f"{plain(str(path))[:100]} is larger than 1 MiB")
        if self.size > LARGEST_ALL:
            raise Refused("the archive is larger than 64 MiB when it is unpacked")
        if path in self.files:
            raise Refused(f"the archive holds {plain(str(path))[:100]} twice")
        self.files[path] = data


def _zip(path: pathlib.Path) -> Files:
    kept = _Kept()
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            kept.count()
            name = _name(entry.filename)
            kind = stat.S_IFMT(entry.external_attr >> 16)
            if kind and not (stat.S_ISREG(kind) or stat.S_ISDIR(kind)):
                raise Refused(f"the archive holds a link or a device: {plain(entry.filename)[:100]}")
            if entry.flag_bits & 1:
                raise Refused("the archive is encrypted")
            if entry.file_size > LARGEST_ALL:
                raise Refused("the archive is larger than 64 MiB when it is unpacked")
            if not entry.is_dir() and kept.wants(name):
                with archive.open(entry) as stream:  # what the entry says of its size is not believed
                    kept.add(name, stream)
    return kept.files


class _Counted(io.RawIOBase):
    """A stream that ends in a refusal when more comes out of it than may."""

    def __init__(self, inner):
        self.inner, self.left = inner, LARGEST_ALL

    def read(self, size=-1):
        data = self.inner.read(min(size if size >= 0 else 1 << 20, 1 << 20))
        self.left -= len(data)
        if self.left < 0:
            raise Refused("the archive is larger than 64 MiB when it is unpacked")
        return data


def _tar(path: pathlib.Path) -> Files:
    import bz2
    import gzip
    import lzma
    name = path.name.lower()
    opener = gzip.open if name.endswith(("gz",)) else lzma.open if name.endswith("xz") else bz2.open if name.endswith("bz2") else open
    kept = _Kept()
    with opener(path, "rb") as unpacked, tarfile.open(fileobj=_Counted(unpacked), mode="r|") as archive:
        for entry in archive:
            kept.count()
            where = _name(entry.name)
            if not (entry.isreg() or entry.isdir()):
                raise Refused(f"the archive holds a link or a device: {plain(entry.name)[:100]}")
            if entry.isreg() and kept.wants(where):
                kept.add(where, archive.extractfile(entry))
    return kept.files


def _folder(path: pathlib.Path) -> Files:
    kept = _Kept()
    for folder, folders, names in os.walk(path, followlinks=False):
        folders[:] = sorted(name for name in folders if name not in SKIPPED_FOLDERS)
        for name in sorted(names):
            kept.count()
            file = pathlib.Path(folder) / name
            where = pathlib.PurePosixPath(file.relative_to(path).as_posix())
            if not kept.wants(where):
                continue
            try:  # a link is not followed, and a pipe that has no other end is not waited for
                descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
            except OSError:
                continue
            with os.fdopen(descriptor, "rb") as stream:
                if stat.S_ISREG(os.fstat(descriptor).st_mode):
                    kept.add(where, stream)
    return kept.files


# ---- Where the headers belong --------------------------------------------------------------------------------------

def placed(files: Files, lab: Lab) -> tuple[dict[str, bytes], str]:
    """The files under an include root, `lab06_glossy/glossy.hpp` and its neighbours; and the path of the header, as it was handed in."""
    header = _header_of(files, lab)
    if header is None:
        only = [path for path in files if path.suffix.lower() in KEPT]
        if len(only) != 1:
            raise Refused(f"there is no {lab.header} in the submission")
        header = only[0]
    root = {f"{lab.folder}/{path.name}": data for path, data in files.items()
            if path.parent == header.parent and safe(path.name)}
    root[f"{lab.folder}/{lab.header}"] = files[header]
    for other in all_labs():  # a lab may build on the student's earlier headers
        if other.folder != lab.folder:
            earlier = next((path for path in files if path.parts[-2:] == (other.folder, other.header)), None)
            if earlier is not None:
                root |= {f"{other.folder}/{path.name}": data for path, data in files.items() if path.parent == earlier.parent and safe(path.name)}
    return root, str(header)


def _header_of(files: Files, lab: Lab) -> pathlib.PurePosixPath | None:
    """Of several, the one in the lab's own folder, then the least deep."""
    found = [path for path in files if path.name == lab.header]
    return min(found, key=lambda path: (path.parent.name != lab.folder, len(path.parts), str(path)), default=None)


def safe(name: str) -> bool:
    return name.isascii() and name.isprintable() and "/" not in name and not name.startswith(".") and len(name) < 100


def submissions(folder: pathlib.Path) -> list[pathlib.Path]:
    """The submissions in a folder: all that is in it and not hidden."""
    if not folder.is_dir():
        raise Problem(f"{folder} is no folder")
    found = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    if not found:
        raise Problem(f"{folder} is empty: I expect a folder, an archive or a header in it for each student")
    return found


def plain_lines(text: str) -> str:
    return "\n".join(plain(line.expandtabs()) for line in text.splitlines())
