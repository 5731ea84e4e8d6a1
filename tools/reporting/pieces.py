# SPDX-License-Identifier: MIT
"""The measurements of a report: small pieces, each kept when it is done, so that a report that was stopped goes on."""

import hashlib
import json
import os
import pathlib
import platform
import subprocess
from dataclasses import dataclass, field
from typing import Any, Callable

import process
import whole
from labs import Problem
from process import ROOT

EFFECTS = ["antialiasing", "soft shadow", "gloss", "depth of field", "motion blur"]
SAMPLERS = ["random", "N-rooks", "jittered", "multi-jittered", "correlated multi-jittered", "Halton", "Sobol"]


def shown(most: int) -> list[int]:
    """Samples of the pictures that are shown: 16, the last, and the one in between; as in bench/convergence.cpp."""
    numbers = [4 ** k for k in range(1, 17) if 4 ** k <= most]
    return [numbers[1], numbers[len(numbers) // 2], numbers[-1]]


@dataclass
class Piece:
    """One program's answer. `command` is run when `key` has no answer yet; `read` makes JSON of what it printed."""
    section: str
    name: str
    command: list[str]
    seconds: float = 1  # a guess, for the progress bar
    read: Callable[[str], Any] = json.loads
    files: list[pathlib.Path] = field(default_factory=list)  # what it writes besides


STRUCTURES = ["every", "bvh", "bvh middle", "bvh median", "bvh bottom_up", "grid", "octree", "kd_tree", "wide_bvh"]
KERNELS = ["stripped", "trimmed", "everything"]  # as in tests/trim_kernels.cpp
TRIMMED = ["static", "lens", "motion", "gloss", "shadow", "all"]


def plan(settings: dict, tree: pathlib.Path, pictures: pathlib.Path) -> list[Piece]:
    """Everything that the report needs, the slowest first within a section. `tree` is where the programs were built."""
    pieces = []
    programs = tree / "bench"
    common = ["--trials", str(settings["trials"]), "--most", str(settings["most"]), "--first", str(settings["seed"])]
    effort = settings["trials"] * settings["most"] / 16384
    for effect in EFFECTS:
        for sampler in SAMPLERS:
            pieces.append(Piece("effects", f"{effect}, {sampler}",
                                [str(programs / "convergence"), "--json", "--effect", effect, "--sampler", sampler, *common], effort))
        slug = effect.replace(" ", "_")
        files = [pictures / f"{slug}_exact.png"]
        files += [pictures / f"{slug}_{n}{kind}.png" for n in shown(settings["most"]) for kind in ("", "_error")]
        pieces.append(Piece("effects", f"{effect}, pictures",
                            [str(programs / "convergence"), "--effect", effect, "--pictures", str(pictures), "--width", "96",
                             "--height", "64", "--most", str(settings["most"])], settings["most"] / 512, lambda text: {}, files))
    rungs = settings["renderings"]
    pieces.append(Piece("ladder", "the ladder of effects", [str(programs / "ladder"), "--json", "--renderings", str(rungs)], 5))
    if settings["valgrind"]:
        for rung in range(len(EFFECTS) + 1):
            for renderings in (100, 600):
                pieces.append(Piece("ladder", f"instructions of rung {rung}, {renderings} renderings",
                                    ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(programs / "ladder"),
                                     "--rung", str(rung), "--renderings", str(renderings)], 2, instructions))
    triangles = str(settings["triangles"])
    pieces.append(Piece("accelerators", "accelerators",
                        [str(programs / "trace"), "--json", "--scene", "terrain", "--structure", ",".join(STRUCTURES), "--triangles", triangles,
                         "--rays", triangles, "--rounds", "3"], settings["triangles"] / 2000))
    if settings["tests"]:
        pieces.append(Piece("stability", "stability", [str(tree / "tests" / "stress" / "stress"), "--json"], 15))
        if settings["valgrind"]:
            for scene in TRIMMED:
                for kernel in KERNELS:
                    pieces.append(Piece("leaving out", f"leaving out: {scene}, {kernel}",
                                        ["valgrind", "--tool=callgrind", "--toggle-collect=*measured*", "--callgrind-out-file=/dev/null",
                                         str(tree / "tests" / "trim_kernels"), scene, kernel, str(TRIM_SIDE)], 1, instructions))
    return pieces


TRIM_SIDE = 12  # the kernels take four samples for each of its square of pixels


def instructions(text: str) -> int:
    """The figure that callgrind ends with."""
    for line in text.splitlines():
        if "Collected" in line:
            return int(line.split(":")[1])
    raise Problem("callgrind counted nothing; it said:\n" + text)


class Store:
    """Answers on disk, one file each. An answer belongs to the command and to the programs' bytes: after a change of the code
    everything is measured anew."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._hashes: dict[str, str] = {}

    def _path(self, piece: Piece) -> pathlib.Path:
        words = []
        for word in piece.command:
            path = pathlib.Path(word)
            is_program = path.is_absolute() and path.is_file() and os.access(path, os.X_OK)
            words.append(self._hash(word) if is_program else word)
        return self.folder / (hashlib.sha256("\0".join(words).encode()).hexdigest()[:24] + ".json")

    def _hash(self, program: str) -> str:
        if program not in self._hashes:
            self._hashes[program] = hashlib.sha256(pathlib.Path(program).read_bytes()).hexdigest()
        return self._hashes[program]

    def get(self, piece: Piece) -> Any | None:
        if not all(file.is_file() for file in piece.files):
            return None
        try:
            return json.loads(self._path(piece).read_text(encoding="utf-8"))["answer"]
        except (OSError, ValueError, KeyError):
            return None

    def put(self, piece: Piece, answer: Any) -> None:
        whole.write(self._path(piece), json.dumps({"piece": piece.name, "answer": answer}))


def measure(piece: Piece, store: Store) -> Any:
    """The stored answer, or a new one."""
    answer = store.get(piece)
    if answer is None:
        done = subprocess.run(piece.command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
        if done.returncode != 0:
            raise Problem(f"{piece.name}: this command failed with exit code {done.returncode}:\n  {' '.join(piece.command)}\n{done.stderr}")
        text = done.stderr if piece.read is instructions else done.stdout  # valgrind speaks beside the program
        try:
            answer = piece.read(text)
        except (ValueError, IndexError) as error:
            raise Problem(f"{piece.name}: the answer cannot be read ({error}):\n{text[:500]}") from error
        store.put(piece, answer)
    return answer


def environment(build: pathlib.Path) -> dict:
    """On what, and with what, it was measured."""
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8", errors="replace")

    def cached(name: str) -> str:
        return next((line.split("=", 1)[1] for line in cache.splitlines() if line.startswith(name + ":")), "")

    processor = platform.processor() or platform.machine()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                processor = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    compiler = cached("CMAKE_CXX_COMPILER")
    commit = subprocess.run(["git", "-C", str(ROOT), "describe", "--always", "--dirty"], stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, text=True, check=False).stdout.strip()
    return {"commit": commit or "not a git checkout", "compiler": (process.capture([compiler, "--version"])[1].splitlines() or [""])[0],
            "flags": f"{cached('CMAKE_CXX_FLAGS')} {cached('CMAKE_CXX_FLAGS_RELEASE')}".strip(), "processor": processor,
            "cores": os.cpu_count(), "load": [round(x, 2) for x in os.getloadavg()], "system": platform.platform()}
