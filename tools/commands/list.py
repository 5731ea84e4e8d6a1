# SPDX-License-Identifier: MIT
"""The labs and their steps."""

import json

import labs
import process

SUMMARY = "the labs and their steps"
USAGE = "list [--json]"


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY)
    parser.add_argument("--json", action="store_true")
    wish = parser.parse_args(arguments)
    known = labs.all_labs()
    if wish.json:
        print(json.dumps({"labs": [{"lab": lab.number, "title": lab.title, "folder": f"labs/{lab.folder}", "steps": lab.steps}
                                   for lab in known]}))
        return 0
    for lab in known:
        print(f"{lab.number}  {lab.title}  (labs/{lab.folder})")
        for i, step in enumerate(lab.steps, 1):
            print(f"      {i}. {step}")
    print("\nRead a lab's README.md, write the header beside it, then ask for its verdict and its picture:\n"
          "./lab check 01\n./lab run 01")
    return 0
