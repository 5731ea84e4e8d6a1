# SPDX-License-Identifier: MIT
"""does_not_compile.py FILE COMPILER [OPTION...]: the file must be refused, and for the reason that it states.

The file says `// must say: TEXT`, once or more: the compiler's message must hold every such text. With -DFIXED the file
must compile: nothing else is wrong with it."""

import re
import subprocess
import sys


def compile_file(path: str, compiler: list[str]) -> tuple[bool, str]:
    done = subprocess.run([*compiler, "-fsyntax-only", path], capture_output=True, text=True, errors="replace", check=False)
    return done.returncode == 0, done.stderr


def main() -> int:
    path, *compiler = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        text = file.read()
    expected = re.findall(r"^// must say: (.+?)\s*$", text, re.MULTILINE)
    if not expected or "FIXED" not in text:
        print(f"{path}: needs a line '// must say: TEXT', and what is right between #ifdef FIXED and #endif")
        return 1
    compiles, message = compile_file(path, [*compiler, "-DFIXED"])
    if not compiles:
        print(f"{path}: does not compile even when fixed:\n{message}")
        return 1
    compiles, message = compile_file(path, compiler)
    if compiles:
        print(f"{path}: compiles, and should not")
        return 1
    missing = [part for part in expected if part not in message]
    if missing:
        print(f"{path}: is refused, but the message does not say: {', '.join(missing)}\n{message}")
        return 1
    print(f"refused, and the message says: {', '.join(expected)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
