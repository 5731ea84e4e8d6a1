# SPDX-License-Identifier: MIT
"""What the tools know about a lab: where its files are, how a starter comes out of a solution, what a mutant is."""

import json
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

ROOT = pathlib.Path(__file__).resolve().parent.parent


class Problem(Exception):
    """Something the user can mend; the message says how. Shown without a traceback."""


@dataclass
class Lab:
    folder: str  # lab01_picture
    title: str
    headers: list[str]
    steps: list[str]
    program: list[str] = field(default_factory=list)

    @property
    def number(self) -> str:
        return self.folder[3:5]

    @property
    def name(self) -> str:  # also the namespace of the student's code, and the root of the names of all targets
        return self.folder[:5]

    @property
    def header(self) -> str:  # picture.hpp
        return self.folder[6:] + ".hpp"

    @property
    def student_file(self) -> pathlib.Path:
        return ROOT / "labs" / self.folder / self.header

    @property
    def handout(self) -> pathlib.Path:
        return ROOT / "labs" / self.folder / "README.md"

    @property
    def solution_file(self) -> pathlib.Path:
        return ROOT / "solutions" / self.folder / self.header

    @property
    def tests(self) -> pathlib.Path:
        return ROOT / "tests" / "labs" / self.folder

    def starter(self) -> str:
        """What a student begins with: made out of the solution or, in a course's copy, which has none, as it was committed first."""
        if self.solution_file.exists():
            return starter_of(self.solution_file.read_text(encoding="utf-8"), str(self.solution_file))
        shown = self.student_file.relative_to(ROOT).as_posix()
        first = git("log", "--diff-filter=A", "--format=%H", "--", shown)
        text = git("show", f"{first.split()[-1]}:{shown}") if first else None
        if text is None:
            raise Problem(f"neither a solution nor the first version of {shown} in git is here to make the starter of")
        return text

    def mutants(self) -> list["Mutant"]:
        return [read_mutant(path) for path in sorted((self.tests / "mutants").glob("*.mutant"))]


def all_labs() -> list[Lab]:
    return [Lab(path.parent.name, **json.loads(path.read_text(encoding="utf-8")))
            for path in sorted((ROOT / "labs").glob("lab[0-9][0-9]_*/lab.json"))]


def find(word: str) -> Lab | None:
    """The lab that `03`, `3`, `lab03` or `lab03_whitted` names."""
    return next((lab for lab in all_labs() if word in (lab.number, lab.number.lstrip("0"), lab.name, lab.folder)), None)


# ---- Starters ------------------------------------------------------------------------------------------------------

BEGIN, END, STARTER = "// BEGIN SOLUTION", "// END SOLUTION", "// STARTER:"


def starter_of(solution: str, name: str = "solution") -> str:
    """The solution without what stands between BEGIN and END, and with the STARTER lines uncommented."""
    kept, inside = [], False
    for number, line in enumerate(solution.splitlines(), 1):
        mark = line.strip()
        if mark in (BEGIN, END):
            if inside == (mark == BEGIN):
                raise Problem(f"{name}:{number}: {mark} where another stands open, or none")
            inside = not inside
        elif mark.startswith(STARTER):
            if inside:
                raise Problem(f"{name}:{number}: a STARTER line belongs after END SOLUTION")
            kept.append((line[:line.index("//")] + mark[len(STARTER):].removeprefix(" ")).rstrip())
        elif not inside:
            kept.append(line)
    if inside:
        raise Problem(f"{name}: the last region has no {END}")
    return "\n".join(kept) + "\n"


def git(*words: str) -> str | None:
    """What git answers in this repository; None where it fails, or is not here."""
    try:
        done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, encoding="utf-8", errors="replace", check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def differs_from_commit(path: pathlib.Path) -> bool:
    """Whether somebody has worked on the file since the last commit. Without git: yes, to be on the safe side."""
    status = git("status", "--porcelain", "--", str(path))
    return status is None or status.strip() != ""


# ---- Mutants -------------------------------------------------------------------------------------------------------

@dataclass
class Mutant:
    name: str
    who: str             # whose real mistake it is
    caught_by: list[str]  # the tests that must fail
    edits: list[tuple[str, str]]


def read_mutant(path: pathlib.Path) -> Mutant:
    """
    who: whose real mistake it is, in a line
    caught by: the name of a test that must fail (a line for each)
    --- find
    text of the solution, once in it
    --- replace
    what stands there in the mutant (find and replace may be repeated)
    """
    head, *parts = re.split(r"^--- (find|replace)[ \t]*\n", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    keys = [line.split(": ", 1) for line in head.splitlines() if line.strip() and not line.startswith("#")]
    who = [value for key, value in keys if key == "who"]
    caught_by = [value.strip() for key, value in keys if key == "caught by"]
    words, texts = parts[0::2], [text.removesuffix("\n") for text in parts[1::2]]
    if len(who) != 1 or not caught_by or not words or words != ["find", "replace"] * (len(words) // 2):
        raise Problem(f"{path}: a mutant has one 'who:', a 'caught by:' for each test, and pairs of '--- find' and '--- replace'")
    return Mutant(path.stem, who[0], caught_by, list(zip(texts[0::2], texts[1::2])))


def mutate(solution: str, mutant: Mutant) -> str:
    for find_text, replacement in mutant.edits:
        if solution.count(find_text) != 1:
            raise Problem(f"mutant {mutant.name}: the text to find stands {solution.count(find_text)} times in the solution:\n{find_text}")
        solution = solution.replace(find_text, replacement)
    return solution


def hoisted(code: str) -> tuple[list[str], str]:
    """The #include lines of a file, and the file with empty lines in their place."""
    includes = re.findall(r"^#include .*", code, re.MULTILINE)
    return includes, re.sub(r"^#(include |pragma once).*", "", code, flags=re.MULTILINE)


def mutants_in_files(solution_path: pathlib.Path, bind_path: pathlib.Path, mutants: list[Mutant], count: int) -> list[str]:
    """All mutants of a lab as `count` files, each with the binding in a namespace of its own, so that the library is read once for many.
    LANTERN_MUTANT says which one answers; the first file refuses a name that none of them has."""
    solution = solution_path.read_text(encoding="utf-8")
    bind_includes, bind = hoisted(bind_path.read_text(encoding="utf-8"))
    mutated = f"<{solution_path.parent.name}/{solution_path.name}>"
    own = [re.sub('"(.*)"', rf'"{bind_path.parent}/\1"', line) for line in bind_includes if mutated not in line]
    names = ", ".join(f'"{mutant.name}"' for mutant in mutants)
    files = []
    for i in range(count):
        includes, parts = dict.fromkeys(own), []
        for mutant in mutants[i::count]:
            header_includes, header = hoisted(mutate(solution, mutant))
            includes |= dict.fromkeys(header_includes)
            parts.append(f"namespace mutant_{mutant.name} {{\n"
                         f"namespace contract {{\nusing namespace ::contract;\ntemplate <auto Function, class Code>\n"
                         f'binding bind(Code code) {{ return mutants::bind<Function>("{mutant.name}", std::move(code)); }}\n}}\n'
                         f'#line 1 "mutant {mutant.name}"\n{header}\n#line 1 "bind.cpp for {mutant.name}"\n{bind}\n}}\n')
        known = f"namespace {{\nconst mutants::only known({{{names}}});\n}}\n" if i == 0 else ""
        files.append("// SPDX-License-Identifier: MIT\n// Made out of the solution and its mutants by tools/labs.py.\n\n"
                     + "\n".join(includes) + "\n#include <mutants.hpp>\n\n" + known + "\n".join(parts))
    return files


# ---- Judge and worker ----------------------------------------------------------------------------------------------

def functions_of(contract: str, name: str = "contract.hpp") -> list[str]:
    """The functions that a contract declares, with their namespace, in their order."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", contract, flags=re.DOTALL)
    inside = re.search(r"\bnamespace\s+(contract::lab\d\d)\b", code)
    names = re.findall(r"\binline\s+constexpr\s+function\s*<[^;]*>\s*(\w+)\s*;", code)
    if not inside or not names or len(names) != len(re.findall(r"\bfunction\s*<\s*\"", code)):
        raise Problem(f"{name}: each function is to be declared as inline constexpr function<\"name\", result(parameters)> name; "
                      "in namespace contract::labNN")
    return [f"{inside[1]}::{each}" for each in names]


def table_of(side: str, contract_path: pathlib.Path) -> str:
    """The judge's or the worker's table: all functions of the contract, by number."""
    names = functions_of(contract_path.read_text(encoding="utf-8"), str(contract_path))
    line = {"judge": "ask_worker", "worker": "answer"}[side]
    rows = "".join(f"    contract::{side}::{line}<{name}>({i}),\n" for i, name in enumerate(names))
    return (f"// SPDX-License-Identifier: MIT\n// Made out of the contract by tools/labs.py.\n\n#include <{side}.hpp>\n\n"
            f"#include \"{contract_path}\"\n\nnamespace {{\n\n[[maybe_unused]] const contract::table lab{{\n{rows}}};\n\n}}  // namespace\n")


# The build's way in: labs.py starter SOLUTION OUT, labs.py judge|worker CONTRACT OUT, labs.py mutants SOLUTION BIND FOLDER COUNT MUTANT...
if __name__ == "__main__":
    import sys
    action, source, *rest = sys.argv[1:]
    try:
        text = pathlib.Path(source).read_text(encoding="utf-8")
        if action == "mutants":
            bind, folder, count, *mutants = rest
            made = mutants_in_files(pathlib.Path(source), pathlib.Path(bind), [read_mutant(pathlib.Path(path)) for path in mutants], int(count))
            outputs = {pathlib.Path(folder) / f"{i}.cpp": file for i, file in enumerate(made)}
        elif action == "starter":
            outputs = {pathlib.Path(rest[0]): starter_of(text, source)}
        else:
            outputs = {pathlib.Path(rest[0]): table_of(action, pathlib.Path(source))}
        for out, file in outputs.items():
            out.parent.mkdir(parents=True, exist_ok=True)
            if not out.exists() or out.read_text(encoding="utf-8") != file:  # what stays as it is need not be compiled again
                out.write_text(file, encoding="utf-8")
    except Problem as problem:
        sys.exit(str(problem))
