# SPDX-License-Identifier: MIT
"""./lab report, small: is the page whole, does it go on where it was stopped, and does a browser show all of it?

Skipped (77) where no Python with matplotlib is; the browser's part where no Chromium is."""

import csv
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import browser  # noqa: E402
import machine  # noqa: E402
import prices  # noqa: E402
from reporting import pieces  # noqa: E402

VOID = {"meta", "img", "br", "link", "use", "path", "image"}

class Tags(html.parser.HTMLParser):
    """Complains about tags that do not close, or close what is not open."""

    def __init__(self):
        super().__init__()
        self.open, self.problems, self.ids = [], [], []

    def handle_starttag(self, tag, attributes):
        self.ids += [value for name, value in attributes if name == "id"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.ids += [value for name, value in attributes if name == "id"]

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> at {self.getpos()}")


def fail(text: str) -> None:
    sys.exit(f"page_test: {text}")


def report(folder: pathlib.Path, *more: str) -> str:
    command = [sys.executable, str(ROOT / "tools" / "lab.py"), "report", "--quick", "--trials", "4", "--out", str(folder), *more]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        fail(f"exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def main() -> int:
    if machine.plotter() is None:
        print("no Python with matplotlib is here")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        report(folder)
        text = (folder / "index.html").read_text(encoding="utf-8")
        tags = Tags()
        tags.feed(text)
        if tags.problems or tags.open:
            fail(f"tags do not match: {tags.problems[:5]} {tags.open[:5]}")
        if len(set(tags.ids)) != len(tags.ids):
            fail(f"ids stand twice: {sorted({i for i in tags.ids if tags.ids.count(i) > 1})[:5]}")
        for address in re.findall(r'(?:src|href)="([^"]*)"', text):
            if not address.startswith(("#", "data:image/png;base64,")):
                fail(f"the page needs another file: {address[:80]}")
        data = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        if [effect["name"] for effect in data["effects"]] != pieces.EFFECTS:
            fail("report.json lacks an effect")
        with open(folder / "report.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        if len(rows) != len(pieces.EFFECTS) * len(pieces.SAMPLERS) * 4:  # 4, 16, 64, 256 samples
            fail(f"report.csv has {len(rows)} rows")

        # Stopped: what is missing is measured, and nothing else is.
        kept = {file: file.stat().st_mtime_ns for file in (folder / "measured").glob("*.json")}
        lost = sorted(kept)[0]
        lost.unlink()
        if f"{len(kept) - 1} of {len(kept)} measurements are there already" not in report(folder):
            fail("a report that was stopped does not go on")
        if not lost.is_file() or any(file.stat().st_mtime_ns != when for file, when in kept.items() if file != lost):
            fail("a report that was stopped measures anew what it has")

        if data["prices"]:
            with open(folder / "prices.csv", encoding="utf-8", newline="") as file:
                priced = {row["formula"]: row for row in csv.DictReader(file)}
            if list(priced) != list(prices.PRICED) or any(float(row["ours_cost"]) <= 0 or float(row["textbook_cost"]) <= 0 for row in priced.values()):
                fail(f"prices.csv holds {priced}")
            if sum(int(row["textbook_wrong"]) for row in priced.values()) == 0 or sum(int(row["ours_wrong"]) for row in priced.values()) != 0:
                fail("the textbook's formulas are right in all cases, or ours are not")

        problem = browser.looked_at(folder, pictures=7 * len(pieces.EFFECTS), plots=2 * len(pieces.EFFECTS) + 1)
        if problem:
            fail(problem)
        print("the page is whole, and a browser, where there is one, shows all of it")
    return 0


sys.exit(main())
