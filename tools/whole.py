# SPDX-License-Identifier: MIT
"""Files that appear whole or not at all."""

import os
import pathlib


def write(path: pathlib.Path, text: str, errors: str = "strict") -> None:
    """Writes beside the path, then renames: whoever reads it, and whatever ends us, finds the old text or the new one. The name
    beside it is this process's own, so that several may write at a time. Lines end as the text says."""
    write_bytes(path, text.encode("utf-8", errors))


def write_bytes(path: pathlib.Path, data: bytes) -> None:
    beside = path.with_name(f"{path.name}.{os.getpid()}.part")
    beside.write_bytes(data)
    beside.replace(path)
