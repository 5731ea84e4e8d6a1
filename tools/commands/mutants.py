# SPDX-License-Identifier: MIT
"""Wrong answers, and whether the labs' tests catch them."""

import json
import sys

import lab_test
import labs
import process
import student

SUMMARY = "try the labs' tests on wrong answers"
USAGE = "mutants [NN...] [--json]"
EXAMPLES = """./lab mutants 03"""


def run(arguments: list[str]) -> int:
    parser = process.arguments(USAGE, SUMMARY, EXAMPLES)
    parser.add_argument("labs", nargs="*", metavar="NN", type=student.lab_named, help="labs' numbers (default: all)")
    parser.add_argument("--json", action="store_true", help='{"mutants": [{"lab", "name", "expected", "failed", "ok"}]}')
    wish = parser.parse_args(arguments)

    chosen = wish.labs or labs.all_labs()
    tree = student.set_up()
    answers = []
    for lab in chosen:
        built, output = student.build(tree, f"{lab.name}_mutants")
        if not built:
            raise labs.Problem(f"the mutants of lab {lab.number} do not build:\n{student.first_error(output)}")
        if not lab.mutants():
            raise labs.Problem(f"lab {lab.number} has no mutants: nothing was tried")
        for mutant in lab.mutants():
            failed, wrong = lab_test.mutant_verdict(lab, student.program(tree, f"{lab.name}_mutants"), mutant)
            answers.append({"lab": lab.number, "name": mutant.name, "expected": mutant.caught_by, "failed": failed, "ok": not wrong})
            if not wish.json:
                print(f"{'✓' if not wrong else '✗'} {lab.number} {mutant.name:<32} {mutant.who}", flush=True)
            for line in wrong:
                print(f"    {line}", file=sys.stderr if wish.json else sys.stdout)
    if wish.json:
        print(json.dumps({"mutants": answers}))
    else:
        print(f"\n{sum(answer['ok'] for answer in answers)} of {len(answers)} mutants are caught by the tests that they name")
    return 0 if answers and all(answer["ok"] for answer in answers) else 1
