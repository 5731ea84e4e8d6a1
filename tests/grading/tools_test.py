# SPDX-License-Identifier: MIT
"""The tools around the grading: archives, macros, points, reports, pictures, mistakes. No compiler and no sandbox needed."""

import csv
import io
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tarfile
import tempfile
import time
import unittest
import xml.etree.ElementTree as ET
import zipfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import macros  # noqa: E402
import ppm_to_png  # noqa: E402
import verdict  # noqa: E402
from commands import release  # noqa: E402
from grading import archive, kit, mistakes, overview, pictures, report, scheme, submission, term  # noqa: E402
from grading.sandbox import Level  # noqa: E402

LAB = labs.find("06")


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Archives(Scratch):
    def zipped(self, *entries: tuple[str | zipfile.ZipInfo, bytes], how=zipfile.ZIP_DEFLATED) -> pathlib.Path:
        path = self.folder / "a.zip"
        with zipfile.ZipFile(path, "w", how) as made:
            for name, data in entries:
                made.writestr(name, data)
        return path

    def tarred(self, *entries: tarfile.TarInfo, ending: str = "tar.gz") -> pathlib.Path:
        path = self.folder / f"a.{ending}"
        with tarfile.open(path, "w:" + ending.removeprefix("tar").removeprefix(".")) as made:
            for entry in entries:
                made.addfile(entry, io.BytesIO(b"x" * entry.size) if entry.isreg() else None)
        return path

    @staticmethod
    def entry(name: str, kind: bytes = tarfile.REGTYPE, size: int = 1, link: str = "") -> tarfile.TarInfo:
        made = tarfile.TarInfo(name)
        made.type, made.linkname = kind, link
        made.size = size if kind == tarfile.REGTYPE else 0
        return made

    def refused(self, path: pathlib.Path, why: str):
        with self.assertRaises(archive.Refused) as caught:
            archive.read(path)
        self.assertIn(why, str(caught.exception))
        self.assertTrue(str(caught.exception).isprintable())

    def test_headers_come_out_of_folders_zips_and_tars(self):
        self.assertEqual(archive.read(self.zipped(("lab/glossy.hpp", b"x"), ("lab/report.pdf", b"y"))), {pathlib.PurePosixPath("lab/glossy.hpp"): b"x"})
        for ending in ("tar", "tar.gz", "tar.xz", "tar.bz2"):
            self.assertEqual(archive.read(self.tarred(self.entry("./glossy.hpp"), ending=ending)), {pathlib.PurePosixPath("glossy.hpp"): b"x"})
        student = self.folder / "student"
        (student / "build").mkdir(parents=True)
        (student / "glossy.hpp").write_bytes(b"x")
        (student / "build" / "glossy.hpp").write_bytes(b"old")
        self.assertEqual(archive.read(student), {pathlib.PurePosixPath("glossy.hpp"): b"x"})
        self.assertEqual(archive.read(student / "glossy.hpp"), {pathlib.PurePosixPath("glossy.hpp"): b"x"})

    def test_paths_that_lead_out_are_refused(self):
        for name in ("../glossy.hpp", "a/../../glossy.hpp", "/etc/glossy.hpp", "..\\glossy.hpp", "C:\\glossy.hpp"):
            self.refused(self.zipped((name, b"x")), "leads out")
            self.refused(self.tarred(self.entry(name)), "leads out")

    def test_links_and_devices_are_refused(self):
        link = zipfile.ZipInfo("glossy.hpp")
        link.external_attr = 0o120777 << 16
        self.refused(self.zipped((link, b"/etc/passwd")), "link")
        for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.CHRTYPE, tarfile.FIFOTYPE):
            self.refused(self.tarred(self.entry("glossy.hpp", kind, link="/etc/passwd")), "link")
        outside = self.folder / "outside.hpp"
        outside.write_bytes(b"secret")
        (self.folder / "link.hpp").symlink_to(outside)
        self.refused(self.folder / "link.hpp", "link")

    def test_links_and_pipes_in_a_folder_are_not_followed(self):
        student = self.folder / "student"
        student.mkdir()
        (self.folder / "outside").mkdir()
        (self.folder / "outside" / "secret.hpp").write_bytes(b"secret")
        (student / "glossy.hpp").symlink_to(self.folder / "outside" / "secret.hpp")
        (student / "folder").symlink_to(self.folder / "outside")
        os.mkfifo(student / "pipe.hpp")
        self.assertEqual(archive.read(student), {})

    def test_bombs_are_refused(self):
        self.refused(self.zipped(("glossy.hpp", bytes(archive.LARGEST_FILE + 1))), "larger than 1 MiB")
        self.refused(self.zipped(*((f"{i}.hpp", bytes(1 << 20)) for i in range(65))), "larger than 64 MiB")
        self.refused(self.zipped(("movie.bin", bytes(archive.LARGEST_ALL + 1))), "larger than 64 MiB")
        self.refused(self.tarred(self.entry("movie.bin", size=archive.LARGEST_ALL + 1), ending="tar.xz"), "larger than 64 MiB")
        self.refused(self.zipped(*((f"{i}", b"") for i in range(archive.MOST_ENTRIES + 1)), how=zipfile.ZIP_STORED), "more than")

    def test_a_zip_that_lies_about_a_size_is_refused(self):
        path = self.zipped(("glossy.hpp", bytes(3 << 20)))
        data = bytearray(path.read_bytes())
        for mark, at in ((b"PK\x01\x02", 24), (b"PK\x03\x04", 22)):
            struct.pack_into("<I", data, data.index(mark) + at, 100)
        path.write_bytes(data)
        with self.assertRaises(archive.Refused):
            archive.read(path)

    def test_what_is_broken_is_refused(self):
        for name in ("a.zip", "a.tar", "a.tar.gz", "a.tar.xz"):
            (self.folder / name).write_bytes(b"PK\x03\x04 broken")
            self.refused(self.folder / name, "cannot be read")
        (self.folder / "a.docx").write_bytes(b"x")
        self.refused(self.folder / "a.docx", "I read")
        self.refused(self.zipped(("glossy.hpp", b"1"), ("glossy.hpp", b"2")), "twice")


class Places(unittest.TestCase):
    def placed(self, *names: str) -> tuple[dict[str, bytes], str]:
        return archive.placed({pathlib.PurePosixPath(name): name.encode() for name in names}, LAB)

    def test_the_header_of_the_labs_own_folder_is_taken(self):
        root, where = self.placed("glossy.hpp", "me/labs/lab06_glossy/glossy.hpp", "me/labs/lab06_glossy/mine.hpp", "me/labs/lab05_soft_shadows/soft_shadows.hpp", "other.hpp")
        self.assertEqual(where, "me/labs/lab06_glossy/glossy.hpp")
        self.assertEqual(sorted(root), ["lab05_soft_shadows/soft_shadows.hpp", "lab06_glossy/glossy.hpp", "lab06_glossy/mine.hpp"])

    def test_a_single_header_may_have_any_name(self):
        self.assertEqual(self.placed("smith_1234_glossy(2).hpp")[0]["lab06_glossy/glossy.hpp"], b"smith_1234_glossy(2).hpp")

    def test_without_the_header_there_is_nothing_to_grade(self):
        for names in ((), ("a.hpp", "b.hpp")):
            with self.assertRaises(archive.Refused):
                self.placed(*names)

    def test_no_file_comes_to_stand_elsewhere(self):
        root, _ = self.placed("glossy.hpp", ".hidden.hpp", "ü.hpp", "\x1b.hpp", "contract.hpp")
        self.assertEqual(sorted(root), ["lab06_glossy/contract.hpp", "lab06_glossy/glossy.hpp"])


class Macros(unittest.TestCase):
    def test_a_guard_may_stay(self):
        self.assertEqual(macros.left_behind("// hello\n#ifndef GLOSSY_HPP\n#define GLOSSY_HPP\nint x;\n#endif\n"), [])
        self.assertEqual(macros.left_behind("#pragma once\n#define SQUARE(x) ((x) * (x))\n#undef SQUARE\n"), [])

    def test_whatever_else_stays_is_found(self):
        for text in ("#define EPS 1e-4\n", "#ifndef A\n#define B\n#endif\n", " # define EPS\n", "%:define EPS\n", "#de\\\nfine EPS\n", "/* x */ #define EPS\n",
                     "#undef assert\n", "#define A\n#undef A\n#define A\n", "int x; /*\n*/\n#define X\n", "auto s = \"/*\";\n#define X\n// */\n"):
            self.assertEqual(len(macros.left_behind(text)), 1, text)

    def test_what_is_no_directive_is_none(self):
        for text in ("// #define A\n", "/*\n#define A\n*/\n", 'auto s = R"(\n#define A\n)";\n', 'auto s = "#define A";\n', "auto c = '\"'; // #define A\n"):
            self.assertEqual(macros.left_behind(text), [], text)

    def test_no_solution_leaves_one(self):
        for lab in labs.all_labs():
            self.assertEqual(macros.left_behind(lab.solution_file.read_text(encoding="utf-8")), [])


class Points(unittest.TestCase):
    def marks(self, public: str, hidden: str = "") -> list[scheme.Mark]:
        return [scheme.Mark("", each == "+", kind) for kind, text in ((False, public), (True, hidden)) for each in text]

    def test_a_step_is_all_or_nothing_unless_it_says_so(self):
        step = scheme.StepScheme(points=20)
        self.assertEqual(scheme.score(step, self.marks("+++", "+")), 20)
        for public, hidden in (("++-", "+"), ("+++", "-"), ("", "")):
            self.assertEqual(scheme.score(step, self.marks(public, hidden)), 0)

    def test_partial_credit(self):
        step = scheme.StepScheme(points=20, partial=0.5)
        self.assertEqual(scheme.score(step, self.marks("+++")), 20)
        self.assertEqual(scheme.score(step, self.marks("++--")), 5)
        self.assertEqual(scheme.score(step, self.marks("++++", "-")), 5)   # known by heart
        self.assertEqual(scheme.score(step, self.marks("++--", "+")), 7.5)
        self.assertEqual(scheme.score(step, self.marks("---")), 0)

    def test_what_is_written_wrongly_is_named(self):
        for said, word in (({"step": []}, "step"), ({"steps": [{}]}, "5"), ({"steps": [{"points": -1}] * 5}, "points"), ({"steps": [{"partial": 2}] * 5}, "partial"),
                           ({"steps": [{"visibility": "secret"}] * 5}, "visibility"), ({"seconds": {"call": 0}}, "seconds"), ({"macros": "no"}, "macros")):
            with self.assertRaises(ValueError) as caught:
                scheme.parse(said, LAB)
            self.assertIn(word, str(caught.exception))

    def test_every_lab_has_a_scheme(self):
        for lab in labs.all_labs():
            self.assertGreater(scheme.read(lab).total, 0)


HOSTILE = "=cmd|'/C calc'!A0 \x1b]0;x\x07<script>alert(1)</script>\"'&]]>\x00\u202e\ud800"


def example(student_text: str = HOSTILE) -> tuple[kit.Kit, dict]:
    made = kit.Kit(LAB, scheme.Scheme([scheme.StepScheme() for _ in LAB.steps]), pathlib.Path(), [], [], [], Level(True, ["all"]), False)
    steps = [{"name": name, "points": 10 * (i != 1), "of": 10, "trouble": "", "tests": [
        {"name": "a public test", "passed": i != 1, "hidden": False, "gap": False, "says": [] if i != 1 else [student_text]},
        {"name": "a hidden test", "passed": i != 1, "hidden": True, "gap": False, "says": []}]} for i, name in enumerate(LAB.steps)]
    return made, {"lab": "06", "status": "graded", "message": student_text, "score": 40.0, "of": 50, "seed": 1, "steps": steps, "pictures": ["a.png", '"><script>'], "left_running": 0,
                  "mistakes": [{"name": student_text, "who": student_text, "sure": True}]}


class Reports(Scratch):
    def test_pages_hold_no_markup_of_students(self):
        made, result = example()
        for page in (report.student_page(made, result, HOSTILE), overview.overview(made, [(HOSTILE, result)], {HOSTILE: "x"}, 1)):
            self.assertNotIn("<script", page)
            self.assertNotRegex(page, "[\x00-\x08\x0b-\x1f\x7f\u202e\ud800]")
            self.assertNotIn("='/C", page)
            self.assertIn("&lt;script&gt;", page)
            page.encode("utf-8")

    def test_junit_is_xml(self):
        _, result = example()
        root = ET.fromstring(report.junit(result, HOSTILE).encode("utf-8"))
        self.assertEqual(sum(int(suite.get("failures")) for suite in root), 2)
        self.assertEqual(len(root.findall(".//failure")), 2)
        self.assertIn("alert(1)", root.find(".//failure").text)

    def test_gradescope_gets_points_by_step_and_only_the_names_of_hidden_tests(self):
        made, result = example()
        made.scheme.steps[0].hidden = "after_due_date"
        said = json.loads(report.gradescope(made, result))
        self.assertEqual(said["score"], 40)
        self.assertEqual([test["score"] for test in said["tests"] if "score" in test], [10, 0, 10, 10, 10])
        hidden = [test for test in said["tests"] if "a hidden test" in test["name"]]
        self.assertEqual([test["output"] for test in hidden], [""] * 5)
        self.assertEqual(hidden[0]["visibility"], "after_due_date")

    def test_no_cell_is_a_formula(self):
        made, result = example()
        rows = list(csv.reader(io.StringIO(overview.gradebook(made, [(name, result) for name in (HOSTILE, "+1", "-1", "@x", " =1", "\t=1", "＝1", "Ann, \"B\"")]))))
        self.assertEqual(len(rows), 9)
        for row in rows[1:]:
            self.assertNotRegex(row[0], r"^\s*[=+\-@|%\t＝]")
            self.assertEqual(row[2:4], ["40", "50"])
            self.assertTrue(row[-1].startswith("'="))

    def test_changes_list_whose_points_are_others_than_before(self):
        _, result = example()
        rows = [("ann", result | {"before": 30.0}), ("bob", result | {"before": 40.0}), ("new", result | {"before": None}), ("old", result), (HOSTILE, result | {"before": 0}),
                ("broken", result | {"before": 30.0, "status": "error"})]
        told = list(csv.reader(io.StringIO(overview.changes(rows))))
        self.assertEqual(told[0], ["student", "before", "now", "of"])
        self.assertEqual([row[1:] for row in told[1:]], [["30", "40", "50"], ["0", "40", "50"]])
        self.assertEqual(told[1][0], "ann")
        self.assertTrue(told[2][0].startswith("'="))

    def test_names_become_folders_of_their_own(self):
        for name in ("ann", "ANN.zip", "a\nb", "a b", "=x", "ünal", "con..", "-rf"):
            (self.folder / name).mkdir()
        folders = [student.folder for student in term.students(self.folder)]
        self.assertEqual(len({folder.lower() for folder in folders}), 8)
        for folder in folders:
            self.assertRegex(folder, r"^[A-Za-z0-9_-][A-Za-z0-9._-]*$")
        self.assertTrue(all(student.name.isprintable() for student in term.students(self.folder)))


class Pictures(unittest.TestCase):
    def png(self, width: int, height: int, rows: bytes, extra: bytes = b"") -> bytes:
        return pictures.written(struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0), rows)[:-12] + extra + ppm_to_png.chunk(b"IEND", b"")

    def test_only_pixels_are_kept(self):
        rows = (b"\0" + b"abc" * 4) * 3
        made = pictures.as_png(self.png(4, 3, rows, ppm_to_png.chunk(b"tEXt", b"<script>")) + b"<script>")
        self.assertEqual(made, self.png(4, 3, rows))
        self.assertIsNotNone(pictures.as_png(b"P3\n2 1\n255\n1 2 3 4 5 6\n"))

    def test_what_is_no_picture_or_too_large_is_left_out(self):
        rows = (b"\0" + b"abc" * 4) * 3
        bomb = self.png(4, 3, rows).replace(struct.pack(">II", 4, 3), struct.pack(">II", 1 << 19, 1 << 19))
        for data in (b"", b"<html>", b"\x89PNG\r\n\x1a\n", self.png(4, 4, rows), self.png(4, 3, b"\x09" + rows[1:]), bomb, b"P3\n2 1\n255\n1 2 3\n", b"P6 9 9 255 x",
                     b"\x89PNG\r\n\x1a\n" + ppm_to_png.chunk(b"IHDR", b"\0" * 13) + ppm_to_png.chunk(b"IDAT", zlib.compress(bytes(100)))):
            self.assertIsNone(pictures.as_png(data), data[:20])


class StandingStill(unittest.TestCase):
    """A limit of time is the student's only while the machine goes on."""

    CODE = """
import sys, time
sys.path.insert(0, sys.argv[1])
from grading.submission import Heartbeat
with Heartbeat(pause=0.5) as heart:
    print("ready", flush=True)
    sys.stdin.readline()
print(heart.stood_still)
"""

    def noticed(self, pauses: bool) -> str:
        with subprocess.Popen([sys.executable, "-B", "-c", self.CODE, str(ROOT / "tools")], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
            child.stdout.readline()
            if pauses:
                child.send_signal(signal.SIGSTOP)
                time.sleep(1)
                child.send_signal(signal.SIGCONT)
            return child.communicate("\n")[0].strip()

    def test_a_pause_is_noticed(self):
        self.assertEqual(self.noticed(True), "True")

    def test_only_what_is_late_in_a_pause_is_asked_again(self):
        late, wrong = verdict.Test("a", asked="the code under test did not answer in time (10 s a call), in f"), verdict.Test("a", asked="x == 1")
        asked = []
        real = verdict.run_step, submission.Heartbeat

        class Still:
            stood_still = True

            def __enter__(self):
                return self

            def __exit__(self, *_):
                pass

        made = kit.Kit(LAB, scheme.Scheme([scheme.StepScheme() for _ in LAB.steps]), pathlib.Path(), [], [], [], Level(True, ["all"]), False)
        try:
            for still, test, times in ((True, late, submission.ATTEMPTS), (False, late, 1), (True, wrong, 1)):
                asked.clear()
                Still.stood_still = still
                submission.Heartbeat = Still
                verdict.run_step = lambda judge, number, name, *_: asked.append(number) or verdict.Step(name, [test])
                submission.verdicts(made, pathlib.Path(), {})
                self.assertEqual(len(asked), times * len(LAB.steps))
        finally:
            verdict.run_step, submission.Heartbeat = real


class HiddenFindings(unittest.TestCase):
    def test_what_hidden_tests_found_is_told_to_none_but_who_asks(self):
        made = kit.Kit(LAB, scheme.Scheme([scheme.StepScheme() for _ in LAB.steps]), pathlib.Path(), [pathlib.Path("public"), pathlib.Path("hidden")], [], [], Level(True, ["all"]), False)
        real = submission.worker_words, submission.verdicts
        try:
            submission.worker_words = lambda *_: pathlib.Path()
            submission.verdicts = lambda _, judge, __: [verdict.Step(name, [verdict.Test(judge.name, asked="x == 1", found="2 == 1")]) for name in LAB.steps]
            for made.show_hidden in (False, True):
                tests = [test for step in submission.judged(made, pathlib.Path(), None, pathlib.Path(), 1) for test in step["tests"]]
                self.assertTrue(all(test["says"] for test in tests if not test["hidden"]))
                self.assertEqual({bool(test["says"]) for test in tests if test["hidden"]}, {made.show_hidden})
        finally:
            submission.worker_words, submission.verdicts = real


class Mistakes(unittest.TestCase):
    KNOWN = {"small": frozenset("a"), "large": frozenset("ab"), "twin": frozenset("ab"), "other": frozenset("cd")}
    WHO = {name: f"who {name}" for name in KNOWN}

    def found(self, *failed: str, gaps: str = "") -> list[str]:
        tests = [{"name": name, "passed": False, "gap": name in gaps} for name in failed]
        return [each["name"] for each in mistakes.found_in({"status": "graded", "steps": [{"tests": tests}]}, self.KNOWN, self.WHO)]

    def test_the_mutant_that_explains_most_is_named_then_what_is_left(self):
        self.assertEqual(self.found("a"), ["small"])
        self.assertEqual(self.found("a", "b"), ["large or twin"])
        self.assertEqual(self.found("a", "b", "c", "d"), ["large or twin", "other"])
        self.assertEqual(self.found("c"), [])
        self.assertEqual(self.found("c", "d", "a", gaps="a"), ["other"])


class Release(Scratch):
    """The students' copy, and the proof that it holds no answers."""

    def setUp(self):
        super().setUp()
        self.out = self.folder / "students"
        self.chosen = [lab for lab in labs.all_labs() if lab.number in ("01", "06")]
        try:
            release.copy(self.chosen, self.out)
        except labs.Problem as problem:  # no git, no checkout
            self.skipTest(str(problem))

    def test_it_holds_starters_and_no_answers(self):
        self.assertEqual(release.leaks(self.out, self.chosen), [])
        self.assertTrue((self.out / "labs" / LAB.folder / LAB.header).exists())
        for name in ("solutions", "grading", "tests/labs/lab06_glossy/mutants", "tests/labs/lab06_glossy/hidden.cpp", "labs/lab02_surfaces", ".git", "docs/instructors.md"):
            self.assertFalse((self.out / name).exists(), name)
        lists = (self.out / "tests/labs/CMakeLists.txt").read_text(encoding="utf-8")
        self.assertNotIn("axis_not_normalised", lists)
        named = re.findall(r"set_tests_properties\(([\w/]+) ", lists)
        self.assertLessEqual(set(named), set(re.findall(r"add_test\(NAME ([\w/]+)", lists)))  # CMake would stop there

    def test_all_labs_or_some_can_be_released_and_no_link_leads_to_what_stayed_behind(self):
        everything = self.folder / "all"
        release.copy(labs.all_labs(), everything)
        self.assertEqual(release.leaks(everything, labs.all_labs()), [])
        for chosen, out in ((self.chosen, self.out), (labs.all_labs(), everything)):
            links = 0
            for page in out.rglob("*.md"):
                code = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
                for target in re.findall(r"\]\(([^)\s#:]+)(?:#[^)]*)?\)", re.sub(r"`[^`\n]*`", "", code)):
                    links += 1
                    self.assertTrue((page.parent / target).exists(), f"{page.relative_to(out)} links to {target}")
            self.assertGreater(links, 100)
            table = (out / "README.md").read_text(encoding="utf-8")
            self.assertEqual(re.findall(r"^\| \[(\d\d) .*\]\(labs/", table, re.MULTILINE), [lab.number for lab in chosen])
            self.assertEqual(subprocess.run([sys.executable, "-B", "tests/checks/readme.py"], cwd=out, check=False).returncode, 0)

    def test_whatever_leaks_is_found(self):
        region = release.regions(LAB.solution_file.read_text(encoding="utf-8"))[0]
        for name, text in (("docs/notes.txt", "\n".join("  " + line.strip() + " // mine" for line in region.splitlines())), ("mutants/x.mutant", "who: me"), ("solutions/a.hpp", ""),
                           (".git/config", ""), (f"labs/{LAB.folder}/{LAB.header}", "int x;"), ("a.cpp", (LAB.tests / "hidden.cpp").read_text(encoding="utf-8"))):
            with self.subTest(name):
                file = self.out / name
                before = file.read_bytes() if file.exists() else None
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
                self.assertTrue(release.leaks(self.out, self.chosen))
                if before is None:
                    file.unlink()
                    if name.startswith(("solutions", ".git")):
                        file.parent.rmdir()
                else:
                    file.write_bytes(before)
        self.assertEqual(release.leaks(self.out, self.chosen), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
