# SPDX-License-Identifier: MIT
"""Judge and worker without a sandbox: judge_test.py JUDGE WORKER. Each test of the suite passes, but for those that say they fail."""

import pathlib
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import verdict  # noqa: E402

JUDGE = WORKER = ""


def run(worker: str | None, seconds: float = 60, call: float = 0.7) -> tuple[int | None, list[verdict.Test]]:
    with tempfile.TemporaryDirectory() as folder:
        command = pathlib.Path(folder) / "command"
        if worker is not None:
            command.write_bytes(worker.encode() + b"\0")
        environment = {"LANTERN_WORKER": str(command), "LANTERN_CALL_SECONDS": str(call), "LANTERN_CASE_SECONDS": str(3 * call)}
        status, tests, _ = verdict.run_tests(pathlib.Path(JUDGE), "*", seconds, environment)
        return status, tests


class Judge(unittest.TestCase):
    def test_each_test_ends_as_its_name_says(self):
        _, tests = run(WORKER)
        self.assertGreater(len(tests), 20)
        for test in tests:
            with self.subTest(test.name):
                self.assertTrue(test.finished)
                self.assertEqual(test.passed, not test.name.startswith("fails:"), test)
                if not test.passed:
                    self.assertTrue(test.where.startswith("suite.cpp:"), test.where)

    def test_a_loss_says_what_happened(self):
        said = {test.name: test.asked for test in run(WORKER)[1]}
        for name, words in {"an endless call": "in time", "many slow calls": "in time", "an answer with another serial": "another question",
                            "a message of 4 GiB": "too large", "two answers to one question": "another question", "bytes before the question": "before it was asked",
                            "a dead worker, where an exception is expected": "ended"}.items():
            self.assertIn(words, said["fails: " + name])

    def test_without_a_worker_nothing_passes(self):
        for worker in (None, "/nonexistent", "/bin/true", "/bin/cat"):
            with self.subTest(worker):
                status, tests = run(worker, call=0.3)
                self.assertGreater(len(tests), 20)
                self.assertEqual([test.name for test in tests if test.passed], [])
                self.assertNotEqual(status, 0)

    def test_the_judge_ends_its_worker_with_itself(self):
        began = time.monotonic()
        status, _ = run(WORKER, seconds=0.5, call=30)
        self.assertIsNone(status)
        self.assertLess(time.monotonic() - began, 20)


if __name__ == "__main__":
    JUDGE, WORKER = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], "-v"])
