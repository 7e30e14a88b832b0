# SPDX-License-Identifier: GPL-3.0-or-later
"""The things that the pages refer to exist: other pages, their sections, pictures, scripts, sources and functions."""

import re
from pathlib import Path

root = Path(__file__).resolve().parents[2]
pages = [
    *(root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "Filters/Core/README.md")),
    *(root / "docs").glob("*.md"),
]
assert len(pages) > 10, pages

LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)\s]+))?\)", re.MULTILINE)
FUNCTION = re.compile(r"`(\w+)\(\)`")
PATH = re.compile(r"`((?:Data|Filters|Plugin|Testing|Utilities|cmake|docs)/[\w./-]+)`")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
BUILT = ("Testing/bin/",)


def anchor(heading):
    """The name that a section has on the web."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


sources = [path for path in (root / "Filters").rglob("*") if path.suffix in (".h", ".cxx")]
words = {word for path in sources for word in re.findall(r"\w+(?=\()", path.read_text(encoding="utf-8"))}

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
    if page.name in ("architecture.md", "mathematics.md"):
        for function in FUNCTION.findall(text):
            references += 1
            if function not in words:
                dead.append(f"{page.name}: no source has {function}()")
assert references > 80, references  # or the patterns above find nothing
assert not dead, "\n".join(dead)

# The README is one page, and its tables fit on a screen.
readme = (root / "README.md").read_text(encoding="utf-8").splitlines()
assert len(readme) <= 120, f"README.md has {len(readme)} lines"
wide = [line for line in readme if line.startswith("|") and len(line) > 120]
assert not wide, wide
