# SPDX-License-Identifier: MIT
"""./lab report --submissions, with a course of lab 13 in which everybody makes another mistake: is each told what is wrong?

Skipped (77) where no Python with matplotlib is."""

import json
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import browser  # noqa: E402
import callgrind  # noqa: E402
import labs  # noqa: E402
import machine  # noqa: E402
from reporting import pieces, points  # noqa: E402
from commands import report  # noqa: E402

LAB = labs.find("13")
SOLUTION = LAB.solution_file.read_text(encoding="utf-8")
STRATUM = "    return lantern::permute(i, count, lantern::hash(pixel.x, pixel.y, purpose));\n"
CELLS = "    return {count / rows, rows};\n"

# What is in the place of which lines; what is found; and words of the sentence that says so.
COURSE = {
    "sound": ([], "sound", "Sound in all 6 pictures"),
    "other_order": ([(STRATUM, "    return lantern::permute(count - 1 - i, count, lantern::hash(purpose, 7u, pixel.y, pixel.x));\n")], "sound", "Sound"),
    # "Ray Tracing in One Weekend", issue 1370: a grid of ⌊√n⌋² cells, whatever n is
    "floor_of_the_root": ([(CELLS, "    rows = static_cast<std::uint32_t>(std::sqrt(float(count)));\n    return {rows, rows};\n")], "biased", "numbers that are none"),
    "one_order_for_all": ([(STRATUM, "    return lantern::permute(i, count, lantern::hash(pixel.x, pixel.y));\n")], "biased", "Each effect alone comes out right"),
    "drawn_with_replacement": ([(STRATUM, "    return std::uint32_t(lantern::hash(i, pixel.x, pixel.y, purpose) % count);\n")], "slow", "Slow in"),
    "half_of_the_square": ([(STRATUM, "    return lantern::permute(i, count, lantern::hash(pixel.x, pixel.y, purpose)) / 2;\n")], "biased", "At worst z"),
    "starter": ([], "gap", "lab13 step 5"),
    "no_header_at_all": ([], "broken", "does not compile"),
    "crashes": ([(STRATUM, "    if (count > 40) { volatile int* nowhere = nullptr; *nowhere = 1; }\n" + STRATUM)], "broken", "memory that is not its own"),
    "for_ever": ([(STRATUM, "    for (volatile std::uint32_t k = 0; count > 40; k = k + 1) {}\n" + STRATUM)], "broken", "did not end in time"),
    "leaves": ([(STRATUM, "    if (count > 40) std::exit(0);\n" + STRATUM)], "broken", "ended too early"),
    "throws": ([(STRATUM, "    if (count > 40) throw std::out_of_range(\"<b>$x_1$</b>\");\n" + STRATUM)], "broken", "<b>$x_1$</b>"),
    # Forges what it can reach: a curve, before main. What is read is points.
    "forges": ([("namespace lab13 {\n", "namespace lab13 {\ninline const int forged = std::printf(\"{\\\"curves\\\":[]}\\n\") + std::fflush(stdout);\n")], "broken", "before it was asked"),
    "_talks $much$": ([(STRATUM, "    std::printf(\"%u\\n\", i);\n" + STRATUM)], "sound", "Sound"),
}
SEEN_UNTIL_40 = {"crashes", "for_ever", "leaves", "throws"}


def fail(text: str) -> None:
    sys.exit(f"students_test: {text}")


def written(folder: pathlib.Path) -> None:
    for name, (edits, _, _) in COURSE.items():
        text = SOLUTION.replace("#include <vector>\n", "#include <cstdio>\n#include <cstdlib>\n#include <stdexcept>\n#include <vector>\n", 1)
        for old, new in edits:
            if text.count(old) != 1:
                fail(f"{name}: this stands {text.count(old)} times in the solution:\n{old}")
            text = text.replace(old, new)
        if name == "starter":
            text = labs.starter_of(SOLUTION)
        if name == "no_header_at_all":
            text = "nothing of the kind\n"
        (folder / name).mkdir()
        (folder / name / LAB.header).write_text(text, encoding="utf-8")


def main() -> int:
    if machine.plotter() is None:
        print("no Python with matplotlib is here")
        return 77
    points.CPU = 3
    pieces.built_tests = lambda tree: []  # what is not about students is left out: page_test.py looks at that
    callgrind.works = lambda: False
    with tempfile.TemporaryDirectory() as name:
        handed_in, out = pathlib.Path(name) / "handed_in", pathlib.Path(name) / "out"
        handed_in.mkdir()
        written(handed_in)
        if report.run(["--quick", "--out", str(out), "--lab", "13", "--submissions", str(handed_in), "--trust"]) != 0:
            fail("the report did not end well")
        data = json.loads((out / "report.json").read_text(encoding="utf-8"))
        found = {entry["name"]: entry for entry in data["submissions"]}
        if set(found) != set(COURSE):
            fail(f"the course is {sorted(found)}")
        for who, (_, kind, words) in COURSE.items():
            entry = found[who]
            said = "\n".join([entry["message"], entry["headline"], *(one["sentence"] for one in entry["curves"])])
            if entry["worst"] != kind or words not in said:
                fail(f"{who}: expected {kind} and \"{words}\", found {entry['worst']}:\n{said}")
            if who in SEEN_UNTIL_40 and [row["samples"] for row in entry["curves"][0]["rows"]] != [4, 10, 16, 40]:
                fail(f"{who}: of what came before the end not all is there")
            if entry["outlier"] != (kind != "sound"):
                fail(f"{who} is {'' if entry['outlier'] else 'not '}marked")
        bad = {(one["effect"], one["kind"]) for one in found["one_order_for_all"]["curves"] if one["kind"] != "sound"}
        if bad != {("two effects at once", "biased")}:
            fail(f"one order for all purposes: {bad}")
        text = (out / "index.html").read_text(encoding="utf-8")
        if "<b>$x_1$</b>" in text:
            fail("what a student's program says stands in the page as it is")
        for who in COURSE:
            if f"<summary>{who}</summary>" not in text:
                fail(f"the page does not name {who}")
        if text.count("all submissions: RMSE against samples") != 6:
            fail("a figure of all submissions is missing")
        problem = browser.looked_at(out, pictures=7 * 6, plots=3 * 6 + 1)
        if problem:
            fail(problem)
    print("each mistake is told by its own name")
    return 0


sys.exit(main())
