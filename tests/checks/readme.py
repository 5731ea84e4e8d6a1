# SPDX-License-Identifier: MIT
"""Are the README's tables those of the house (`readme.py --write` makes them so), and has every lab its workflow preset?"""

import json
import pathlib
import re
import sys

from floors import HEADERS, ROOT, listed

README = ROOT / "README.md"


def sentence(name: str) -> str:
    """What a header says of itself: the first sentence of its comment, which may go on in a second line."""
    lines = (HEADERS / f"{name}.hpp").read_text(encoding="utf-8").splitlines()[2:]
    text = ""
    for line in lines:
        if not line.startswith("//"):
            break
        text += " " + line[2:].strip()
        if text.endswith("."):
            break
    return text.strip()


def headers() -> str:
    rows = ["| floor | header | what it is for |", "|---|---|---|"]
    for name, floor in sorted(listed().items(), key=lambda item: (item[1], item[0])):
        if (HEADERS / f"{name}.hpp").is_file():
            rows.append(f"| {floor} | [`{name}`](include/lantern/{name}.hpp) | {sentence(name)} |")
    return "\n".join(rows) + "\n"


def labs() -> str:
    rows = ["| lab | what you write |", "|---|---|"]
    for path in sorted((ROOT / "labs").glob("lab[0-9][0-9]_*/lab.json")):
        lab = json.loads(path.read_text(encoding="utf-8"))
        folder = path.parent.name
        rows.append(f"| [{folder[3:5]} {lab['title']}](labs/{folder}/README.md) | {'; '.join(lab['steps'])} |")
    return "\n".join(rows) + "\n"


def example() -> str:
    source = (ROOT / "examples" / "one_sphere.cpp").read_text(encoding="utf-8")
    return source.removeprefix("// SPDX-License-Identifier: MIT\n")


def current(text: str) -> str:
    for name, table in (("labs", labs()), ("headers", headers())):
        text = re.sub(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", lambda m, t=table: m[1] + t + m[2], text, flags=re.DOTALL)
    return re.sub(r"(<!-- file: examples/one_sphere.cpp -->\n```cpp\n).*?(```)", lambda m: m[1] + example() + m[2], text,
                  flags=re.DOTALL)


def main() -> int:
    text = README.read_text(encoding="utf-8")
    wanted = current(text)
    if "--write" in sys.argv[1:]:
        README.write_text(wanted, encoding="utf-8")
        return 0
    missing = [path for path in re.findall(r"\]\(([^)#:]+)\)", text) if not (ROOT / path).exists()]
    for path in missing:
        print(f"README.md links to {path}, which is not there")
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    workflows = {preset["name"] for preset in presets["workflowPresets"]}
    without = [path.parent.name for path in (ROOT / "labs").glob("lab*/lab.json") if path.parent.name[:5] not in workflows]
    for folder in sorted(without):
        print(f"CMakePresets.json has no workflow {folder[:5]}: copy that of another lab, with its build and test preset")
    if text != wanted:
        print("README.md is behind the house; this brings it up to date: python3 tests/checks/readme.py --write")
    return 1 if missing or without or text != wanted else 0


if __name__ == "__main__":
    sys.exit(main())
