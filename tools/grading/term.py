# SPDX-License-Identifier: MIT
"""Grading many submissions: in parallel, each written as soon as it is done, so that a run that was killed goes on where it was."""

import fcntl
import hashlib
import json
import os
import pathlib
import queue
import re
import secrets
import shutil
import sys
import threading
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from dataclasses import dataclass

import whole
from grading import archive, mistakes, overview, report, submission
from grading.kit import Kit
from grading.sandbox import Sandbox
from labs import Problem


class Slots:
    """One sandbox for each thread, on a processor of its own: judge and worker speak to each other fastest on the same one."""

    def __init__(self, count: int, way: str | None = None):
        self.free: queue.SimpleQueue[tuple[Sandbox, int]] = queue.SimpleQueue()
        self.boxes = [Sandbox(way) for _ in range(count)]
        processors = sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []
        for i, box in enumerate(self.boxes):
            self.free.put((box, processors[i % len(processors)] if processors else -1))

    def __enter__(self) -> "Slots":
        return self

    def __exit__(self, *_) -> None:
        for box in self.boxes:
            box.close()

    def use(self, work):
        box, processor = self.free.get()
        try:
            if processor >= 0:
                os.sched_setaffinity(0, {processor})  # of this thread, and of what it starts
            return work(box)
        finally:
            self.free.put((box, processor))


@dataclass
class Student:
    name: str     # to be shown
    folder: str   # below OUT/students
    path: pathlib.Path


def students(folder: pathlib.Path) -> list[Student]:
    """A name of plain characters for each submission's folder; what had to be changed for that is told apart by a digest."""
    found, taken = [], set()
    for path in archive.submissions(folder):
        name = next((path.name[:-len(ending)] for ending in (*archive.ARCHIVES, *archive.KEPT) if path.name.lower().endswith(ending) and not path.is_dir()),
                    path.name)
        shown = archive.plain(name)
        safe = re.sub(r"[^A-Za-z0-9._-]", "_", name)[:60].strip(".") or "_"
        if safe != name or safe.lower() in taken:
            safe += "-" + hashlib.sha256(os.fsencode(path.name)).hexdigest()[:8]
        taken.add(safe.lower())
        found.append(Student(shown, safe, path))
    names = [student.name for student in found]
    for student in found:  # two of the same name: told apart by the folder
        if names.count(student.name) > 1:
            student.name += f" [{student.folder}]"
    return found


class Term:
    """One lab's submissions, and the folder where their marks go."""

    def __init__(self, kit: Kit, out: pathlib.Path, seed: int | None, pictures: bool):
        self.kit, self.out, self.pictures = kit, out, pictures
        out.mkdir(parents=True, exist_ok=True)
        self.lock = open(out / ".lock", "w")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Problem(f"another ./lab grade is writing to {out}") from None
        self.seed = self._seed(seed)
        self.known: dict[str, mistakes.Pattern] = {}
        self.who = {mutant.name: mutant.who for mutant in kit.lab.mutants()}

    def _seed(self, wished: int | None) -> int:
        """The seed of the hidden tests: as wished, or that of the run that is resumed, or a new one."""
        file = self.out / "run.json"
        try:
            before = json.loads(file.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            before = {}
        if before.get("lab", self.kit.lab.number) != self.kit.lab.number:
            raise Problem(f"{self.out} holds the marks of lab {before['lab']}")
        seed = wished if wished is not None else before.get("seed", secrets.randbelow(1 << 48))
        whole.write(file, json.dumps({"lab": self.kit.lab.number, "seed": seed, "kit": self.kit.digest, "sandbox": str(self.kit.level)}), errors="replace")
        return seed

    def grade(self, student: Student, box: Sandbox) -> dict:
        """From the folder, when this very submission was graded by this very kit before."""
        folder = self.out / "students" / student.folder
        kept = self._kept(folder)
        before = {"before": kept["score"] if kept else None}  # what an earlier grading gave: an appeal, or a test that was mended
        try:
            files, where = archive.placed(archive.read(student.path), self.kit.lab)
        except archive.Refused as refused:
            if kept and kept["status"] == "refused":  # still so
                before = {"before": kept.get("before")}
            result = submission.refusal(self.kit, str(refused), self.seed) | {"student": student.name} | before
            self.write(student, result)
            return result
        key = f"{self.kit.digest}-{submission.digest(files)}-{self.seed}-{'p' if self.pictures else 'n'}{'h' if self.kit.show_hidden else ''}"
        if kept and kept.get("key") == key:
            found = mistakes.found_in(kept, self.known, self.who)
            if self.known and kept["mistakes"] != found:  # the run before did not look for them, or knew others
                kept["mistakes"] = found
                self.write(student, kept)
            return kept
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for attempt in (1, 2):
            try:
                result = submission.graded(self.kit, files, box, self.seed, folder / "pictures" if self.pictures else None)
                break
            except (submission.Infrastructure, OSError) as problem:
                if attempt == 2:
                    return submission.refusal(self.kit, f"not graded, since the machine failed: {problem}", self.seed) | {"status": "error", "student": student.name}
        result |= {"key": key, "student": student.name, "header": archive.plain(where), "mistakes": mistakes.found_in(result, self.known, self.who)} | before
        self.write(student, result)
        return result

    @staticmethod
    def _kept(folder: pathlib.Path) -> dict | None:
        """What an earlier run wrote about a student, if it is whole."""
        try:
            kept = json.loads((folder / "result.json").read_text(encoding="utf-8"))
            return kept if {"score", "steps", "mistakes"} <= kept.keys() else None
        except (OSError, ValueError, AttributeError):
            return None

    def write(self, student: Student, result: dict) -> None:
        folder = self.out / "students" / student.folder
        folder.mkdir(parents=True, exist_ok=True)
        whole.write(folder / "results.json", report.gradescope(self.kit, result), errors="replace")
        whole.write(folder / "junit.xml", report.junit(result, student.name), errors="replace")
        whole.write(folder / "index.html", report.student_page(self.kit, result, student.name), errors="replace")
        whole.write(folder / "result.json", json.dumps(result, indent=1))  # the last: where it is, all is there

    def write_class(self, everyone: list[Student], results: dict[str, dict]) -> None:
        rows = [(student.name, results[student.folder]) for student in everyone if student.folder in results]
        whole.write(self.out / "gradebook.csv", overview.gradebook(self.kit, rows), errors="replace")
        whole.write(self.out / "changes.csv", overview.changes(rows), errors="replace")
        whole.write(self.out / "overview.html", overview.overview(self.kit, rows, {student.name: student.folder for student in everyone}, self.seed), errors="replace")


def run_all(works: list, jobs: int, done) -> None:
    """Runs all; `done(i, result)` as each ends. When it is interrupted, what has begun is ended in order and no more is begun."""
    pool = ThreadPoolExecutor(jobs)
    pending = {pool.submit(work): i for i, work in enumerate(works)}
    try:
        while pending:
            finished, _ = wait(pending, return_when=FIRST_COMPLETED, timeout=1)
            for future in finished:
                done(pending.pop(future), future.result())
    except BaseException:
        pool.shutdown(wait=True, cancel_futures=True)
        raise
    pool.shutdown()


class Progress:
    """A bar where there is a terminal, else a line for each."""

    def __init__(self, count: int, what: str):
        self.count, self.what, self.done, self.bar = count, what, 0, sys.stderr.isatty()
        self.lock = threading.Lock()

    def step(self, line: str) -> None:
        with self.lock:
            self.done += 1
            if self.bar:
                full = 30 * self.done // max(1, self.count)
                print(f"\r\033[K{self.what} [{'█' * full}{'·' * (30 - full)}] {self.done} of {self.count}  {line[:60]}", end="" if self.done < self.count else "\n",
                      file=sys.stderr, flush=True)
            elif line:
                print(f"{self.done:>4} of {self.count}  {line}", file=sys.stderr, flush=True)
