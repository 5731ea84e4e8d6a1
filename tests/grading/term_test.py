# SPDX-License-Identifier: MIT
"""A class of N submissions to lab 06: term_test.py [N]. ./lab grade is killed in the middle and goes on; every mark must be right.

Solutions, starters, mutants and attacks, as folders, zips, tars and bare headers, some of them under hostile names."""

import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import time
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402

LAB = labs.find("06")
ATTACKS = pathlib.Path(__file__).parent / "attacks"
QUICK = ["01_exit", "02_forged_report", "03_atexit", "04_require", "05_main", "06_stolen_channel", "07_always_equal", "08_nan", "10_private_public",
         "11_solution_relative", "12_incbin", "14_dev_zero", "16_huge_object", "25_daemon", "26_preload"]
NAMES = ["=HYPERLINK(1)", "<script>alert(1)<script>", "-rf", "a\x1b[31mb", "zwei\nzeilen", "ünïcode", "same", "SAME", "con..", "a,b\"c"]


def steps_of_tests() -> dict[str, int]:
    """The step that each public test belongs to, as the suite says."""
    text = (LAB.tests / "suite.cpp").read_text(encoding="utf-8")
    return {name: int(step) for name, step in re.findall(r'TEST_CASE\("([^"]+)", "\[step(\d)\]"\)', text)}


class Submission:
    def __init__(self, kind: str, files: dict[str, bytes], right):
        self.kind, self.files, self.right = kind, files, right  # right(points of the steps) -> bool


def generated(count: int) -> list[Submission]:
    solution = LAB.solution_file.read_text(encoding="utf-8")
    at = steps_of_tests()
    found = []

    def add(kind: str, header: str | bytes, right, **others: bytes):
        data = header.encode() if isinstance(header, str) else header
        found.append(Submission(kind, {LAB.header: data} | {name + ".hpp": each for name, each in others.items()}, right))

    def mutant_is_right(mutant: labs.Mutant):
        caught = {at[name] for name in mutant.caught_by}
        return lambda points: all(points[step - 1] == 0 for step in caught) and all(point == 10 for point in points[:min(caught) - 1])

    mutants = LAB.mutants()
    helpers = {name: (ATTACKS / f"{name}.hpp").read_bytes() for name in ("wrong", "only_wrong", "either")}
    i = 0
    while len(found) < count:
        add("solution", solution + f"// {i}\n", lambda points: points == [10] * 5)
        add("starter", labs.starter_of(solution), lambda points: points == [0] * 5)
        for mutant in (mutants[2 * i % len(mutants)], mutants[(2 * i + 1) % len(mutants)]):
            add(f"mutant {mutant.name}", labs.mutate(solution, mutant), mutant_is_right(mutant))
        name = QUICK[i % len(QUICK)]
        text = (ATTACKS / f"{name}.hpp").read_text(encoding="utf-8").replace("@ROOT@", str(ROOT))
        add(f"attack {name}", text, lambda points: points == [0] * 5, **helpers)
        i += 1
    return found[:count]


def handed_in(folder: pathlib.Path, number: int, one: Submission) -> str:
    """Writes a submission in one of four forms; its name."""
    name = NAMES[number // 7] if number % 7 == 3 and number // 7 < len(NAMES) else f"student{number:03}"
    form = number % 4 if len(one.files) == 1 else number % 3
    if form == 0:
        place = folder / name / "labs" / LAB.folder
        place.mkdir(parents=True)
        for file, data in one.files.items():
            (place / file).write_bytes(data)
        (folder / name / "CMakeLists.txt").write_text("message(FATAL_ERROR no)\n")  # attack 28: nobody looks at it
        (folder / name / "CMakePresets.json").write_text("{")
    elif form == 1:
        with zipfile.ZipFile(folder / f"{name}.zip", "w") as made:
            for file, data in one.files.items():
                made.writestr(f"{LAB.folder}/{file}", data)
    elif form == 2:
        with tarfile.open(folder / f"{name}.tar.gz", "w:gz") as made:
            for file, data in one.files.items():
                entry = tarfile.TarInfo(f"x/{file}")
                entry.size = len(data)
                made.addfile(entry, io.BytesIO(data))
    else:
        (folder / f"{name}.hpp").write_bytes(one.files[LAB.header])
    return name


def children_of(session: int) -> list[str]:
    """What still runs that the killed grader had started: judges, workers, compilers."""
    found = []
    for each in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (each / "cmdline").read_bytes().decode(errors="replace").replace("\0", " ")
            if f"lantern-grade-{session}-" in words and "\nState:\tZ" not in (each / "status").read_text():
                found.append(words[:200])
        except OSError:
            continue
    return found


class Class(unittest.TestCase):
    count = 30

    def test_a_class_is_graded_killed_and_graded_to_the_end(self):
        with tempfile.TemporaryDirectory() as scratch:
            submissions, out = pathlib.Path(scratch) / "submissions", pathlib.Path(scratch) / "marks"
            submissions.mkdir()
            all_of_them = generated(self.count)
            names = [handed_in(submissions, i, one) for i, one in enumerate(all_of_them)]
            command = [sys.executable, str(ROOT / "tools" / "lab.py"), "grade", str(submissions), "--lab", LAB.number, "--out", str(out), "--no-pictures"]

            def finished() -> dict[pathlib.Path, int]:
                return {path: path.stat().st_mtime_ns for path in out.glob("students/*/result.json")}

            first = subprocess.Popen([*command, "--no-mistakes"], start_new_session=True, stderr=subprocess.PIPE, text=True)
            while len(finished()) < self.count // 3 and first.poll() is None:
                time.sleep(0.05)
            self.assertIsNone(first.poll(), first.stderr.read() if first.poll() is not None else "")
            first.kill()  # SIGKILL: no chance to tidy up
            first.wait()
            first.stderr.close()
            for _ in range(100):
                if not children_of(first.pid):
                    break
                time.sleep(0.1)
            self.assertEqual(children_of(first.pid), [])
            done = finished()
            self.assertLess(len(done), self.count)

            began = time.monotonic()
            second = subprocess.run([*command, "--no-mistakes"], stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(second.returncode, 0, second.stderr[-2000:])
            self.assertEqual({path: time_ns for path, time_ns in finished().items() if path in done}, done, "what was done is not done again")
            print(f"{self.count - len(done)} of {self.count} in {time.monotonic() - began:.1f} s after the kill", file=sys.stderr)

            results = [json.loads(path.read_text(encoding="utf-8")) for path in out.glob("students/*/result.json")]
            self.assertEqual(len(results), self.count)
            by_name = {result["student"].split(" [")[0]: result for result in results}
            wrong = []
            for name, one in zip(names, all_of_them):
                shown = "".join(c if c.isprintable() or c == "�" else "�" for c in name)
                points = [step["points"] for step in by_name[shown]["steps"]]
                if not one.right(points) or by_name[shown]["score"] != sum(points):
                    wrong.append((name, one.kind, points, by_name[shown]["message"]))
            self.assertEqual(wrong, [])
            self.assertEqual(sum(result["left_running"] for result in results), 0)

            rows = list(csv.reader(io.StringIO((out / "gradebook.csv").read_text(encoding="utf-8"))))
            self.assertEqual(len(rows), self.count + 1)
            self.assertEqual(sum(float(row[2]) for row in rows[1:]), sum(result["score"] for result in results))
            for page in out.rglob("*.html"):
                self.assertNotIn("<script", page.read_text(encoding="utf-8"))
            self.assertFalse([path for path in out.rglob("*.new")])


if __name__ == "__main__":
    if sys.argv[1:]:
        Class.count = int(sys.argv[1])
    unittest.main(argv=[sys.argv[0]])
