# SPDX-License-Identifier: MIT
"""The skeleton of a new lab, in all its places: it builds, its starter fails by name, and its solution passes."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import labs
import process
import whole
from labs import ROOT, Problem

SUMMARY = "make the skeleton of a new lab"
USAGE = "new NN topic [--title TITLE]"

TEMPLATES = ROOT / "tools" / "new_lab"
# Where each template goes; @FOLDER@ is labNN_topic.
PLACES = {
    "header.hpp.in": "solutions/@FOLDER@/@TOPIC@.hpp",
    "lab.json.in": "labs/@FOLDER@/lab.json",
    "README.md.in": "labs/@FOLDER@/README.md",
    "hints.json.in": "labs/@FOLDER@/hints.json",
    "main.cpp.in": "labs/@FOLDER@/main.cpp",
    "grading.json.in": "labs/@FOLDER@/grading.json",
    "contract.hpp.in": "tests/labs/@FOLDER@/contract.hpp",
    "bind.cpp.in": "tests/labs/@FOLDER@/bind.cpp",
    "suite.cpp.in": "tests/labs/@FOLDER@/suite.cpp",
    "hidden.cpp.in": "tests/labs/@FOLDER@/hidden.cpp",
    "mean_of_the_three.mutant.in": "tests/labs/@FOLDER@/mutants/mean_of_the_three.mutant",
}
KEYWORDS = set("""alignas alignof and asm auto bitand bitor bool break case catch char class compl concept const consteval constexpr constinit
continue decltype default delete do double else enum explicit export extern false float for friend goto if inline int long mutable namespace
new noexcept not nullptr operator or private protected public register requires return short signed sizeof static struct switch template
this throw true try typedef typeid typename union unsigned using virtual void volatile while xor""".split())


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("number", metavar="NN", help="the lab's number, 01 to 99, which no other lab has")
    parser.add_argument("topic", help="the name of its header, such as soft_shadows")
    parser.add_argument("--title", help="as the handout calls it (default: the topic, with blanks)")
    wish = parser.parse_args(arguments)
    number, topic = number_of(wish.number), topic_of(wish.topic)
    title = title_of(wish.title if wish.title is not None else topic.replace("_", " "))
    files, lists = made(number, topic, title)
    write(files, lists)
    for path in files:
        print(path.relative_to(ROOT))
    for path in lists:
        print(f"{path.relative_to(ROOT)} lists it")
    if subprocess.run([sys.executable, "-B", str(ROOT / "tests" / "checks" / "readme.py"), "--write"], check=False).returncode == 0:
        print("README.md lists it")
    print(f"\nIts one step is an example. Try it: ./lab check {number}, ./lab check {number} --solution, ./lab mutants {number}. docs/labs.md tells the rest.\n"
          f"Write solutions/lab{number}_{topic}/{topic}.hpp; ./lab starters {number} makes the starter. Then git add all of it: release and pack go by what git knows.")
    return 0


# ---- What is allowed -----------------------------------------------------------------------------------------------

def number_of(word: str) -> str:
    if not re.fullmatch(r"[0-9]{1,2}", word) or int(word) == 0:
        raise process.Misuse(f"'{word}' is no lab's number: that is 01 to 99")
    number = f"{int(word):02}"
    taken = [path.name for place in ("labs", "solutions", "tests/labs") for path in sorted((ROOT / place).glob(f"lab{number}_*"))]
    if taken:
        free = next((f"{i:02}" for i in range(1, 100) if not list((ROOT / "labs").glob(f"lab{i:02}_*"))), "")
        raise process.Misuse(f"{number} is taken by {taken[0]}" + (f"; {free} is free" if free else ""))
    return number


def topic_of(word: str) -> str:
    if not re.fullmatch(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", word) or len(word) > 40:
        raise process.Misuse(f"'{word}' cannot be a header's name here: that is small letters and digits, in words joined by _, with a letter first, "
                             "40 characters at most, such as soft_shadows")
    if word in KEYWORDS:
        raise process.Misuse(f"'{word}' is a word of C++: take another topic")
    other = next((lab for lab in labs.all_labs() if lab.folder[6:] == word), None)
    if other:
        raise process.Misuse(f"the topic '{word}' is lab {other.number}'s")
    if (ROOT / "include" / "lantern" / f"{word}.hpp").exists():
        raise process.Misuse(f"'{word}' is a header of the library (include/lantern/{word}.hpp), and a lab's must not be taken for it")
    return word


def title_of(text: str) -> str:
    if not text.strip() or not text.isprintable() or len(text) > 60 or set(text) & set('"\\@'):
        raise process.Misuse("a title is 1 to 60 printable characters, without quotation marks, backslashes and @")
    return text.strip()


# ---- What is written -----------------------------------------------------------------------------------------------

Texts = dict[pathlib.Path, str]


def made(number: str, topic: str, title: str) -> tuple[Texts, Texts]:
    """The new files, and the lists that name the lab, as they will be."""
    folder = f"lab{number}_{topic}"

    def filled(text: str) -> str:
        for word, value in {"@NUMBER@": number, "@NAME@": f"lab{number}", "@FOLDER@": folder, "@TOPIC@": topic, "@TITLE@": title}.items():
            text = text.replace(word, value)
        return text

    files = {ROOT / filled(place): filled((TEMPLATES / name).read_text(encoding="utf-8")) for name, place in PLACES.items()}
    solution = ROOT / "solutions" / folder / f"{topic}.hpp"
    files[ROOT / "labs" / folder / f"{topic}.hpp"] = labs.starter_of(files[solution], str(solution))
    lists = {
        ROOT / "labs" / "CMakeLists.txt": lambda text: after_earlier(text, number, r"^lantern_lab_program\(lab(\d\d)_\w+\)\n", f"lantern_lab_program({folder})\n"),
        ROOT / "tests" / "labs" / "CMakeLists.txt": lambda text: text.rstrip("\n") + f"\n\nlantern_lab_test({folder} MUTANTS\n  mean_of_the_three)\n",
        ROOT / "CMakePresets.json": lambda text: with_workflow(text, number),
    }
    return files, {path: edit(path.read_text(encoding="utf-8")) for path, edit in lists.items()}


def after_earlier(text: str, number: str, pattern: str, line: str) -> str:
    """With the line behind the last one of an earlier lab, or before the first where there is none. `pattern` finds such lines, and their numbers."""
    found = list(re.finditer(pattern, text, re.MULTILINE))
    if not found:
        raise Problem(f"no lab is listed as I know it ({pattern}); has the list been written in another way?")
    earlier = [each for each in found if each[1] < number]
    at = earlier[-1].end() if earlier else found[0].start()
    return text[:at] + line + text[at:]


def with_workflow(text: str, number: str) -> str:
    """CMakePresets.json with a build preset, a test preset and a workflow for the lab, copied from those of another."""
    for pattern in (r'^    \{"name": "lab(\d\d)", "configurePreset": .*\},?\n', r'^    \{"name": "lab(\d\d)", "inherits": .*\},?\n',
                    r'^    \{\n      "name": "lab(\d\d)",\n(?:      .*\n)+    \},?\n'):
        like = re.search(pattern, text, re.MULTILINE)
        if not like:
            raise Problem("CMakePresets.json lists no lab as I know it; has it been written in another way?")
        entry = re.sub(rf"(?<=lab){like[1]}|(?<=lab ){like[1]}", number, like[0]).rstrip(",\n") + ",\n"
        text = after_earlier(text, number, pattern, entry)
    # What was the last of its list has no comma behind it, and the last one now must have none.
    text = re.sub(r"\}\n(    \{)", r"},\n\1", text)
    text = re.sub(r"\},\n(  \])", r"}\n\1", text)
    json.loads(text)
    return text


def write(files: Texts, lists: Texts) -> None:
    """All or nothing: the folders are written beside their places and renamed, the lists last. Whatever fails is taken back."""
    places: dict[pathlib.Path, pathlib.Path] = {}  # a lab's folder, and where it is written first
    before = {path: path.read_text(encoding="utf-8") for path in lists}
    there: list[pathlib.Path] = []
    try:
        for path, text in files.items():
            place = next(ROOT / root / path.relative_to(ROOT / root).parts[0] for root in ("tests/labs", "labs", "solutions") if path.is_relative_to(ROOT / root))
            if place not in places:
                places[place] = pathlib.Path(tempfile.mkdtemp(prefix=".new-", dir=place.parent))
                places[place].chmod(0o755)
            file = places[place] / path.relative_to(place)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        for place, beside in places.items():
            if place.exists():
                raise Problem(f"{place} is already there")
            beside.rename(place)
            there.append(place)
        for path, text in lists.items():
            whole.write(path, text)
    except BaseException:
        for place in [*there, *(beside for beside in places.values() if beside.exists())]:
            shutil.rmtree(place, ignore_errors=True)
        for path, text in before.items():
            if path.read_text(encoding="utf-8") != text:
                whole.write(path, text)
        raise
