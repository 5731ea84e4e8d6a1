# SPDX-License-Identifier: MIT
"""Attacks on the grading of lab 06: attacks_test.py [NAME...]. Each stands on wrong answers, and may earn no more than those do.

attacks/NN_name.hpp is what a student hands in; NN is the number of the attack in docs/instructors.md. Where an attack can tell
whether it got through, it answers with the solution from then on: the control, which claims to have got through, earns full marks."""

import dataclasses
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
from grading import kit, submission  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402

ATTACKS = pathlib.Path(__file__).parent / "attacks"
LAB = labs.find("06")
HELPERS = {"wrong", "only_wrong", "either"}
SECRET = "lantern-secret-5d1f"
SECONDS = 2  # a call, in the place of 10 s: an honest one takes microseconds

# What is no attack, or costs but one step: the points of each step.
EARN = {"00_control": [10, 10, 10, 10, 10], "18_endless_loop": [0, 10, 10, 10, 10], "31_honest": [10, 10, 10, 10, 10]}
# What must be refused before it runs.
REFUSED = {"04_require", "05_main", "05_define_main", "11_solution", "12_incbin", "14_dev_zero", "14_dev_stdin", "15_template_bomb",
           "16_huge_object", "16_huge_section", "17_endless_constexpr", "17_nested_constexpr"}


def solution(namespace: str) -> str:
    return re.sub(r"\bnamespace lab06\b", f"namespace {namespace}", LAB.solution_file.read_text(encoding="utf-8"))


def recorded(made: kit.Kit, folder: pathlib.Path) -> list[int]:
    """Digests of all that the public suite asks of lab 06, as the attack `known by heart` makes them."""
    text = (ATTACKS / "09_known_by_heart.hpp").read_text(encoding="utf-8").replace("@LIST@", "0")
    text = re.sub(r"inline bool known\(.*?\n}\n", 'inline bool known(std::uint64_t d) { return std::ofstream("%s", std::ios::app) << d << "\\\\n", true; }\n'
                  % (folder / "log"), text, flags=re.DOTALL).replace("#include <cstdint>", "#include <cstdint>\n#include <fstream>")
    code = folder / LAB.folder
    code.mkdir()
    (code / LAB.header).write_text(text, encoding="utf-8")
    (code / "right.hpp").write_text(solution("right"), encoding="utf-8")
    shutil.copy(ATTACKS / "wrong.hpp", code)
    real = {kit.KIT: str(made.folder), kit.CODE: str(folder), kit.OUT: str(folder)}
    command = made.worker_command()
    for name, path in real.items():
        command = [word.replace(name, path) for word in command]
    subprocess.run([*command[:1], "-O1", *command[1:]], check=True)
    (folder / "command").write_bytes(str(folder / "worker").encode() + b"\0")
    subprocess.run([str(made.judges[0])], env={"LANTERN_WORKER": str(folder / "command")}, stdout=subprocess.DEVNULL, check=True)
    return sorted({int(line) for line in (folder / "log").read_text().split()})


def processes_of(user: int) -> list[str]:
    found = []
    for each in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if each.stat().st_uid == user and "\nState:\tZ" not in (each / "status").read_text():
                found.append((each / "comm").read_text().strip())
        except OSError:
            continue
    return found


def left_of(box: Sandbox) -> list[str]:
    """What runs in a slot, or as its user. A process that was killed may take a moment to go."""
    for _ in range(50):
        left = [*map(str, box.group.running()), *(processes_of(box.user) if box.user != os.geteuid() else [])]
        if not left:
            break
        time.sleep(0.1)
    return left


class Attacks(unittest.TestCase):
    names: list[str] = []

    @classmethod
    def setUpClass(cls):
        os.environ["SECRET"] = SECRET
        cls.stage = kit.stage_folder()
        cls.addClassCleanup(cls.stage.cleanup)
        stage = pathlib.Path(cls.stage.name)
        cls.out = stage / "out"
        cls.out.mkdir()
        (cls.out / "secret").write_text(SECRET)
        cls.server = socket.create_server(("127.0.0.1", 0))
        cls.abstract = socket.socket(socket.AF_UNIX)
        cls.abstract.bind(f"\0lantern-{os.getpid()}")
        cls.abstract.listen()
        cls.addClassCleanup(cls.server.close)
        cls.addClassCleanup(cls.abstract.close)
        with Sandbox() as box:
            cls.kit = submission.verified(kit.made(LAB, stage), box)
        cls.kit.scheme.call = SECONDS
        # Smaller limits than students have, for the attacks that go to them.
        submission.COMPILING = dataclasses.replace(kit.COMPILING, cpu=12, wall=40)
        submission.WORKING = dataclasses.replace(kit.WORKING, memory=256 << 20)
        (stage / "recording").mkdir()
        known = recorded(cls.kit, stage / "recording")
        cls.words = {"@ROOT@": str(ROOT), "@OUT@": str(cls.out), "@PORT@": str(cls.server.getsockname()[1]), "@PID@": str(os.getpid()),
                     "@ABSTRACT@": f"lantern-{os.getpid()}", "@SECRET@": SECRET, "@LIST@": ", ".join(f"{each}u" for each in known)}
        slots = threading.local()

        def grade(name: str) -> dict:
            if not hasattr(slots, "box"):
                slots.box = Sandbox()
                cls.addClassCleanup(slots.box.close)
            result = submission.graded(cls.kit, cls.files(name), slots.box, seed=20261125)
            result["left"] = left_of(slots.box)
            return result

        cls.chosen = [path.stem for path in sorted(ATTACKS.glob("*.hpp")) if path.stem not in HELPERS]
        if cls.names:
            cls.chosen = [name for name in cls.chosen if any(word in name for word in [*cls.names, "baseline"])]
        with ThreadPoolExecutor(2) as pool:
            cls.results = dict(zip(cls.chosen, pool.map(grade, cls.chosen)))
        for name, result in cls.results.items():
            print(f"{name:<24} {result['status']:<9} {result['score']:>5} {result['seconds']:>6} s  {result['message'].splitlines()[0][:80] if result['message'] else ''}",
                  file=sys.stderr)

    @classmethod
    def files(cls, name: str) -> dict[str, bytes]:
        text = (ATTACKS / f"{name}.hpp").read_text(encoding="utf-8")
        for word, value in cls.words.items():
            text = text.replace(word, value)
        files = {f"{LAB.folder}/{helper}.hpp": (ATTACKS / f"{helper}.hpp").read_bytes() for helper in HELPERS}
        return files | {f"{LAB.folder}/{LAB.header}": text.encode(), f"{LAB.folder}/right.hpp": solution("right").encode()}

    def test_each_earns_what_the_code_under_it_earns(self):
        for name, result in self.results.items():
            with self.subTest(name):
                self.assertEqual([step["points"] for step in result["steps"]], EARN.get(name, [0, 0, 0, 0, 0]))

    def test_no_attack_passes_a_test_that_the_code_under_it_does_not(self):
        def passed(result: dict) -> set[str]:
            return {test["name"] for step in result["steps"] for test in step["tests"] if test["passed"]}

        for name, result in self.results.items():
            with self.subTest(name):
                if name not in EARN and name != "09_known_by_heart":
                    self.assertEqual(passed(result) - passed(self.results["00_baseline"]), set())
                self.assertEqual([[test["name"] for test in step["tests"]] for step in result["steps"]], [list(tests) for tests in self.kit.tests])

    def test_what_must_not_run_is_refused_in_words(self):
        for name in REFUSED & set(self.results):
            with self.subTest(name):
                self.assertEqual(self.results[name]["status"], "refused")
                self.assertNotIn("Something other than your header", self.results[name]["message"])

    def test_what_may_run_is_graded(self):
        for name in set(self.results) - REFUSED:
            with self.subTest(name):
                self.assertEqual((self.results[name]["status"], self.results[name]["message"]), ("graded", ""))

    def test_answers_known_by_heart_pass_the_public_tests_and_no_hidden_one(self):
        if "09_known_by_heart" in self.results:
            tests = [test for step in self.results["09_known_by_heart"]["steps"] for test in step["tests"]]
            self.assertEqual({test["hidden"] for test in tests if not test["passed"]}, {True}, tests)
            self.assertEqual({test["passed"] for test in tests if test["hidden"]}, {False})

    def test_nothing_is_left_running(self):
        for name, result in self.results.items():
            with self.subTest(name):
                self.assertEqual((result["left"], result["left_running"]), ([], 0))

    def test_nobody_called(self):
        for server in (self.server, self.abstract):
            server.setblocking(False)
            self.assertRaises(BlockingIOError, server.accept)

    def test_nothing_was_written(self):
        self.assertEqual([path.name for path in self.out.iterdir()], ["secret"])

    def test_hidden_inputs_leak_nowhere(self):
        if "29_leaks" in self.results:
            tests = [test for step in self.results["29_leaks"]["steps"] for test in step["tests"]]
            self.assertTrue(any("LEAK" in line for test in tests if not test["hidden"] for line in test["says"]))
            self.assertFalse([test["says"] for test in tests if test["hidden"] and test["says"]])
            self.assertTrue(all(line.isprintable() and len(line) < 400 for test in tests for line in test["says"]))

    def test_promises_that_the_compiler_checks_refuse_and_give_nothing(self):
        gate = self.kit.folder / "lab" / "gate.cpp"
        try:
            self.kit.gate = True
            for promise, status in (("true", "graded"), ("noexcept(lab06::basis({}))", "refused")):
                gate.write_text(f'#include <{LAB.folder}/{LAB.header}>\nstatic_assert({promise}, "basis must not throw");\n')
                with Sandbox() as box:
                    result = submission.graded(self.kit, self.files("00_baseline"), box, seed=1)
                self.assertEqual((result["status"], result["score"]), (status, 0))
                self.assertEqual("basis must not throw" in result["message"], status == "refused")
        finally:
            self.kit.gate = False
            gate.unlink()

    def test_without_isolation_nothing_runs_that_is_not_trusted(self):
        with tempfile.TemporaryDirectory(dir=self.stage.name) as name:
            os.chmod(name, 0o711)
            for trust in (False, True):
                folder = pathlib.Path(name) / str(trust)
                folder.mkdir(mode=0o711)
                if not trust:
                    with self.assertRaises(labs.Problem) as caught:
                        kit.made(LAB, folder, way="limits")
                    self.assertIn("NOT ISOLATED", str(caught.exception))
                    self.assertEqual(list(folder.iterdir()), [])
                else:
                    with Sandbox("limits") as box:
                        made = submission.verified(kit.made(LAB, folder, way="limits", trust=True), box)
                        self.assertFalse(made.level.isolated)
                        self.assertIn("without: no network", str(made.level))
                        self.assertEqual(submission.graded(made, self.files("00_baseline"), box, seed=1)["score"], 0)

    def test_the_judge_holds_no_student_code(self):
        symbols = subprocess.run(["nm", "-C", str(self.kit.judges[0])], capture_output=True, text=True, check=True).stdout
        self.assertNotRegex(symbols, r"\blab06::")
        self.assertIn("contract::judge::ask", symbols)
        worker = subprocess.run(["nm", "-C", str(self.kit.folder.parent / "reference")], capture_output=True, text=True, check=True).stdout
        self.assertNotIn("Catch", worker)
        self.assertNotIn("TestCase", worker)


if __name__ == "__main__":
    Attacks.names = [word for word in sys.argv[1:] if not word.startswith("-")]
    unittest.main(argv=[sys.argv[0], "-v"])
