# SPDX-License-Identifier: MIT
"""The class: gradebook.csv, and a page with the distribution, the steps that fail most, and the mistakes that are most common."""

import collections
import csv
import io
import unicodedata

from grading.archive import plain
from grading.kit import Kit
from grading.report import number, page, text


def cell(value: object) -> str:
    """A cell that no spreadsheet takes for a formula (OWASP, CSV Injection)."""
    shown = plain(str(value))
    first = unicodedata.normalize("NFKC", shown.lstrip())[:1]
    return "'" + shown if first and first in "=+-@|%" else shown


def gradebook(kit: Kit, rows: list[tuple[str, dict]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, quoting=csv.QUOTE_MINIMAL, lineterminator="\r\n")
    writer.writerow(["student", "status", "score", "of", *(f"step {i}" for i in range(1, len(kit.lab.steps) + 1)), "remark"])
    for student, result in rows:
        remark = result["message"].splitlines()[0] if result["message"] else ""
        writer.writerow([cell(student), result["status"], number(result["score"]) if result["status"] != "error" else "", number(result["of"]),
                         *(number(step["points"]) for step in result["steps"]), cell(remark)])
    return out.getvalue()


def changes(rows: list[tuple[str, dict]]) -> str:
    """Whose points are others than an earlier grading gave, into the same folder."""
    out = io.StringIO()
    writer = csv.writer(out, quoting=csv.QUOTE_MINIMAL, lineterminator="\r\n")
    writer.writerow(["student", "before", "now", "of"])
    for student, result in rows:
        if result["status"] != "error" and result.get("before") not in (None, result["score"]):
            writer.writerow([cell(student), number(result["before"]), number(result["score"]), number(result["of"])])
    return out.getvalue()


def overview(kit: Kit, rows: list[tuple[str, dict]], folders: dict[str, str], seed: int) -> str:
    graded = [result for _, result in rows if result["status"] != "error"]
    scores = sorted(result["score"] for result in graded)
    parts = [f"<h1>Lab {text(kit.lab.number)}: {text(kit.lab.title)}</h1>"]
    if scores:
        middle = (scores[(len(scores) - 1) // 2] + scores[len(scores) // 2]) / 2
        parts.append(f"<p>{len(rows)} submissions; mean {number(round(sum(scores) / len(scores), 2))}, median {number(middle)} of {number(kit.scheme.total)}; "
                     f"{sum(result['status'] == 'refused' for result in graded)} refused, {len(rows) - len(graded)} not graded. "
                     f"Sandbox: {text(kit.level)}. Seed of the hidden tests: {seed}.</p>")
        parts += ["<h2>Distribution</h2>", histogram(scores, kit.scheme.total), "<h2>Steps</h2>", steps_table(kit, graded)]
    mistakes = collections.Counter((mistake["name"], mistake["who"]) for result in graded for mistake in result.get("mistakes", []))
    if mistakes:
        parts.append("<h2>Mistakes</h2><p>Matched to the lab's mutants by the tests that fail.</p><table>")
        parts += [f"<tr><td class=\"number\">{count}</td><td>{text(name)}</td><td>{text(who)}</td></tr>" for (name, who), count in mistakes.most_common(12)]
        parts.append("</table>")
    parts.append("<h2>Students</h2><table><tr><th>student</th><th class=\"number\">points</th><th>steps</th><th></th></tr>")
    for student, result in rows:
        marks = "".join("<span class=\"good\">●</span>" if step["points"] == step["of"] else "<span class=\"bad\">○</span>" if not step["points"] else
                        "<span>◐</span>" for step in result["steps"])
        remark = result["message"].splitlines()[0][:160] if result["message"] else ""
        parts.append(f"<tr><td><a href=\"students/{text(folders[student])}/index.html\">{text(student)}</a></td>"
                     f"<td class=\"number\">{number(result['score']) if result['status'] != 'error' else '–'}</td><td>{marks}</td><td class=\"quiet\">{text(remark)}</td></tr>")
    parts.append("</table>")
    return page(f"Lab {kit.lab.number}, overview", "\n".join(parts))


def histogram(scores: list[float], total: float) -> str:
    """How many submissions have which part of the points, in tenths."""
    counts = collections.Counter(min(9, int(10 * score / total)) if total else 0 for score in scores)
    most = max(counts.values())
    bars = []
    for i in range(10):
        height = 140 * counts[i] / most
        bars.append(f"<rect x=\"{60 * i + 8}\" y=\"{160 - height:.1f}\" width=\"44\" height=\"{height:.1f}\" fill=\"#3a7d44\"/>"
                    f"<text x=\"{60 * i + 30}\" y=\"{155 - height:.1f}\" text-anchor=\"middle\">{counts[i] or ''}</text>"
                    f"<text x=\"{60 * i + 30}\" y=\"178\" text-anchor=\"middle\">{number(round(total * i / 10, 1))}–{number(round(total * (i + 1) / 10, 1))}</text>")
    return f"<svg viewBox=\"0 0 600 185\" role=\"img\" aria-label=\"distribution of points\">{''.join(bars)}</svg>"


def steps_table(kit: Kit, graded: list[dict]) -> str:
    rows = ["<table><tr><th>step</th><th class=\"number\">complete</th><th></th><th>the test that fails most</th></tr>"]
    for i, name in enumerate(kit.lab.steps):
        good = sum(result["steps"][i]["points"] == result["steps"][i]["of"] for result in graded)
        failing = collections.Counter(test["name"] for result in graded if result["status"] == "graded"
                                      for test in result["steps"][i]["tests"] if not test["passed"] and not test.get("gap"))
        worst = failing.most_common(1)
        rows.append(f"<tr><td>{i + 1}. {text(name)}</td><td class=\"number\">{good} of {len(graded)}</td>"
                    f"<td style=\"width: 10rem\"><div class=\"bar\"><i style=\"width: {100 * good / len(graded):.0f}%\"></i></div></td>"
                    f"<td class=\"quiet\">{text(worst[0][0]) + f' ({worst[0][1]})' if worst else ''}</td></tr>")
    return "\n".join([*rows, "</table>"])
