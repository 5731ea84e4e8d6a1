# SPDX-License-Identifier: MIT
"""Every lab, graded: labs_test.py [NN...]. The solution gets full marks, and so do other right answers (different/NN_*.mutant, edits of
the solution); the starter gets none, whatever the seed of the hidden tests."""

import pathlib
import secrets
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import labs  # noqa: E402
import student  # noqa: E402
from grading import kit, submission, term  # noqa: E402
from grading.sandbox import Sandbox  # noqa: E402

DIFFERENT = pathlib.Path(__file__).parent / "different"


def graded(lab: labs.Lab, stage: pathlib.Path, box: Sandbox) -> str:
    """What is wrong with the marks of the solution and of the starter; "" when nothing is."""
    folder = stage / lab.name
    folder.mkdir(mode=0o711)
    try:
        made = submission.verified(kit.made(lab, folder), box)
    except labs.Problem as problem:
        return str(problem)
    seed = secrets.randbelow(1 << 48)
    solution = submission.graded(made, {f"{lab.folder}/{lab.header}": lab.solution_file.read_bytes()}, box, seed)
    starter = submission.graded(made, {f"{lab.folder}/{lab.header}": labs.starter_of(lab.solution_file.read_text(encoding="utf-8")).encode()}, box, seed)
    passed = [test["name"] for step in starter["steps"] for test in step["tests"] if test["passed"]]
    print(f"{lab.folder:<24} {solution['score']:g} of {solution['of']:g} in {solution['seconds']} s, starter {starter['score']:g}", file=sys.stderr, flush=True)
    if solution["score"] != made.scheme.total:
        return f"seed {seed}: {solution}"
    for path in sorted(DIFFERENT.glob(f"{lab.number}_*.mutant")):
        header = labs.mutate(lab.solution_file.read_text(encoding="utf-8"), labs.read_mutant(path))
        other = submission.graded(made, {f"{lab.folder}/{lab.header}": header.encode()}, box, seed)
        print(f"{path.name:<24} {other['score']:g} of {other['of']:g}", file=sys.stderr, flush=True)
        if other["score"] != made.scheme.total:
            return f"{path.name}, seed {seed}: {other}"
    if starter["status"] != "graded" or starter["score"] != 0 or passed:
        return f"the starter: {starter['status']}, {starter['score']}, {starter['message']}, {passed}"
    return ""


class EveryLab(unittest.TestCase):
    names: list[str] = []

    def test_the_solution_gets_full_marks_and_the_starter_none(self):
        chosen = [lab for lab in labs.all_labs() if not self.names or lab.number in self.names]
        self.assertTrue(chosen)
        tree = student.set_up()
        built, output = student.build(tree, *(f"{lab.name}_{judge}" for lab in chosen for judge in ("judge", "hidden")
                                              if judge == "judge" or (lab.tests / "hidden.cpp").exists()),
                                      *(f"{lab.name}_worker_table" for lab in chosen))
        self.assertTrue(built, student.first_error(output))
        with kit.stage_folder() as stage, term.Slots(2) as slots, ThreadPoolExecutor(2) as pool:
            wrong = list(pool.map(lambda lab: slots.use(lambda box: graded(lab, pathlib.Path(stage), box)), chosen))
        for lab, what in zip(chosen, wrong):
            with self.subTest(lab.folder):
                self.assertEqual(what, "")


if __name__ == "__main__":
    EveryLab.names = [word for word in sys.argv[1:] if not word.startswith("-")]
    unittest.main(argv=[sys.argv[0]])
