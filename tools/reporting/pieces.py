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

import callgrind
import prices
import process
import whole
from labs import Problem
from process import ROOT

EFFECTS = ["antialiasing", "soft shadow", "gloss", "depth of field", "motion blur", "two effects at once"]
SAMPLERS = ["random", "N-rooks", "jittered", "multi-jittered", "correlated multi-jittered", "Halton", "Sobol"]


def shown(most: int) -> list[int]:
    """Samples of the pictures that are shown: 16, the last, and the one in between; as in bench/convergence.cpp."""
    numbers = [4 ** k for k in range(1, 17) if 4 ** k <= most]
    return [numbers[1], numbers[len(numbers) // 2], numbers[-1]]


@dataclass(frozen=True)
class Counting:
    """What callgrind is to count: all, or what happens within functions; each function by itself, besides."""
    within: str = ""
    by_function: bool = False


@dataclass
class Piece:
    """One program's answer. `command` is run when its key has no answer yet; `read` makes JSON of what it printed, or of the count."""
    section: str
    name: str
    command: list[str]
    seconds: float = 1  # a guess, for the progress bar
    read: Callable[[Any], Any] = json.loads
    files: list[pathlib.Path] = field(default_factory=list)  # what it writes besides
    counting: Counting | None = None
    codes: tuple[int, ...] = (0,)  # exit codes with which there is an answer
    follows: str = ""              # from what else the answer follows


STRUCTURES = ["every", "bvh", "bvh middle", "bvh median", "bvh bottom_up", "grid", "octree", "kd_tree", "wide_bvh"]
KERNELS = ["stripped", "trimmed", "everything"]  # as in tests/trim_kernels.cpp
TRIMMED = ["static", "lens", "motion", "gloss", "shadow", "all"]
RUNGS = 6  # of the ladder, as in bench/ladder.cpp


# Programs of the tests that measure, too. The last one is for GCC alone.
TESTS = {"stress": "stress/stress", "stress_price": "stress/stress_price", "trim_kernels": "trim_kernels"}


def built_tests(tree: pathlib.Path) -> list[str]:
    return [name for name, path in TESTS.items() if (tree / "tests" / path).is_file()]


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
        for rung in range(RUNGS):
            for renderings in (100, 600):
                pieces.append(Piece("ladder", f"instructions of rung {rung}, {renderings} renderings",
                                    [str(programs / "ladder"), "--rung", str(rung), "--renderings", str(renderings)], 2, all_of, counting=Counting()))
    triangles = str(settings["triangles"])
    pieces.append(Piece("accelerators", "accelerators",
                        [str(programs / "trace"), "--json", "--scene", "terrain", "--structure", ",".join(STRUCTURES), "--triangles", triangles,
                         "--rays", triangles, "--rounds", "3"], settings["triangles"] / 2000))
    stress = tree / "tests" / "stress"
    if "stress" in settings["tests"]:
        for name, adapter in (("stability", "library"), ("stability of the textbook", "textbook")):
            pieces.append(Piece("stability", name, [str(stress / "stress"), "--json", "--adapter", adapter], 15, codes=(0, 1)))  # 1: a case fails
    if "stress_price" in settings["tests"]:
        if settings["valgrind"]:
            pieces.append(Piece("stability", "prices", [str(stress / "stress_price"), "once"], 2,
                                lambda count: prices.of_calls(count.called), counting=Counting(by_function=True)))
        else:
            pieces.append(Piece("stability", "prices", [str(stress / "stress_price")], 2, prices.nanoseconds))
    if "trim_kernels" in settings["tests"] and settings["valgrind"]:
        for scene in TRIMMED:
            for kernel in KERNELS:
                pieces.append(Piece("leaving out", f"leaving out: {scene}, {kernel}", [str(tree / "tests" / "trim_kernels"), scene, kernel, str(TRIM_SIDE)],
                                    1, all_of, counting=Counting("*measured*")))
    return pieces


def all_of(count: callgrind.Count) -> int:
    return count.instructions


TRIM_SIDE = 12  # the kernels take four samples for each of its square of pixels


class Store:
    """Answers on disk, one file each. An answer belongs to the command and to the programs' bytes: after a change of the code
    everything is measured anew."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._hashes: dict[str, str] = {}

    def _path(self, piece: Piece) -> pathlib.Path:
        words = [repr(piece.counting)] if piece.counting else []
        words += [piece.follows] if piece.follows else []
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
        said = output(piece)
        try:
            answer = piece.read(said)
        except (ValueError, IndexError) as error:
            raise Problem(f"{piece.name}: the answer cannot be read ({error}):\n{str(said)[:500]}") from error
        store.put(piece, answer)
    return answer


def output(piece: Piece) -> Any:
    """What the program printed, or the count of its instructions."""
    if piece.counting:
        try:
            return callgrind.count(piece.command, within=piece.counting.within, by_function=piece.counting.by_function)
        except callgrind.Failed as problem:
            raise Problem(f"{piece.name}: {problem}") from problem
    done = subprocess.run(piece.command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode not in piece.codes:
        raise Problem(f"{piece.name}: this command failed with exit code {done.returncode}:\n  {' '.join(piece.command)}\n{done.stderr}")
    return done.stdout


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
