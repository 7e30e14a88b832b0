# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pages refer to is there: other pages, their sections, pictures, scripts and sources."""

import re
from pathlib import Path

root = Path(__file__).resolve().parents[2]
pages = [root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md", *(root / "docs").glob("*.md")]
assert len(pages) > 10, pages

LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)\s]+))?\)", re.MULTILINE)
PATH = re.compile(r"`((?:Data|Filters|Plugin|Testing|Utilities|cmake|docs)/[\w./-]+)`")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
BUILT = ("Testing/bin/",)


def anchor(heading):
    """The name that a section has on the web."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


dead = []
references = 0
for page in pages:
    text = page.read_text(encoding="utf-8")
    for target, section in LINK.findall(text):
        if "://" in target:
            continue
        references += 1
        found = (page.parent / target).resolve() if target else page
        if not found.exists():
            dead.append(f"{page.name}: {target}")
        elif section and section not in map(anchor, HEADING.findall(found.read_text(encoding="utf-8"))):
            dead.append(f"{page.name}: {target}#{section}")
    for path in PATH.findall(text):
        references += 1
        if not path.startswith(BUILT) and not (root / path).exists():
            dead.append(f"{page.name}: {path}")
assert references > 80, references  # or the patterns above find nothing
assert not dead, "\n".join(dead)
