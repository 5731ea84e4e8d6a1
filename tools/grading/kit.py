# SPDX-License-Identifier: MIT
"""What grading a lab takes: the judge, and a folder with all that a student's header is compiled with. Made once for each lab."""

import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import tempfile
from dataclasses import dataclass, field

import process
import student
from grading import scheme
from grading.sandbox import MIB, Level, Limits, Sandbox, level
from labs import ROOT, Lab, Problem

# The names under which the sandbox sees what it may see.
KIT, CODE, OUT = "/grade/kit", "/grade/student", "/grade/out"

COMPILING = Limits(cpu=60, wall=120, memory=1536 * MIB, processes=24, file_size=48 * MIB)
COMPILING_PROGRAM = Limits(cpu=120, wall=240, memory=2048 * MIB, processes=24, file_size=48 * MIB)
WORKING = Limits(cpu=40, memory=1024 * MIB, processes=32, file_size=0)


@dataclass
class Kit:
    lab: Lab
    scheme: scheme.Scheme
    folder: pathlib.Path              # what the sandbox sees as KIT
    judges: list[pathlib.Path]        # of the public tests, and of the hidden ones where there are some
    compiler: list[str]               # with its options
    program_compiler: list[str]
    level: Level
    gate: bool                        # promises that the compiler checks: gate.cpp
    digest: str = ""
    show_hidden: bool = False         # what hidden tests found, too: for an instructor's eyes
    tests: list[dict[str, bool]] = field(default_factory=list)  # by step: each test's name, and whether it is hidden

    @property
    def seen(self) -> dict[str, pathlib.Path]:
        return {KIT: self.folder}

    def worker_command(self) -> list[str]:
        """Compiles and links the worker: the student's header, and no more than its lab's binding and its half of the wire."""
        return [*self.compiler, f"-I{CODE}", f"-I{KIT}/include", f"-I{KIT}/support", "-include", f"{KIT}/support/contract.hpp",
                f"{KIT}/lab/bind.cpp", *(f"{KIT}/worker/{each.name}" for each in sorted((self.folder / "worker").iterdir())), "-o", f"{OUT}/worker"]

    def gate_command(self) -> list[str]:
        return [*self.compiler, f"-I{CODE}", f"-I{KIT}/include", f"-I{KIT}/support", "-fsyntax-only", f"{KIT}/lab/gate.cpp"]

    def program_command(self) -> list[str]:
        return [*self.program_compiler, f"-I{CODE}", f"-I{KIT}/program_include", "-isystem", f"{KIT}/stb",
                f"{KIT}/program/{self.lab.folder}/main.cpp", "-o", f"{OUT}/program"]


def made(lab: Lab, stage: pathlib.Path, *, trust: bool = False, way: str | None = None) -> Kit:
    """Builds the judge and lays out the kit under `stage`, a folder that all users can reach. Refuses where students' code could
    not be isolated, unless `trust`."""
    tree = student.set_up()
    hidden = (lab.tests / "hidden.cpp").exists()
    targets = [f"{lab.name}_judge", *([f"{lab.name}_hidden"] if hidden else []), f"{lab.name}_worker_table", "lantern_worker", "lantern_probe"]
    if hidden and f"{targets[1]}:" not in (tree / "build.ninja").read_text(encoding="utf-8"):  # written since the last configuration
        process.need(["cmake", str(tree)], quiet=True)
    good, output = student.build(tree, *targets)
    if not good:
        raise Problem(f"the judge of lab {lab.number} does not build:\n{student.first_error(output)}")

    seen = isolation(lab, tree, trust, way)
    commands = json.loads((tree / "compile_commands.json").read_text(encoding="utf-8"))
    folder = stage / "kit"
    folder.mkdir()
    compiler = options_of(commands, f"{lab.name}_check_bind.dir/", tree, folder)
    program_compiler = options_of(commands, f"labs/CMakeFiles/{lab.name}.dir/", tree, folder)
    _copy([ROOT / "tests/support/contract.hpp"], folder / "support")
    _copy([lab.tests / "contract.hpp", lab.tests / "bind.cpp", lab.tests / "gate.cpp"], folder / "lab")
    _copy((tree / "labs" / lab.name / "include" / "lantern").glob("*.hpp"), folder / "include" / "lantern")
    for number, file in enumerate(objects_of([f"{lab.name}_worker_table", "lantern_worker"], tree)):
        _copy([file], folder / "worker", f"{number}.o")
    _copy((tree / "labs" / lab.name / "program" / "lantern").glob("*.hpp"), folder / "program_include" / "lantern")
    _copy([path for path in (ROOT / "labs" / lab.folder).glob("*.[ch]pp") if path.name != lab.header], folder / "program" / lab.folder)
    _copy((ROOT / "labs" / "support").glob("*.hpp"), folder / "program" / "support")
    _copy([stb_folder(tree) / "stb_image_write.h"], folder / "stb")

    # Copies: what is built meanwhile changes no judge.
    judges = [shutil.copy(student.program(tree, target), stage / target) for target in targets[:2 if hidden else 1]]
    kit = Kit(lab, scheme.read(lab), folder, judges, compiler, program_compiler, seen, (lab.tests / "gate.cpp").exists())
    kit.digest = digest_of([*(path for path in sorted(folder.rglob("*")) if path.is_file()), *kit.judges], json.dumps([compiler, vars(kit.scheme)], default=vars))
    _precompile(kit, way)
    for path in folder.rglob("*"):
        os.chmod(path, 0o755 if path.is_dir() else 0o644)
    os.chmod(folder, 0o755)
    return kit


def isolation(lab: Lab, tree: pathlib.Path, trust: bool, way: str | None = None) -> Level:
    """What the sandbox holds here. Refuses where students' code could not be isolated, unless `trust`."""
    seen = level(student.program(tree, "lantern_probe"), [ROOT / "solutions", ROOT / "tests", lab.solution_file], way)
    if not seen.isolated and not trust:
        raise Problem(f"the sandbox is {seen}.\nI run no code here that I do not trust. Install bubblewrap (apt-get install bubblewrap), or use a "
                      "machine where it may make namespaces;\nor say --trust, if you trust each of the submissions with all that you may do here")
    return seen


def options_of(commands: list[dict], target: str, tree: pathlib.Path, folder: pathlib.Path) -> list[str]:
    """The compiler and the options with which CMake compiles a target, but for what names files. Folders of headers from outside
    the checkout, such as a GLM that was fetched, come into the kit."""
    entry = next((each for each in commands if target in each["command"]), None)
    if entry is None:
        raise Problem(f"the build has no {target.strip('/')}: remove {tree} and try again")
    kept, words = [], iter(shlex.split(entry["command"]))
    for word in words:
        if word in ("-o", "-include", "-MF", "-MT", "-MQ"):
            next(words)
        elif word == "-isystem" or word.startswith("-I"):
            path = pathlib.Path(next(words) if word == "-isystem" else word[2:])
            if path.is_relative_to(tree / "_deps") and path != stb_folder(tree):
                place = folder / "external" / path.relative_to(tree / "_deps")
                if not place.exists():
                    shutil.copytree(path, place, ignore=shutil.ignore_patterns(".git", "test", "doc"))
                kept += ["-isystem", f"{KIT}/external/{path.relative_to(tree / '_deps')}"]
            elif word == "-isystem" and not path.is_relative_to(ROOT):
                kept += ["-isystem", str(path)]
        elif word not in ("-c", "-Winvalid-pch", "-MD") and not word.endswith((".cpp", ".hxx")) and not word.startswith("-fdiagnostics-color"):
            kept.append(word)
    return [*kept, "-w", "-fmax-errors=3" if "clang" not in kept[0] else "-ferror-limit=3", "-pthread"]


def objects_of(targets: list[str], tree: pathlib.Path) -> list[pathlib.Path]:
    folders = [tree / "tests" / "labs" / "CMakeFiles" / f"{target}.dir" for target in targets]
    return sorted(path for folder in folders for path in folder.rglob("*.o") if not path.name.startswith("cmake_pch"))


def stb_folder(tree: pathlib.Path) -> pathlib.Path:
    found = re.search(r"^LANTERN_STB_INCLUDE_DIR:\w+=(.*)$", (tree / "CMakeCache.txt").read_text(encoding="utf-8"), re.MULTILINE)
    path = pathlib.Path(found[1] if found else "")
    return path if (path / "stb_image_write.h").exists() else tree / "_deps" / "stb-src"


def _copy(files, folder: pathlib.Path, name: str = "") -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        if file.is_file():
            shutil.copyfile(file, folder / (name or file.name))


def _precompile(kit: Kit, way: str | None) -> None:
    """What every binding begins with: half a second less for each student. Kept in build/grading until the compiler or a header of
    it changes. Where it cannot be made they are compiled without it."""
    beside = kit.folder / "support" / "contract.hpp.gch"
    files = [pathlib.Path(kit.compiler[0]).resolve(), *(path for path in map(pathlib.Path, ("/usr/include/glm/vec3.hpp", "/usr/local/include/glm/vec3.hpp")) if path.exists())]
    key = digest_of([kit.folder / "support" / "contract.hpp"], json.dumps([kit.compiler, *((str(file), file.stat().st_mtime_ns, file.stat().st_size) for file in files)]))
    cache = ROOT / "build" / "grading" / f"contract-{key}.gch"
    if cache.exists():
        shutil.copyfile(cache, beside)
        return
    with tempfile.TemporaryDirectory(dir=kit.folder.parent) as scratch, Sandbox(way) as box:
        os.chmod(scratch, 0o711)
        out = box.own(pathlib.Path(scratch) / "out")
        done = box.run([*kit.compiler, f"-I{KIT}/support", "-x", "c++-header", f"{KIT}/support/contract.hpp", "-o", f"{OUT}/{beside.name}"],
                       Limits(cpu=60, wall=120, memory=2048 * MIB, file_size=256 * MIB), readable=kit.seen, writable={OUT: out}, system=True)
        if done.status != 0 or not (out / beside.name).exists():
            return
        shutil.copyfile(out / beside.name, beside)
    cache.parent.mkdir(parents=True, exist_ok=True)
    for old in cache.parent.glob("contract-*.gch"):
        old.unlink(missing_ok=True)
    new = cache.with_suffix(f".{os.getpid()}")
    shutil.copyfile(beside, new)
    new.replace(cache)


def digest_of(files: list[pathlib.Path], text: str = "") -> str:
    total = hashlib.sha256(text.encode())
    for file in files:
        total.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return total.hexdigest()[:16]


def stage_folder() -> tempfile.TemporaryDirectory:
    """A folder that every user can reach, if not list. Those of graders that were killed are removed."""
    base = next((path for path in (tempfile.gettempdir(), "/tmp", "/var/tmp") if _reachable(pathlib.Path(path))), None)
    for old in pathlib.Path(base or "/tmp").glob("lantern-grade-*-*"):
        number = old.name.split("-")[2]
        if number.isdigit() and not _runs(int(number)) and old.stat().st_uid == os.geteuid():
            shutil.rmtree(old, ignore_errors=True)
    folder = tempfile.TemporaryDirectory(prefix=f"lantern-grade-{os.getpid()}-", dir=base, ignore_cleanup_errors=True)
    os.chmod(folder.name, 0o711)
    return folder


def _runs(process_number: int) -> bool:
    try:
        os.kill(process_number, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True


def _reachable(path: pathlib.Path) -> bool:
    return all(each.is_dir() and each.stat().st_mode & 0o001 for each in [path, *path.parents])
