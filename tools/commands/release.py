# SPDX-License-Identifier: MIT
"""The repository that students get: without solutions, mutants, hidden tests and grading; and the proof that it is."""

import functools
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

import labs
import process
from labs import ROOT, Problem

SUMMARY = "write the students' repository: no solutions, mutants or hidden tests"
USAGE = "release DIR [--labs NN...] [--no-build]"

# What a course keeps for itself.
KEPT = re.compile(r"solutions/|grading/|tests/support/(hidden|mutants)\.hpp|tests/grading/|tools/grading/|tests/labs/[^/]+/(mutants/|hidden\.cpp)|labs/[^/]+/grading\.json|\.ci/|"
                  r"tests/labs/((tools|loop|explain)_test\.py|untold/)|tests/report/students_test\.py|tools/reporting/submissions\.py|tools/lab_test\.py|tools/new_lab/|tools/commands/(grade|pack|release|new|mutants|starters)\.py|docs/(labs|instructors)\.md")


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("folder", metavar="DIR", help="a folder that does not exist yet, or is empty")
    parser.add_argument("--labs", nargs="+", metavar="NN", help="only these labs (default: all)")
    parser.add_argument("--no-build", action="store_true", help="do not try whether the copy configures and its first starter builds")
    wish = parser.parse_args(arguments)
    chosen = [lab for lab in labs.all_labs() if not wish.labs or any(lab == labs.find(word) for word in wish.labs)]
    if not chosen or (wish.labs and len(chosen) != len(set(wish.labs))):
        raise process.Misuse("--labs names labs that there are; see ./lab list")
    out = pathlib.Path(wish.folder).resolve()
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise Problem(f"{out} is not empty")
    if out.is_relative_to(ROOT):
        raise Problem("the students' copy belongs outside this repository")

    count = copy(chosen, out)
    proof = leaks(out, chosen)
    if proof:
        shutil.rmtree(out)
        raise Problem("nothing was released, since the copy would have held:\n" + "\n".join(proof))
    print(f"{count} files. None of them is a solution, a mutant or a hidden test, or holds what only those hold;\n"
          f"each starter is what its solution generates.")
    if not wish.no_build:
        builds(out, chosen[0])
    print(f"\nNext: cd {process.shorten(str(out))} && git init && git add . && git commit, and push that. Its history begins there: this one's holds the solutions.")
    return 0


@functools.cache
def tracked() -> list[str]:
    """What git knows of, as it stands in the folder: nothing that lies about by chance."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        raise Problem("./lab release needs git, and a checkout, to know which files belong to the course")
    return [name for name in listed.stdout.split("\0") if name]


@functools.cache
def places() -> set[str]:
    """What git knows of, and the folders that it is in."""
    return {*tracked(), *(parent.as_posix() for name in tracked() for parent in pathlib.PurePosixPath(name).parents)}


def copy(chosen: list[labs.Lab], out: pathlib.Path) -> int:
    folders = {lab.folder for lab in chosen}
    count = 0
    for name in tracked():
        path = pathlib.PurePosixPath(name)
        lab = next((part for part in path.parts if re.fullmatch(r"lab\d\d_\w+", part)), None)
        if KEPT.match(name) or (lab and lab not in folders) or not (ROOT / name).is_file():
            continue
        target = out / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, target)
        count += 1
    for lab in chosen:  # whatever the author has in the starter's place
        (out / "labs" / lab.folder / lab.header).write_text(lab.starter(), encoding="utf-8")
    subprocess.run([sys.executable, "-B", str(out / "tests" / "checks" / "readme.py"), "--write"], check=True)  # the table of the labs that are there
    unlink(out)
    lists = out / "tests" / "labs" / "CMakeLists.txt"
    text = lists.read_text(encoding="utf-8")
    text = re.sub(r"(?<=lantern_lab_test\()(\w+) MUTANTS[^()]*?(\s+LIBRARIES[^()]*)?\)", r"\1\2)", text)
    text = re.sub(r"^.*(tools|loop)_test\.py[^)]*\)\n(  \"[^\n]*\n)?", "", text, flags=re.MULTILINE)
    text = re.sub(r"^(set_tests_properties\(labs/(?:tools|loop)|  \"\$\{CMAKE_CXX_COMPILER\}\" -std).*\n", "", text, flags=re.MULTILINE)
    lists.write_text(text, encoding="utf-8")
    return count


LINK = re.compile(r"!?\[([^\]]*)\]\(([^)\s#:]+)(?:#[^)]*)?\)")


def dead_links(page: pathlib.Path, out: pathlib.Path) -> list[re.Match]:
    """The links of a page of the copy to what stayed behind. (What looks like a link to what was never there is C++: a lambda.)"""
    here = page.parent.relative_to(out).as_posix()
    return [link for link in LINK.finditer(page.read_text(encoding="utf-8"))
            if (target := posixpath.normpath(posixpath.join(here, link[2]))) in places() and not (out / target).exists()]


def unlink(out: pathlib.Path) -> None:
    """Leaves the words of each dead link."""
    for page in out.rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        for link in reversed(dead_links(page, out)):
            text = text[:link.start()] + link[1] + text[link.end():]
        page.write_text(text, encoding="utf-8")


# ---- The proof: by what the copy holds, not by how it was made -----------------------------------------------------

def regions(solution: str) -> list[str]:
    """What stands between the marks of a solution: what the student is to write."""
    return re.findall(rf"{labs.BEGIN}\n(.*?){labs.END}", solution, re.DOTALL)


def squeezed(text: str) -> str:
    """Without comments and white space, so that no other layout hides a copy."""
    return re.sub(r"\s+", "", re.sub(r"//[^\n]*", "", text))


def leaks(out: pathlib.Path, chosen: list[labs.Lab]) -> list[str]:
    """What the copy holds that it must not."""
    found = []
    secrets: dict[str, str] = {}
    for lab in labs.all_labs():
        for number, region in enumerate(regions(lab.solution_file.read_text(encoding="utf-8")), 1):
            code = squeezed(region)
            if len(code) >= 60:  # one that is shorter is no secret: any header may hold `return a + b;`
                secrets[code] = f"region {number} of lab {lab.number}'s solution"
        for mutant in (lab.tests / "mutants").glob("*.mutant"):
            for line in re.findall(r"^(?:caught by|who): .{20,}", mutant.read_text(encoding="utf-8"), re.MULTILINE):
                secrets[squeezed(line)] = f"the mutant {mutant.stem} of lab {lab.number}"
    secrets["hidden::drawn("] = "a hidden test"
    for path in sorted(out.rglob("*")):
        name = path.relative_to(out).as_posix()
        if ".git" in path.relative_to(out).parts or path.suffix == ".mutant" or path.name == "hidden.cpp" or name.startswith("solutions"):
            found.append(name)
        if not path.is_file() or name.startswith("include/"):  # the library is everybody's
            continue
        text = squeezed(path.read_bytes().decode(errors="replace"))
        found += [f"{name}: {what}" for secret, what in secrets.items() if secret in text]
    for lab in chosen:
        starter = out / "labs" / lab.folder / lab.header
        if not starter.exists() or starter.read_text(encoding="utf-8") != lab.starter():
            found.append(f"labs/{lab.folder}/{lab.header}, which is not the starter")
    return found


def builds(out: pathlib.Path, lab: labs.Lab) -> None:
    """The copy by itself: its first starter builds, and each of its steps is still to do."""
    process.show(["./lab", "check", lab.number])
    said = subprocess.run([str(out / "lab"), "check", lab.number], cwd=out, capture_output=True, text=True, check=False)
    shutil.rmtree(out / "build", ignore_errors=True)
    if said.stdout.count("still to do") != len(lab.steps):
        raise Problem(f"the copy in {out} does not work:\n{said.stdout}\n{said.stderr}")
    print(f"In the copy lab {lab.number} builds, and each of its steps is still to do.")
