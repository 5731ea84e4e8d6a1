# SPDX-License-Identifier: MIT
"""The report in a browser, wide and narrow, light and dark: does it show all that it should?"""

import pathlib
import re
import subprocess
import tempfile

import machine

# Runs in the page: what a person would see missing. Its answer is the title, which --dump-dom prints.
LOOK = """<script>
window.onerror = (message) => { document.title = 'ERROR ' + message; };
window.onload = () => {
  const problems = [];
  for (const image of document.images) if (!image.complete || image.naturalWidth === 0) problems.push('picture ' + image.alt);
  for (const plot of document.querySelectorAll('.plots svg')) {
    const box = plot.getBoundingClientRect();
    if (box.width < 100 || box.height < 80) problems.push('plot ' + plot.getAttribute('aria-label'));
    if (box.right > document.documentElement.clientWidth + 1) problems.push('too wide: ' + plot.getAttribute('aria-label'));
  }
  if (document.documentElement.scrollWidth > document.documentElement.clientWidth + 1) problems.push('the page is wider than the window');
  document.title = 'SEEN ' + document.images.length + ' ' + document.querySelectorAll('.plots svg').length + ' ' + problems.join('; ');
};
</script>"""


def looked_at(folder: pathlib.Path, pictures: int, plots: int) -> str:
    """What a browser misses in folder/index.html, of so many pictures and at least so many plots; nothing where there is no Chromium."""
    program = machine.browser()
    if program is None:
        return ""
    text = (folder / "index.html").read_text(encoding="utf-8").replace("</body>", LOOK + "</body>")
    (folder / "looked_at.html").write_text(text, encoding="utf-8")
    for width, dark in ((1200, False), (400, True)):
        with tempfile.TemporaryDirectory() as profile:
            done = subprocess.run([program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                                   f"--blink-settings=preferredColorScheme={0 if dark else 1}", f"--user-data-dir={profile}", f"--window-size={width},900",
                                   "--virtual-time-budget=5000", "--dump-dom", (folder / "looked_at.html").as_uri()],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        title = re.search(r"<title>(.*?)</title>", done.stdout)
        seen = title.group(1) if title else "nothing"
        if not seen.startswith(f"SEEN {pictures} ") or int(seen.split()[2]) < plots or seen.split()[3:]:
            return f"at a width of {width}, of {pictures} pictures and at least {plots} plots the browser says: {seen}"
    return ""
