# SPDX-License-Identifier: MIT
"""A student's marks for others to read: Gradescope's results.json, JUnit's XML, a page. All text in them may be hostile."""

import html
import json
import re
import xml.etree.ElementTree as ET

from grading.archive import plain, plain_lines
from grading.kit import Kit

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff }
h1, h2 { line-height: 1.2 } h2 { margin-top: 2.5rem } .points { float: right; font-weight: normal }
table { border-collapse: collapse; width: 100% } td, th { text-align: left; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #ddd; vertical-align: top }
td.number, th.number { text-align: right } pre { background: #f5f5f2; padding: .5rem .75rem; overflow-x: auto; white-space: pre-wrap; font-size: .85rem }
.good { color: #17722f } .bad { color: #b3261e } .quiet { color: #666 } img { max-width: 100%; image-rendering: auto } figure { margin: 1rem 0 }
.bar { background: #e6e6e0; height: .7rem; border-radius: .35rem; overflow: hidden } .bar i { display: block; height: 100%; background: #3a7d44 }
a { color: #1a56a0 } svg text { font: 12px system-ui, sans-serif; fill: #444 }
"""


def text(value: object) -> str:
    """For HTML, between tags and within attributes."""
    return html.escape(plain(str(value)), quote=True)


def page(title: str, body: str) -> str:
    return ("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' data:; style-src 'unsafe-inline'\">\n"
            f"<meta name=\"viewport\" content=\"width=device-width\">\n<title>{text(title)}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n{body}\n</body>\n</html>\n")


def number(value: float) -> str:
    return f"{value:g}"


def gradescope(kit: Kit, result: dict) -> str:
    tests = []
    for i, (step, scheme) in enumerate(zip(result["steps"], kit.scheme.steps), 1):
        public = [test for test in step["tests"] if not test["hidden"]]
        lines = [result["message"]] if result["status"] != "graded" and i == 1 else []
        lines += [step["trouble"]] if step["trouble"] else []
        for test in public:
            lines.append(("passed: " if test["passed"] else "FAILED: ") + test["name"])
            lines += ["    " + line for line in test["says"]]
        if any(test["hidden"] and not test["passed"] for test in step["tests"]) and all(test["passed"] for test in public):
            lines.append("A test with other inputs does not hold: the step is not right for all of them yet.")
        tests.append({"name": f"Step {i}: {step['name']}", "score": step["points"], "max_score": step["of"],
                      "status": "passed" if step["points"] == step["of"] else "failed", "output": "\n".join(lines), "output_format": "text",
                      "visibility": scheme.visibility})
        tests += [{"name": f"Step {i}, with other inputs: {test['name']}", "status": "passed" if test["passed"] else "failed", "output": "",
                   "visibility": scheme.hidden} for test in step["tests"] if test["hidden"]]
    return json.dumps({"score": result["score"], "output": plain_lines(result["message"]), "output_format": "text", "visibility": "visible",
                       "stdout_visibility": "hidden", "tests": tests, "extra_data": {"lab": result["lab"]}}, indent=1)


def junit(result: dict, student: str) -> str:
    root = ET.Element("testsuites", name=plain(f"lab {result['lab']}: {student}"))
    for i, step in enumerate(result["steps"], 1):
        failed = [test for test in step["tests"] if not test["passed"]]
        suite = ET.SubElement(root, "testsuite", name=plain(f"step {i}: {step['name']}"), tests=str(len(step["tests"])), failures=str(len(failed)), errors="0",
                              skipped="0", time="0")
        for test in step["tests"]:
            case = ET.SubElement(suite, "testcase", name=plain(test["name"]), classname=f"lab{result['lab']}.step{i}", time="0")
            if not test["passed"]:
                says = test["says"] or [result["message"] if result["status"] != "graded" and not test["hidden"] else "does not hold"]
                ET.SubElement(case, "failure", message=plain(says[0])[:200]).text = plain_lines("\n".join(says))
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def student_page(kit: Kit, result: dict, student: str) -> str:
    parts = [f"<p class=\"quiet\"><a href=\"../../overview.html\">Lab {text(kit.lab.number)}: {text(kit.lab.title)}</a></p>",
             f"<h1>{text(student)} <span class=\"points\">{number(result['score'])} of {number(result['of'])}</span></h1>"]
    if result["status"] != "graded":
        parts.append(f"<p class=\"bad\">Not graded test by test, since the header was refused:</p>\n<pre>{html.escape(plain_lines(result['message']))}</pre>")
    elif result["message"]:
        parts.append(f"<p>{text(result['message'])}</p>")
    for mistake in result.get("mistakes", []):
        parts.append(f"<p>{'A known mistake' if mistake['sure'] else 'Perhaps a known mistake'}: {text(mistake['who'])}</p>")
    for i, step in enumerate(result["steps"], 1):
        kind = "good" if step["points"] == step["of"] else "bad"
        parts.append(f"<h2 class=\"{kind}\">Step {i}: {text(step['name'])} <span class=\"points\">{number(step['points'])} of {number(step['of'])}</span></h2>")
        if step["trouble"]:
            parts.append(f"<p class=\"bad\">It {text(step['trouble'])}</p>")
        for test in step["tests"]:
            mark = "<span class=\"good\">✓</span>" if test["passed"] else "<span class=\"bad\">✗</span>"
            note = " <span class=\"quiet\">(with other inputs)</span>" if test["hidden"] else ""
            says = f"<pre>{html.escape(plain_lines(chr(10).join(test['says'])))}</pre>" if test["says"] else ""
            parts.append(f"<div>{mark} {text(test['name'])}{note}{says}</div>")
    if result["pictures"]:
        parts.append("<h2>Pictures</h2>")
        parts += [f"<figure><img src=\"pictures/{text(name)}\" alt=\"{text(name)}\"><figcaption class=\"quiet\">{text(name)}</figcaption></figure>"
                  for name in result["pictures"] if re.fullmatch(r"[\w.-]+", name)]
    return page(f"{student}, lab {kit.lab.number}", "\n".join(parts))
