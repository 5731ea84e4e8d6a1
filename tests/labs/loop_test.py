# SPDX-License-Identifier: MIT
"""The student's loop: what is remembered, hints, pictures, ./lab alone."""

import contextlib
import io
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import hints  # noqa: E402
import labs  # noqa: E402
import pictures  # noqa: E402
import ppm_to_png  # noqa: E402
import process  # noqa: E402
import progress  # noqa: E402
import student  # noqa: E402
from commands import compare, hint, release, reset, solution, start, status, watch  # noqa: E402


class OwnCopy(unittest.TestCase):
    """A house of one lab, with a memory of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("labs/lab00_example", "solutions/lab00_example", "build"):
            (self.root / name).mkdir(parents=True)
        self.lab = labs.Lab("lab00_example", "an example", ["todo"], ["the first step", "the second step"])
        solution_text = "// BEGIN SOLUTION\nright\n// END SOLUTION\n// STARTER: todo\n"
        (self.root / "solutions/lab00_example/example.hpp").write_text(solution_text, encoding="utf-8")
        (self.root / "labs/lab00_example/example.hpp").write_text("todo\n", encoding="utf-8")
        patches = [unittest.mock.patch.object(module, "ROOT", self.root) for module in (labs, progress, hints, solution, watch)]
        patches.append(unittest.mock.patch.object(progress, "FILE", self.root / "build" / "progress.json"))
        patches.append(unittest.mock.patch.object(labs, "all_labs", lambda: [self.lab]))
        for patch in patches:
            patch.start()
            self.addCleanup(patch.stop)

    def said(self, command, *arguments: str) -> str:
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            self.status = command.run(list(arguments))
        return text.getvalue()

    def write(self, text: str) -> None:
        self.lab.student_file.write_text(text, encoding="utf-8")


class Progress(OwnCopy):
    def test_nothing_is_known_at_first_and_a_broken_memory_is_none(self):
        self.assertEqual(progress.passed(self.lab, progress.load()), [False, False])
        for text in ("{", "[]", "", "\0"):
            progress.FILE.write_text(text, encoding="utf-8")
            self.assertEqual(progress.load(), {})
            self.assertIn("0 of 2 steps", self.said(status))

    def test_a_verdict_is_remembered_until_the_file_changes(self):
        self.write("half\n")
        progress.remember(self.lab, [True, False])
        known = progress.load()
        self.assertEqual(progress.passed(self.lab, known), [True, False])
        self.assertFalse(progress.changed_since(self.lab, known))
        self.assertIn("1 of 2 steps", self.said(status))
        self.write("more\n")
        self.assertTrue(progress.changed_since(self.lab, known))
        self.assertIn("changed since", self.said(status))

    def test_the_untouched_starter_is_not_begun(self):
        self.assertFalse(progress.changed_since(self.lab, {}))
        self.write("todo, and a start\n")
        self.assertTrue(progress.changed_since(self.lab, {}))
        self.assertIn("begun", self.said(status))

    def test_what_is_done_is_no_longer_in_hand(self):
        progress.remember(self.lab, [True, True])
        self.assertIsNone(progress.current(progress.load()))
        self.assertIn("All labs are done", self.said(status))


class Hints(OwnCopy):
    def setUp(self):
        super().setUp()
        text = '{"steps": [["look", "think", "    write"], ["look again", "think again", "write again"]]}'
        (self.root / "labs/lab00_example/hints.json").write_text(text, encoding="utf-8")

    def test_each_call_tells_one_more_and_the_last_one_stays(self):
        self.assertNotIn("think", self.said(hint, "00"))
        self.assertNotIn("write\n", self.said(hint, "00"))
        for _ in range(2):
            self.assertIn("       write", self.said(hint, "00"))  # code keeps its indent
        self.assertIn("look", self.said(hint, "00", "--again"))

    def test_they_are_for_the_first_step_that_does_not_pass(self):
        progress.remember(self.lab, [True, False])
        self.assertIn("look again", self.said(hint))
        self.assertIn("1. a nudge\n   look\n", self.said(hint, "--step", "1"))

    def test_again_tells_nothing_new(self):
        self.assertIn("no hint", self.said(hint, "00", "--again"))
        self.assertIn("a nudge", self.said(hint, "00"))

    def test_a_step_that_there_is_not_is_refused(self):
        for step in ("0", "3", "-1"):
            with self.assertRaises(process.Misuse):
                hint.run(["00", "--step", step])

    def test_hints_that_do_not_fit_the_lab_are_a_problem(self):
        for text in ('{"steps": []}', '{"steps": [["one", "two"], ["one", "two"]]}', "{", '{"steps": 7}', "[]"):
            hints.file_of(self.lab).write_text(text, encoding="utf-8")
            with self.assertRaises(labs.Problem):
                hints.of(self.lab)


class Reset(OwnCopy):
    def test_the_old_file_is_kept_every_time(self):
        for number, text in ((1, "mine\n"), (2, "mine again\n")):
            self.write(text)
            self.said(reset, "00")
            self.assertEqual(self.lab.student_file.read_text(encoding="utf-8"), "todo\n")
            self.assertEqual((self.lab.student_file.parent / f"example.hpp.{number}").read_text(encoding="utf-8"), text)

    def test_what_had_been_reached_is_forgotten(self):
        self.write("mine\n")
        progress.remember(self.lab, [True, True])
        self.said(reset, "00")
        known = progress.load()
        self.assertEqual(progress.passed(self.lab, known), [False, False])
        self.assertFalse(progress.changed_since(self.lab, known))

    def test_an_empty_starter_stays(self):
        self.assertIn("already", self.said(reset, "00"))
        self.assertFalse((self.lab.student_file.parent / "example.hpp.1").exists())

    def test_a_file_that_was_deleted_comes_back(self):
        for command in (reset, start):
            self.lab.student_file.unlink()
            self.said(command, "00")
            self.assertEqual(self.lab.student_file.read_text(encoding="utf-8"), "todo\n")

    def test_a_copy_without_solutions_has_it_from_git(self):
        self.lab.solution_file.unlink()
        with self.assertRaises(labs.Problem):
            reset.run(["00"])
        self.write("as given\n")
        for words in (["init", "-q"], ["add", "labs"], ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "given"]):
            subprocess.run(["git", *words], cwd=self.root, check=True)
        self.assertIn("already", self.said(reset, "00"))
        self.write("mine\n")
        self.assertTrue(progress.begun(self.lab))
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-a", "-m", "mine"], cwd=self.root, check=True)
        self.assertTrue(progress.begun(self.lab))
        self.said(reset, "00")
        self.assertEqual(self.lab.student_file.read_text(encoding="utf-8"), "as given\n")


class Solution(OwnCopy):
    def test_it_is_shown_when_yours_passes_and_not_before(self):
        self.assertIn("Not yet", self.said(solution, "00"))
        self.assertEqual(self.status, 1)
        self.write("wrong\n")
        progress.remember(self.lab, [True, True])
        text = self.said(solution, "00")
        self.assertIn("+right", text)
        self.assertNotIn("SOLUTION", text)
        self.write("changed\n")
        self.assertIn("Not yet", self.said(solution, "00"))

    def test_the_course_decides(self):
        course = self.root / "course.json"
        course.write_text('{"solutions": "always"}', encoding="utf-8")
        self.assertIn("right", self.said(solution, "00", "--whole"))
        course.write_text('{"solutions": "never"}', encoding="utf-8")
        progress.remember(self.lab, [True, True])
        self.assertIn("Not yet", self.said(solution, "00"))
        course.write_text('{"solutions": "perhaps"}', encoding="utf-8")
        with self.assertRaises(labs.Problem):
            solution.run(["00"])

    def test_a_copy_without_solutions_says_so(self):
        self.lab.solution_file.unlink()
        self.assertIn("no solution", self.said(solution, "00"))


class Drawing(OwnCopy):
    """A program that draws one picture and then never ends."""

    def setUp(self):
        super().setUp()
        program = self.root / "program"
        program.write_text(f"#!{sys.executable}\nimport pathlib, time\npathlib.Path('out').mkdir()\npathlib.Path('out/a.ppm').write_bytes(b'')\n"
                           "print('out/a.ppm', flush=True)\npathlib.Path('begun').touch()\ntime.sleep(600)\n", encoding="utf-8")
        program.chmod(0o755)
        patch = unittest.mock.patch.object(student, "built", lambda *_: program)
        patch.start()
        self.addCleanup(patch.stop)

    def drawn(self, when_begun) -> str:
        """What is said; when_begun is called once the picture is there, and its answer is the key that is pressed."""
        def key(seconds):
            time.sleep(seconds)
            return when_begun() if (self.root / "begun").exists() else None

        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            self.pressed = watch.draw(self.lab, key)
        self.assertIn("a.ppm", text.getvalue())
        self.assertIn("ended before it was done", text.getvalue())

    def test_a_key_ends_it_and_counts(self):
        self.drawn(lambda: "q")
        self.assertEqual(self.pressed, "q")

    def test_a_save_ends_it(self):
        self.drawn(lambda: self.write("mended\n"))
        self.assertIsNone(self.pressed)


def png_of(width: int, height: int, colour: int, rows: list[bytes]) -> bytes:
    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + ppm_to_png.chunk(b"IHDR", header) + ppm_to_png.chunk(b"IDAT", zlib.compress(b"".join(rows))) +
            ppm_to_png.chunk(b"IEND", b""))


class Pictures(unittest.TestCase):
    def test_a_png_comes_back(self):
        picture = pictures.Picture(3, 2, bytes(range(18)))
        self.assertEqual(pictures.read_png(pictures.png(picture)), picture)

    def test_every_filter_is_undone(self):
        # The same row, by each of the five filters, worked out by hand from section 9.2 of the standard.
        row = bytes([10, 20, 30, 40, 50, 60])
        above = row
        coded = {0: row, 1: bytes([10, 20, 30, 30, 30, 30]), 2: bytes(6), 3: bytes([5, 10, 15, 40 - 25, 50 - 35, 60 - 45]), 4: bytes(6)}
        for kind, data in coded.items():
            picture = pictures.read_png(png_of(2, 2, 2, [b"\0" + above, bytes([kind]) + data]))
            self.assertEqual(picture.pixels, above + row, kind)

    def test_grey_and_alpha_become_colours(self):
        self.assertEqual(pictures.read_png(png_of(2, 1, 0, [b"\0\x07\x09"])).pixels, bytes([7, 7, 7, 9, 9, 9]))
        self.assertEqual(pictures.read_png(png_of(1, 1, 6, [b"\0\1\2\3\4"])).pixels, bytes([1, 2, 3]))

    def test_what_is_broken_is_refused(self):
        good = pictures.png(pictures.Picture(3, 2, bytes(18)))
        for data in (good[:20], good[:-30], png_of(2, 2, 2, [b"\0" + bytes(6)]), png_of(1, 1, 3, [b"\0\0"]),
                     png_of(1, 1, 2, [b"\7\0\0\0"]), png_of(0, 1, 2, [])):
            with self.assertRaises(ValueError):
                pictures.read_png(data)

    def test_the_difference_has_a_sign(self):
        mine = pictures.Picture(3, 1, bytes([10, 10, 10, 50, 50, 50, 0, 0, 0]))
        reference = pictures.Picture(3, 1, bytes([10, 10, 10, 40, 50, 50, 90, 90, 90]))
        difference, count, most = pictures.signed_difference(mine, reference)
        self.assertEqual(difference.pixels, bytes([255, 255, 255, 255, 215, 215, 0, 0, 255]))
        self.assertEqual((count, most), (2, 90))

    def test_blocks_have_the_colours_of_the_picture(self):
        text = pictures.blocks(pictures.Picture(2, 2, bytes([255, 0, 0, 0, 255, 0, 0, 0, 255, 1, 2, 3])), 2)
        self.assertIn("38;2;255;0;0;48;2;0;0;255", text)
        self.assertIn("38;2;0;255;0;48;2;1;2;3", text)

    def test_terminals_get_what_they_know(self):
        self.assertEqual(pictures.protocol({"TERM_PROGRAM": "iTerm.app"}), "iterm")
        self.assertEqual(pictures.protocol({"TERM": "xterm-kitty"}), "kitty")
        self.assertEqual(pictures.protocol({"COLORTERM": "truecolor"}), "blocks")
        self.assertEqual(pictures.protocol({"TERM": "xterm"}), "")


class Compare(unittest.TestCase):
    def section(self, yours: bytes | None, ours: bytes) -> tuple[str, bool]:
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, data in (("yours.png", yours), ("ours.png", ours)):
                paths.append(pathlib.Path(folder) / name if data is not None else None)
                if data is not None:
                    paths[-1].write_bytes(data)
            return compare.section("lab00_1.png", *paths)

    def test_each_kind_of_difference_is_told(self):
        one = pictures.png(pictures.Picture(1, 2, bytes(6)))
        other = pictures.png(pictures.Picture(1, 2, bytes([0, 0, 0, 7, 0, 0])))
        self.assertEqual(self.section(one, one)[1], True)
        self.assertIn("50 % of the pixels differ, by 7 of 255", self.section(other, one)[0])
        self.assertIn("no such picture", self.section(None, one)[0])
        self.assertIn("no such picture", self.section(b"rubbish", one)[0])
        self.assertIn("2 × 1 pixels, ours 1 × 2", self.section(pictures.png(pictures.Picture(2, 1, bytes(6))), one)[0])


class EveryLab(unittest.TestCase):
    def test_hints_fit_their_labs(self):
        for lab in labs.all_labs():
            texts = hints.of(lab)
            self.assertTrue(texts, f"{lab.folder} has no hints.json")
            for step in texts:
                for text in step:
                    self.assertTrue(text.strip(), lab.folder)
                self.assertLess(len(step[0]), len(step[2]) + 200, f"{lab.folder}: a nudge that tells all")

    def test_no_hint_is_the_solution_itself(self):
        """./lab release would refuse the whole course for it."""
        for lab in labs.all_labs():
            text = release.squeezed(hints.file_of(lab).read_text(encoding="utf-8"))
            for region in release.regions(lab.solution_file.read_text(encoding="utf-8")):
                code = release.squeezed(region)
                self.assertFalse(len(code) >= 60 and code in text, f"{lab.folder}: a hint that is the answer:\n{region}")


if __name__ == "__main__":
    unittest.main()
