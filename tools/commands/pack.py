# SPDX-License-Identifier: MIT
"""The grading of a lab, packed for another machine: an autograder for Gradescope."""

import io
import pathlib
import tarfile
import time
import zipfile

import process
import student
from commands.release import tracked
from labs import ROOT, Problem

SUMMARY = "pack a lab's grading as an autograder for Gradescope"
USAGE = "pack gradescope --lab NN [--out FILE]"

SETUP = """#!/bin/sh
# Gradescope runs this once, when it builds the image. It installs what is missing, builds the judge, and grades the solution.
set -eu
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends python3 python3-pip g++ ninja-build cmake libglm-dev libstb-dev catch2 bubblewrap util-linux
# Lantern needs CMake 3.25; older systems get a newer one from PyPI.
if ! cmake --version | awk 'NR == 1 { split($3, v, "."); exit !(v[1] > 3 || (v[1] == 3 && v[2] >= 25)) }'; then
    python3 -m pip install "cmake>=3.25,<4" || python3 -m pip install --break-system-packages "cmake>=3.25,<4"
    hash -r
fi
root=${AUTOGRADER_ROOT:-/autograder}
mkdir -p "$root/lantern"
tar -xzf "$root/source/lantern.tar.gz" -C "$root/lantern"
cd "$root/lantern"
./lab grade --prepare --lab @LAB@ --trust
# What holds the answers is for the grader alone: students' code runs as another user.
chmod 700 "$root/lantern" "$root/source"
"""

RUN = """#!/bin/sh
# Gradescope runs this for each submission, in a container of its own.
# --trust: such a container allows no namespaces, so the sandbox has less to offer there (the first line of the output says
# what); what it lacks, the container has to give. Where namespaces can be had they are used.
set -eu
root=${AUTOGRADER_ROOT:-/autograder}
chmod 700 "$root/lantern" "$root/source" "$root/results"
out=$(mktemp -d)
cd "$root/lantern"
./lab grade "$root/submission" --one --lab @LAB@ --out "$out" --trust --no-mistakes @OPTIONS@
cp "$out/students/submission/results.json" "$root/results/results.json"
rm -rf "$out"
"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("for_whom", metavar="gradescope", choices=["gradescope"])
    parser.add_argument("--lab", required=True, metavar="NN", help="the lab's number, such as 06")
    parser.add_argument("--out", metavar="FILE", help="where to write the archive (default: out/labNN-gradescope.zip)")
    wish = parser.parse_args(arguments)
    lab = student.lab_named(wish.lab)
    out = pathlib.Path(wish.out) if wish.out else ROOT / "out" / f"{lab.name}-gradescope.zip"
    if str(lab.solution_file.relative_to(ROOT)) not in tracked():
        raise Problem(f"git does not know lab {lab.number} yet, and the archive holds what git knows: git add it first")
    if out.suffix != ".zip":
        raise Problem(f"{out} should end in .zip")
    out.parent.mkdir(parents=True, exist_ok=True)
    written = out.with_suffix(".new")
    with zipfile.ZipFile(written, "w", zipfile.ZIP_DEFLATED) as made:
        for name, text in (("setup.sh", SETUP), ("run_autograder", RUN)):
            entry = zipfile.ZipInfo(name, time.localtime()[:6])
            entry.external_attr = 0o100755 << 16
            made.writestr(entry, text.replace("@LAB@", lab.number).replace("@OPTIONS@", "--no-pictures"))
        made.writestr("lantern.tar.gz", packed())
    written.replace(out)
    print(f"{process.shorten(str(out))}\nIn Gradescope: Configure Autograder, Zip file upload. It holds the solutions: it is for Gradescope alone.")
    return 0


def packed() -> bytes:
    """This checkout, as git knows it, without its history."""
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w:gz") as archive:
        for name in tracked():
            if (ROOT / name).is_file() and not name.startswith(("docs/images/", ".ci/")):
                archive.add(ROOT / name, name, filter=lambda entry: entry.replace(uid=0, gid=0, uname="", gname="", deep=False))
    return stream.getvalue()
