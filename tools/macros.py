# SPDX-License-Identifier: MIT
"""The macros that a header leaves behind. They reach into every file that includes it, so none but the guard may stay."""

import re

_TOKENS = re.compile(r'''//[^\n]*|/\*.*?\*/|R"([^()\\\s]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*\'''', re.DOTALL)
_DIRECTIVE = re.compile(r"^[ \t\v\f]*(?:#|%:)[ \t\v\f]*(\w+)[ \t\v\f]*(\w*)", re.MULTILINE)


def left_behind(text: str) -> list[str]:
    """The names of all macros that a header defines, or takes away, and does not put back before it ends."""
    text = re.sub(r"\\[ \t]*\r?\n", "", text)
    text = _TOKENS.sub(lambda found: " " if found[0].startswith("/") else '""', text)
    directives = _DIRECTIVE.findall(text)
    guard = ""
    if len(directives) > 1 and directives[0][0] == "ifndef" and directives[1] == ("define", directives[0][1]):
        guard = directives[0][1]
    left: dict[str, bool] = {}
    own = set()
    for word, name in directives:
        if word == "define":
            own.add(name)
            left[name] = True
        elif word == "undef":
            left[name] = name not in own  # somebody else's: that is left behind, too
    return [name for name, stays in left.items() if stays and name != guard]
