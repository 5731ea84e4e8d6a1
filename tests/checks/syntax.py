# SPDX-License-Identifier: MIT
"""What a build did not compile, the compiler reads all the same: syntax.py FOLDER

Every source file of FOLDER/compile_commands.json of which FOLDER holds no object is checked with the options of its build, warnings
included; no code is made. For programs that no test of this build runs."""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(command: dict) -> str | None:
    words = shlex.split(command["command"])
    at = words.index("-o")
    del words[at:at + 2]
    done = subprocess.run([*words, "-fsyntax-only"], cwd=command["directory"], capture_output=True, text=True, errors="replace", check=False)
    return None if done.returncode == 0 else f"{pathlib.Path(command['file']).relative_to(ROOT)} does not compile:\n{done.stderr[:3000]}"


def main() -> int:
    build = pathlib.Path(sys.argv[1]).resolve()
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    wanted, compiled = {}, set()
    for command in commands:
        source = pathlib.Path(command["file"])
        if (build / re.search(r" -o (\S+)", command["command"])[1]).exists():
            compiled.add(source)
        elif source.is_file() and source.is_relative_to(ROOT):  # not what a build would make first, nor a dependency's
            wanted[source] = command  # once for each file; of a lab's, with the solution, which comes last
    missing = [command for source, command in wanted.items() if source not in compiled]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        problems = [problem for problem in pool.map(check, missing) if problem]
    print("\n".join(problems) or f"{len(missing)} more files, all right")
    return 1 if problems or not missing else 0


if __name__ == "__main__":
    sys.exit(main())
