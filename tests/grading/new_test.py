# SPDX-License-Identifier: MIT
"""./lab new, in a copy of this checkout: new_test.py [--no-build]. What it makes builds, its starter fails by name, its solution passes
and its mutant is caught; what it refuses leaves no trace."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = "--no-build" not in sys.argv


class New(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.copy = pathlib.Path(folder.name) / "lantern"
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True, check=True)
        for name in filter(None, listed.stdout.split("\0")):
            if (ROOT / name).is_file():
                (cls.copy / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, cls.copy / name)

    def lab(self, *words: str) -> subprocess.CompletedProcess:
        environment = {**os.environ, "LANTERN_STEP_SECONDS": "60"}
        return subprocess.run([sys.executable, "-B", "tools/lab.py", *words], cwd=self.copy, capture_output=True, text=True, check=False, env=environment)

    def state(self) -> dict[str, bytes]:
        return {path.relative_to(self.copy).as_posix(): path.read_bytes() for path in sorted(self.copy.rglob("*"))
                if path.is_file() and "build" not in path.relative_to(self.copy).parts and path.suffix != ".pyc"}

    def test_1_what_is_taken_or_malformed_is_refused_with_the_rule(self):
        before = self.state()
        for number, topic, rule in (("0", "x", "01 to 99"), ("100", "x", "01 to 99"), ("-1", "x", ""), ("1a", "x", "01 to 99"), ("06", "x", "taken by lab06_glossy"),
                                    ("6", "x", "is free"), ("97", "Glossy", "small letters"), ("97", "a__b", "small letters"), ("97", "_a", "small letters"),
                                    ("97", "3d", "letter first"), ("97", "../x", "small letters"), ("97", "", "small letters"), ("97", "x" * 41, "40 characters"),
                                    ("97", "class", "word of C++"), ("97", "glossy", "lab 06's"), ("97", "sphere", "header of the library")):
            with self.subTest(f"{number} {topic}"):
                done = self.lab("new", number, topic)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(rule, done.stderr)
        for title in ("", 'a "b"', "a\nb", "x" * 61):
            self.assertEqual(self.lab("new", "97", "topic", "--title", title).returncode, 2)
        self.assertEqual(self.state(), before)

    def test_2_a_failure_leaves_nothing_half_written(self):
        lists = self.copy / "CMakePresets.json"
        kept = lists.read_text(encoding="utf-8")
        lists.write_text("{}", encoding="utf-8")
        before = self.state()
        done = self.lab("new", "97", "half_written")
        self.assertEqual(done.returncode, 1)
        self.assertIn("CMakePresets.json", done.stderr)
        self.assertEqual(self.state(), before)
        lists.write_text(kept, encoding="utf-8")
        # The last rename fails: what had been renamed is taken back.
        sys.path.insert(0, str(self.copy / "tools"))
        try:
            from commands import new
            before = self.state()
            files, changed = new.made("97", "half_written", "half written")
            real, times = new.whole.write, []

            def failing(path, text):
                times.append(path)
                if len(times) == 2:
                    raise OSError("the disk is full")
                real(path, text)

            new.whole.write = failing
            self.assertRaises(OSError, new.write, files, changed)
            new.whole.write = real
            self.assertEqual(self.state(), before)
        finally:
            sys.path.pop(0)

    def test_3_a_new_lab_is_everywhere_and_works(self):
        done = self.lab("new", "97", "colour_words", "--title", "colours & words")
        self.assertEqual(done.returncode, 0, done.stderr)
        folder = "lab97_colour_words"
        self.assertEqual(json.loads((self.copy / "labs" / folder / "lab.json").read_text())["title"], "colours & words")
        for path in self.copy.rglob("*"):
            if folder in path.as_posix() and path.is_file():
                self.assertNotRegex(path.read_text(encoding="utf-8"), r"@[A-Z]+@", path)
        workflows = json.loads((self.copy / "CMakePresets.json").read_text())
        for kind in ("buildPresets", "testPresets", "workflowPresets"):
            self.assertEqual([each["name"] for each in workflows[kind]].count("lab97"), 1)
        for script in ("readme.py", "floors.py"):
            self.assertEqual(subprocess.run([sys.executable, "-B", f"tests/checks/{script}"], cwd=self.copy, capture_output=True, check=False).returncode, 0, script)
        self.assertEqual(self.lab("new", "97", "other").returncode, 2)
        self.assertEqual(self.lab("starters", "97", "--check").returncode, 0)
        # Between the labs that there are, too: the lists stay in order.
        self.assertEqual(self.lab("new", "98", "last_one").returncode, 0)
        self.assertEqual(self.lab("new", "96", "before_it").returncode, 0)
        programs = [line[23:25] for line in (self.copy / "labs" / "CMakeLists.txt").read_text().splitlines() if line.startswith("lantern_lab_program(lab")]
        self.assertEqual(programs, sorted(programs))
        if not BUILD:
            return
        starter = self.lab("check", "97", "--json")
        self.assertEqual(starter.returncode, 1, starter.stderr)
        tests = [test for step in json.loads(starter.stdout)["steps"] for test in step["tests"]]
        self.assertEqual({test["passed"] for test in tests}, {False})
        self.assertIn("still to do", self.lab("check", "97").stdout)
        for words in (("check", "97", "--solution"), ("mutants", "97"), ("run", "97"), ("run", "97", "--solution"), ("grade", "--prepare", "--lab", "97", "--trust")):
            done = self.lab(*words)
            self.assertEqual(done.returncode, 0, f"{words}\n{done.stdout}\n{done.stderr}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
