# SPDX-License-Identifier: MIT
"""snippets.py COMPILER [OPTION...]: is the C++ in the documents true?

A ```cpp block that holds `int main` is compiled. One after `<!-- compile -->` is compiled as it stands, outside of any
function. One after `<!-- file: PATH -->` must be that file, letter by letter (its licence line may be missing)."""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?:<!--\s*(compile|file:\s*(\S+))\s*-->\s*\n)?^```cpp[^\n]*\n(.*?)^```\s*$", re.MULTILINE | re.DOTALL)
LICENCE = "// SPDX-License-Identifier: MIT\n"


def documents() -> list[pathlib.Path]:
    found = [ROOT / name for name in ("README.md", "CONTRIBUTING.md")]
    found += sorted((ROOT / "docs").rglob("*.md")) + sorted((ROOT / "labs").glob("*/README.md"))
    return [path for path in found if path.is_file()]


def check(where: str, mark: str, source: str, text: str, compiler: list[str]) -> str | None:
    """What is wrong with one block."""
    if source:
        file = ROOT / source
        if not file.is_file():
            return f"{where}: there is no {source}"
        actual = file.read_text(encoding="utf-8")
        if text not in (actual, actual.removeprefix(LICENCE)):
            return f"{where}: is not what stands in {source}"
        return None
    if not mark and "int main" not in text:
        return None
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "snippet.cpp"
        path.write_text(text, encoding="utf-8")
        done = subprocess.run([*compiler, "-fsyntax-only", str(path)], capture_output=True, text=True, errors="replace", check=False)
    return None if done.returncode == 0 else f"{where}: does not compile:\n{done.stderr[:3000]}"


def main() -> int:
    compiler = sys.argv[1:]
    blocks = []
    for path in documents():
        text = path.read_text(encoding="utf-8")
        for match in BLOCK.finditer(text):
            line = text.count("\n", 0, match.start(3)) + 1
            blocks.append((f"{path.relative_to(ROOT)}:{line}", match.group(1) or "", match.group(2) or "", match.group(3), compiler))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        problems = [problem for problem in pool.map(lambda block: check(*block), blocks) if problem]
    print("\n".join(problems) or f"{len(blocks)} blocks, all true")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
