# SPDX-License-Identifier: MIT
"""The tools behind `./lab check`: tools_test.py COMPILER-AND-OPTIONS..."""

import contextlib
import io
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import lab  # noqa: E402
import lab_test  # noqa: E402
import labs  # noqa: E402
import machine  # noqa: E402
import ppm_to_png  # noqa: E402
import student  # noqa: E402
import verdict  # noqa: E402

COMPILER: list[str] = []

LAB = labs.Lab("lab00_example", "an example", ["todo"], ["the first step", "the second step"])

REGION = """int f() {
    // BEGIN SOLUTION
    return 42;
    // END SOLUTION
    // STARTER: return lantern::todo("lab00 step 1: f");
}
"""


class Starters(unittest.TestCase):
    def test_the_starter_has_the_starter_line_for_the_region(self):
        self.assertEqual(labs.starter_of(REGION), 'int f() {\n    return lantern::todo("lab00 step 1: f");\n}\n')

    def test_a_region_that_is_not_closed_is_refused(self):
        for broken in (REGION.replace("    // END SOLUTION\n", ""), REGION.replace("    // BEGIN SOLUTION\n", ""), REGION + "// BEGIN SOLUTION\n"):
            with self.assertRaises(labs.Problem):
                labs.starter_of(broken)

    def test_no_starter_holds_anything_of_a_solution(self):
        for lab in labs.all_labs():
            starter = labs.starter_of(lab.solution_file.read_text(encoding="utf-8"))
            for mark in ("SOLUTION", "STARTER"):
                self.assertNotIn(mark, starter, lab.folder)


class Mutants(unittest.TestCase):
    def read(self, text: str) -> labs.Mutant:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "wrong.mutant"
            path.write_text(text, encoding="utf-8")
            return labs.read_mutant(path)

    def test_a_mutant_replaces_what_stands_once_in_the_solution(self):
        mutant = self.read("who: everyone\ncaught by: f: gives 42\ncaught by: g\n--- find\n42\n--- replace\n41\n")
        self.assertEqual(mutant.caught_by, ["f: gives 42", "g"])
        self.assertIn("return 41;", labs.mutate(REGION, mutant))

    def test_what_is_not_found_or_found_twice_is_refused(self):
        for text in ("43", "SOLUTION"):
            mutant = self.read(f"who: everyone\ncaught by: f\n--- find\n{text}\n--- replace\n41\n")
            with self.assertRaises(labs.Problem):
                labs.mutate(REGION, mutant)

    def test_a_mutant_names_its_maker_its_tests_and_its_edits(self):
        for text in ("caught by: f\n--- find\n1\n--- replace\n2\n", "who: I\n--- find\n1\n--- replace\n2\n", "who: I\ncaught by: f\n",
                     "who: I\ncaught by: f\n--- find\n1\n"):
            with self.assertRaises(labs.Problem):
                self.read(text)

    def test_mutants_share_files_each_in_a_namespace_of_its_own(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "lab00_x"
            folder.mkdir()
            (folder / "x.hpp").write_text("#pragma once\n#include <cmath>\nnamespace lab00 { inline int f() { return 42; } }\n", encoding="utf-8")
            (folder / "bind.cpp").write_text('#include "contract.hpp"\n\n#include <lab00_x/x.hpp>\n\nint use();\n', encoding="utf-8")
            mutants = [labs.Mutant(each, "I", ["f"], [("return 42", f"return {i}")]) for i, each in enumerate(("nought", "one", "two"))]
            first, second = labs.mutants_in_files(folder / "x.hpp", folder / "bind.cpp", mutants, 2)
            for file, has, lacks in ((first, ("nought", "two"), "one"), (second, ("one",), "two")):
                body = file[file.index("namespace mutant_"):]
                self.assertEqual(re.findall(r"namespace mutant_(\w+) \{", file), list(has))
                self.assertNotIn(f"mutant_{lacks}", file)
                self.assertNotIn("#include", body)  # in a namespace it would be the library's end
                self.assertEqual(body.count("int use();"), len(has))
                self.assertEqual((file.count("#include <cmath>"), file.count("x.hpp>"), file.count(f'#include "{folder}/contract.hpp"')), (1, 0, 1))
            self.assertIn("return 0;", first)
            self.assertIn("return 1;", second)
            self.assertIn('known({"nought", "one", "two"})', first)
            self.assertNotIn("known(", second)

    def test_a_program_that_does_not_know_the_mutant_has_not_caught_it(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text("#!/bin/sh\nexit 2\n", encoding="utf-8")
            program.chmod(0o755)
            failed, wrong = lab_test.mutant_verdict(LAB, program, labs.Mutant("unknown", "I", ["f"], []))
            self.assertEqual(failed, [])
            self.assertTrue(any("no test was run (exit status 2)" in line for line in wrong), wrong)


def report(*tests: str) -> str:
    return '<?xml version="1.0"?><Catch name="x"><Group name="x">' + "".join(tests)


PASSED = '<TestCase name="good"><OverallResult success="true"/></TestCase>'
FAILED = """<TestCase name="bad"><Info>
  symptom: dark
cause: a sign
read: §1
</Info><Info> i := 3 </Info><Expression success="false" filename="/a/suite.cpp" line="7"><Original>f() == 1</Original>
<Expanded>2 == 1</Expanded></Expression><OverallResult success="false"/></TestCase>"""
UNFINISHED = """<TestCase name="gap"><Expression success="false" filename="s.cpp" line="9"><Original>g()</Original><Expanded>g()</Expanded>
<Exception filename="s.cpp" line="9">still to do: lab00 step 1: g</Exception></Expression><OverallResult success="false"/></TestCase>"""


class Reports(unittest.TestCase):
    def test_what_a_test_says_is_found(self):
        good, bad, gap = verdict.read_report((report(PASSED, FAILED, UNFINISHED) + "</Group></Catch>").encode())
        self.assertTrue(good.passed)
        self.assertFalse(bad.passed)
        self.assertEqual((bad.asked, bad.found, bad.where), ("f() == 1", "2 == 1", "suite.cpp:7"))
        self.assertEqual(bad.hint, {"symptom": "dark", "cause": "a sign", "read": "§1"})
        self.assertEqual(bad.notes, ["i := 3"])
        self.assertEqual(gap.gap, "lab00 step 1: g")

    def test_where_a_report_ends_in_the_middle_its_last_test_failed(self):
        tests = verdict.read_report((report(PASSED) + '<TestCase name="dead">\n  ').encode())
        self.assertEqual([(test.name, test.passed) for test in tests], [("good", True), ("dead", False)])

    def test_a_crash_does_not_get_the_cause_of_another_mistake(self):
        crash = FAILED.replace("<Expanded>2 == 1</Expanded>", '<FatalErrorCondition filename="s.cpp" line="7">SIGSEGV - Segmentation violation signal</FatalErrorCondition>')
        said = verdict.explained(verdict.read_report(report(crash).encode())[0])
        self.assertIn("instead: SIGSEGV - Segmentation violation signal", said)
        self.assertIn("read:    §1", said)
        self.assertNotIn("cause:   a sign", said)
        self.assertIn("cause:   a sign", verdict.explained(verdict.read_report(report(FAILED).encode())[0]))

    def test_nothing_is_no_report(self):
        self.assertEqual(verdict.read_report(b""), [])
        self.assertEqual(verdict.read_report(b"All tests passed (12 assertions in 3 test cases)"), [])


class Steps(unittest.TestCase):
    """Programs that behave as student code may."""

    def judge(self, body: str, seconds: float = 10) -> list[verdict.Step]:
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text(f"#!{sys.executable}\nimport os, sys, time\nselection, out = sys.argv[1], sys.argv[5]\n"
                               f"def write(text):\n    with open(out, 'w') as file: file.write(text)\n{body}", encoding="utf-8")
            program.chmod(0o755)
            return verdict.judge(program, LAB, seconds)

    def test_each_step_is_asked_for_its_own_tests(self):
        steps = self.judge(f"write({report(PASSED)!r} if selection == '[step1]' else {report(FAILED)!r})\nsys.exit(selection != '[step1]')")
        self.assertEqual([step.passed for step in steps], [True, False])

    def test_an_endless_loop_ends(self):
        first, second = self.judge(f"write({report(PASSED)!r} + '<TestCase name=\"slow\">')\nif selection == '[step1]': time.sleep(60)", 2)
        self.assertIn("did not finish in 2 s", first.trouble)
        self.assertEqual(first.failures[0].name, "slow")

    @unittest.skipUnless(pathlib.Path("/proc/self/stat").exists(), "needs /proc")
    def test_a_machine_that_is_busy_elsewhere_is_no_endless_loop(self):
        # Stopped for three seconds, as others' work may do it: that is not the program's time.
        body = ("import subprocess\nsubprocess.Popen(['sh', '-c', f'sleep 3; kill -CONT {os.getpid()}'])\nos.kill(os.getpid(), 19)\n"
                f"write({report(PASSED)!r})")
        self.assertEqual([step.trouble for step in self.judge(body, 2)], ["", ""])
        sleeper = subprocess.Popen(["sleep", "60"])
        try:
            time.sleep(1)
            self.assertFalse(verdict.starved(sleeper.pid, 100))
            sleeper.send_signal(19)
            time.sleep(0.5)
            self.assertTrue(verdict.starved(sleeper.pid, 100))
            self.assertFalse(verdict.starved(sleeper.pid, 0))
        finally:
            sleeper.kill()
            sleeper.wait()
        self.assertFalse(verdict.starved(sleeper.pid, 100))

    def test_a_crash_fails_one_test_and_the_others_are_run_again(self):
        body = (f"if 'dead' in selection:\n    write({report(PASSED)!r})\nelse:\n"
                f"    write({report()!r} + '<TestCase name=\"dead, and [gone]\">')\n    os.kill(os.getpid(), 11)")
        first = self.judge(body)[0]
        self.assertIn("crashed", first.trouble)
        self.assertFalse(first.passed)
        self.assertEqual([(test.name, test.passed) for test in first.tests], [("dead, and [gone]", False), ("good", True)])

    def test_leaving_the_program_fails_the_test_that_did_so(self):
        body = (f"if 'leaver' in selection:\n    write({report(PASSED)!r})\nelse:\n"
                f"    write({report()!r} + '<TestCase name=\"leaver\">\\n')\n    os._exit(0)")
        first = self.judge(body)[0]
        self.assertIn("ended the program (exit status 0)", first.trouble)
        self.assertFalse(first.passed)
        self.assertEqual([(test.name, test.passed) for test in first.tests], [("leaver", False), ("good", True)])

    def test_a_crash_without_end_ends(self):
        first = self.judge(f"write({report(FAILED)!r})\nos.kill(os.getpid(), 6)")[0]
        self.assertIn("crashed", first.trouble)
        self.assertEqual(len(first.tests), 1)

    def test_a_program_that_runs_no_test_has_not_passed(self):
        for body in ("sys.exit(0)", "sys.exit(3)", f"write({report()!r})", "print('All tests passed (12 assertions in 3 test cases)')"):
            for step in self.judge(body):
                self.assertFalse(step.passed, body)
                self.assertIn("no test was run", step.trouble)

    def test_a_program_that_fails_without_a_failing_test_has_not_passed(self):
        self.assertIn("exit status 3", self.judge(f"write({report(PASSED)!r})\nsys.exit(3)")[0].trouble)

    def test_what_the_code_prints_is_kept_and_does_no_harm(self):
        first = self.judge(f"print('<TestCase name=\"fake\">')\nwrite({report(PASSED)!r})")[0]
        self.assertTrue(first.passed)
        self.assertEqual(first.printed, '<TestCase name="fake">')


class Builds(unittest.TestCase):
    """The messages about headers that do not compile, with the compiler at hand."""

    def explanation(self, *edits: tuple[str, str]) -> str:
        lab = labs.find("01")
        header = lab.solution_file.read_text(encoding="utf-8")
        for old, new in edits:
            self.assertIn(old, header)
            header = header.replace(old, new)
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / lab.folder).mkdir()
            (root / lab.folder / lab.header).write_text(header, encoding="utf-8")
            (root / "lantern").mkdir()  # the library as the lab may see it
            (root / "lantern" / "todo.hpp").symlink_to(ROOT / "include" / "lantern" / "todo.hpp")
            command = [*COMPILER, "-fsyntax-only", f"-I{root}", f"-I{ROOT}/tests/support", str(lab.tests / "bind.cpp")]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        return student.explain_build_failure(lab, lab.student_file, done.stderr)

    def test_a_missing_function_is_named(self):
        text = self.explanation(("inline float encode(", "inline float encod("), ("quantise(encode(", "quantise(encod("))
        self.assertIn("lacks the function 'encode'", text)
        self.assertIn("README.md", text)

    def test_a_function_with_another_result_is_named(self):
        text = self.explanation(("inline std::uint8_t quantise(float encoded)", "inline void quantise(float)"),
                                ("if (!(encoded > 0)) return 0;", ""), ("if (encoded >= 1) return 255;", ""),
                                ("return static_cast<std::uint8_t>(255 * encoded + 0.5f);", ""),
                                ("file += static_cast<char>(quantise(encode(channel)));", "file += char(encode(channel));"))
        self.assertIn("'quantise'", text)
        self.assertIn("something else than the handout says", text)

    def test_the_first_error_is_shown(self):
        text = self.explanation(("return glm::normalize", "retrun glm::normalize"))
        self.assertIn("retrun", text)
        self.assertTrue(text.startswith("labs/lab01_picture/picture.hpp does not"), "nothing of where this machine keeps it")
        self.assertLess(len(text.splitlines()), 12)
        self.assertNotIn("Traceback", text)

    def test_a_header_that_the_lab_may_not_use_is_explained(self):
        text = self.explanation(("#include <lantern/todo.hpp>", "#include <lantern/todo.hpp>\n#include <lantern/srgb.hpp>"))
        self.assertIn("srgb.hpp", text)
        self.assertIn("may include these headers of the library, and what they include: todo", text)


    def alone(self, header: str) -> str:
        """What is said of a header by itself, when the tests are compiled with <algorithm> before it."""
        lab = labs.find("01")
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            with unittest.mock.patch.object(labs, "ROOT", root):
                lab.student_file.parent.mkdir(parents=True)
                lab.student_file.write_text(header, encoding="utf-8")
                (root / "first.hpp").write_text("#include <algorithm>\n", encoding="utf-8")
                command = [*COMPILER, "-include", str(root / "first.hpp"), "-o", "tests/labs/CMakeFiles/lab01_check_bind.dir/bind.cpp.o", "-c", "bind.cpp"]
                commands = [{"command": "c++ of another target -c other.cpp"}, {"command": shlex.join(command)}]
                (root / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")
                return student.by_itself(lab, root)()

    def test_a_header_that_lives_on_what_the_tests_include_is_told_so(self):
        code = "#pragma once\n{}#include <cmath>\ninline int half(int x) {{ return std::clamp(x / 2, 0, 9); }}\n"
        self.assertEqual(self.alone(code.format("#include <algorithm>\n")), "")
        said = self.alone(code.format(""))
        self.assertIn("clamp", said)
        self.assertIn("lacks an #include", said)

    def test_without_a_build_nothing_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(student.by_itself(LAB, pathlib.Path(folder))(), "")
            (pathlib.Path(folder) / "compile_commands.json").write_text("[]", encoding="utf-8")
            self.assertEqual(student.by_itself(LAB, pathlib.Path(folder))(), "")


class FrontDoor(unittest.TestCase):
    """./lab as somebody types it who does not know it."""

    def lab(self, *words: str) -> tuple[int, str, str]:
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                status = lab.main(list(words))
            except SystemExit as end:  # --help
                status = end.code
        return status, out.getvalue(), err.getvalue()

    def test_an_unknown_command_is_told_the_nearest(self):
        status, _, said = self.lab("chekc")
        self.assertEqual(status, 2)
        self.assertIn("'chekc'; did you mean ./lab check?", said)
        self.assertLess(len(said.splitlines()), 4)
        self.assertNotIn("did you mean", self.lab("xyzzy")[2])

    def test_bad_input_is_named_with_its_rule(self):
        for words, parts in ((["check", "01", "--seconds", "x"], ("'x'", "seconds above 0")), (["check", "01", "--seconds", "inf"], ("'inf'", "above 0")),
                             (["check", "01", "--seconds", "0"], ("'0'", "above 0")), (["check"], ("NN is missing",)),
                             (["check", "77"], ("'77'", "01  a picture")), (["hint", "01", "--step", "two"], ("'two'", "whole number")),
                             (["hint", "01", "--step", "9"], ("step 9", "1 to 4")), (["watch", "01", "02"], ("02",)), (["list", "x"], ("x",))):
            status, _, said = self.lab(*words)
            self.assertEqual(status, 2, words)
            for part in (*parts, f"usage: ./lab {words[0]}"):
                self.assertIn(part, said, words)
            self.assertNotIn("Traceback", said)

    def test_each_command_explains_itself(self):
        overview = self.lab("help")[1]
        for name in (name for names in lab.COMMANDS.values() for name in names):
            self.assertRegex(overview, rf"(?m)^  {name}\b", name)
            status, said, _ = self.lab(name, "--help")
            self.assertEqual(status, 0, name)
            self.assertTrue(said.startswith(f"usage: ./lab {name}"), said)
        for name in ("start", "watch", "check", "run", "hint", "compare", "solution", "reset"):
            self.assertIn(f"examples:\n  ./lab {name}", self.lab(name, "--help")[1])

    def test_the_doctor_says_what_is_missing_and_what_for(self):
        def seen(*missing: str) -> tuple[int, str, str]:
            with unittest.mock.patch.object(machine, "look", lambda *levels: [
                    machine.Finding(need, "" if need in missing else "1.0") for need in dict.fromkeys(need for level in levels for need in machine.wanted(level))]), \
                    unittest.mock.patch.object(machine, "manager", lambda: machine.Manager("brew", ["brew", "install"])):
                return self.lab("doctor")

        status, said, _ = seen()
        self.assertEqual(status, 0)
        self.assertIn("All is here.", said)
        self.assertRegex(said, r"matplotlib 1\.0, for .*\./lab bench trace, \./lab report")
        for need in machine.PACKAGES["apt"]:
            self.assertRegex(said, rf"(?m)^{need}\b", need)
        status, said, _ = seen("cmake", "npm")
        self.assertEqual(status, 1)
        self.assertRegex(said, r"(?m)^cmake +missing$")
        self.assertIn("  brew install cmake node\n", said)
        status, said, _ = seen("stb")  # which CMake fetches
        self.assertEqual(status, 0)
        self.assertIn("stb is in no package that I know of here; CMake will fetch its sources", said)

    def test_a_terminal_of_plain_characters_is_served(self):
        done = subprocess.run([sys.executable, str(ROOT / "tools" / "lab.py"), "status"], capture_output=True, check=False,
                              env={**os.environ, "PYTHONIOENCODING": "ascii"})
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertIn(b"....", done.stdout)
        text = "✓ ✗ · → “x” 日"
        self.assertEqual(lab.in_plain_characters(UnicodeEncodeError("ascii", text, 0, len(text), ""))[0], '+ x . > "x" ?')


class Pictures(unittest.TestCase):
    def convert(self, data: bytes) -> bytes | None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.ppm"
            path.write_bytes(data)
            made = ppm_to_png.convert(path)
            return made.read_bytes() if made else None

    def test_both_kinds_of_ppm_give_the_same_png(self):
        binary = self.convert(b"P6\n2 1\n255\n\x01\x02\x03\x0a\x20\xff")
        self.assertEqual(binary, self.convert(b"P3\n2 1\n255\n1 2 3\n10 32 255\n"))
        self.assertIn(zlib.compress(b"\0\x01\x02\x03\x0a\x20\xff", 6), binary)

    def test_what_is_no_ppm_is_left_alone(self):
        for data in (b"", b"P6", b"P6\n2 1\n255\n\x01", b"P6\n-2 -1\n255\n123456", b"P6\n2 1\n65535\n123456", b"P6\nx y\n255\n", b"P6\n99999999 99999999\n255\n",
                     b"P3\n1 1\n255\n1 2 300\n", b"GIF89a"):
            self.assertIsNone(self.convert(data), data)


if __name__ == "__main__":
    COMPILER = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
