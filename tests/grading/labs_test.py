# SPDX-License-Identifier: MIT
"""Every lab, graded: labs_test.py [NN...]. The solution gets full marks, the starter none, whatever the seed of the hidden tests."""

import pathlib
import secrets
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
from grading import kit, submission  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402


class EveryLab(unittest.TestCase):
    names: list[str] = []

    def test_the_solution_gets_full_marks_and_the_starter_none(self):
        chosen = [lab for lab in labs.all_labs() if not self.names or lab.number in self.names]
        self.assertTrue(chosen)
        with kit.stage_folder() as stage, Sandbox() as box:
            for lab in chosen:
                folder = pathlib.Path(stage) / lab.name
                folder.mkdir(mode=0o711)
                with self.subTest(lab.folder):
                    made = submission.verified(kit.made(lab, folder), box)
                    seed = secrets.randbelow(1 << 48)
                    solution = submission.graded(made, {f"{lab.folder}/{lab.header}": lab.solution_file.read_bytes()}, box, seed)
                    self.assertEqual((solution["score"], solution["of"]), (made.scheme.total, made.scheme.total), (seed, solution))
                    starter = labs.starter_of(lab.solution_file.read_text(encoding="utf-8"))
                    result = submission.graded(made, {f"{lab.folder}/{lab.header}": starter.encode()}, box, seed)
                    self.assertEqual((result["status"], result["score"]), ("graded", 0), result["message"])
                    passed = [test["name"] for step in result["steps"] for test in step["tests"] if test["passed"]]
                    self.assertEqual(passed, [])
                    print(f"{lab.folder:<24} {solution['score']:g} of {solution['of']:g} in {solution['seconds']} s, starter {result['score']:g}", file=sys.stderr)


if __name__ == "__main__":
    EveryLab.names = [word for word in sys.argv[1:] if not word.startswith("-")]
    unittest.main(argv=[sys.argv[0]])
