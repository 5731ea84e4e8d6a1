# SPDX-License-Identifier: MIT
"""Pieces of a page: plots, pictures, figures, tables."""

import base64
import html
import pathlib


def escape(text: object) -> str:
    return html.escape(str(text))


def slug(text: str) -> str:
    """A name for files."""
    return text.replace(" ", "_")


def svg(name: str, folder: pathlib.Path) -> str:
    return f'<div>{(folder / "figures" / f"{name}.svg").read_text(encoding="utf-8")}</div>'


def images(names: list[str], caption: str, folder: pathlib.Path) -> str:
    """Pictures above each other, with one caption."""
    text = ""
    for name in names:
        data = base64.b64encode((folder / "pictures" / f"{name}.png").read_bytes()).decode()
        text += f'<img alt="{escape(name.replace("_", " "))}" src="data:image/png;base64,{data}">'
    return f"<figure>{text}<figcaption>{escape(caption)}</figcaption></figure>"


def figure(x: float | None, pattern: str = "{:.3g}") -> str:
    return "–" if x is None else pattern.format(x).replace("-", "−")


def duration(seconds: float | None) -> str:
    if seconds is None:
        return "–"
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def table(head: list[str], rows: list[list[str]]) -> str:
    """Cells are HTML. A cell, or a head, that begins with "~" is text: to the left, and it may be broken into lines."""
    def cell(text: str) -> str:
        return f'<td class="text">{text[1:]}</td>' if text.startswith("~") else f"<td>{text}</td>"
    return ('<div class="table"><table><thead><tr>' + "".join(f'<th class="text">{name[1:]}</th>' if name.startswith("~") else f"<th>{name}</th>" for name in head) + "</tr></thead><tbody>" +
            "".join("<tr>" + "".join(map(cell, row)) + "</tr>" for row in rows) + "</tbody></table></div>")
