# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/reference.md: what every filter takes and what it writes.

    python3 Utilities/docs/reference.py

The parameters come from the server-manager XML in Plugin, the arrays and field data from the class comments in Filters.
Every bullet of a list under "Output arrays ...:", "Field data ...:" or "Columns ...:" in a class comment is an array;
the kind is left out where the title says it:

    - <point|cell|vertex|row> `Name` (type x components, unit): sentence.
"""

import re
import textwrap
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

WIDTH = 120
ARRAY = re.compile(r"^(?:[\w ]+ )?(?:`[^`]+`(?:, | and )?)+(?: \(.+?\))?: \S.{8,}$")
TITLE = re.compile(r"^(?:Output|Field data|Columns)\b.*:$")

INTRODUCTION = """\
# Reference

This page lists every filter with its parameters, the arrays that it adds and its field data.
`Utilities/docs/reference.py` writes it from the server-manager XML in `Plugin` and the class comments in `Filters`; a
test compares the two. [glossary.md](glossary.md) explains the words, [numbers.md](numbers.md) says which values are
good.

A parameter is listed as **label in ParaView** (`name in scripts`, its values and default). Where pvpython has a name
of its own, the second name is that of C++ and of [Python without ParaView](python.md). In C++ the setter of a parameter
is `Set` and this name, unless another is given. *Advanced* parameters are shown by the gear of the panel.
Arrays that are not listed are kept as they are. Lengths and areas are in units of the surface.
"""


def sentence_of(element):
    return " ".join((element.findtext("Documentation") or "").split())


def label_of(setting):
    return setting.get("label") or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", setting.get("name"))


def wrapped(text, first="", rest=""):
    return textwrap.fill(
        text, WIDTH, initial_indent=first, subsequent_indent=rest, break_long_words=False, break_on_hyphens=False
    )


# Parameters, from the XML


def settings_of(proxy):
    return [child for child in proxy if child.tag.endswith("Property") and child.tag != "InputProperty"]


def inputs_of(proxy):
    return [child for child in proxy if child.tag == "InputProperty"]


def range_of(domain, kind):
    least, most = domain.get("min"), domain.get("max")
    least, most = (" ".join(dict.fromkeys(end.split())) if end else None for end in (least, most))
    if least and most:
        return f"{kind} from {least} to {most}"
    if least:
        return f"{kind}, {least} or more"
    return f"{kind}, {most} or less" if most else kind


def values_of(setting):
    """The values that a parameter may have, in words; and its default."""
    default = setting.get("default_values") or ""
    if setting.find("BooleanDomain") is not None:
        return "off or on", {"0": "off", "1": "on"}[default]
    entries = {entry.get("value"): entry.get("text") for entry in setting.iter("Entry")}
    if entries:
        return "one of " + ", ".join(f"*{text}*" for text in entries.values()), f"*{entries[default]}*"
    if setting.find("ArrayListDomain") is not None:
        return "an array", default.split(";")[-1]
    if setting.tag == "ProxyProperty":
        choices = [proxy.get("name") for proxy in setting.iter("Proxy")]
        return "one of " + ", ".join(f"*{name}*" for name in choices), f"*{choices[0]}*"
    if setting.tag == "StringVectorProperty":
        return "text", default
    kind = "whole number" if setting.tag == "IntVectorProperty" else "number"
    count = int(setting.get("number_of_elements") or 1)
    if setting.get("repeat_command"):
        kind = f"{kind}s, any number of them"
    elif count > 1:
        kind = f"{count} {kind}s"
    bounds = setting.find("BoundsDomain")
    if bounds is not None and bounds.get("mode") == "normal":
        return kind, "taken from the surface's bounds"
    for tag in ("IntRangeDomain", "DoubleRangeDomain"):
        if setting.find(tag) is not None:
            kind = range_of(setting.find(tag), kind)
    return kind, default


def setter_of(setting):
    command = setting.get("command")
    if command == "Set" + setting.get("name"):
        return []
    return [f"C++ `{command}`"]


def pvpython_name(setting):
    """The name of the attribute in paraview.simple, which ParaView makes of the label."""
    return re.sub(r"\W", "", label_of(setting), flags=re.ASCII)


def names_of(setting):
    """The names of a parameter in scripts, in words."""
    name, in_pvpython = setting.get("name"), pvpython_name(setting)
    return f"`{name}`" if name == in_pvpython else f"`{in_pvpython}` in pvpython, `{name}` elsewhere"


def parameter(setting):
    values, default = values_of(setting)
    facts = [names_of(setting), *setter_of(setting), values]
    if default:
        facts.append(f"default {default}")
    if setting.get("panel_visibility") == "advanced":
        facts.append("advanced")
    return wrapped(f"**{label_of(setting)}** ({'; '.join(facts)}): {sentence_of(setting)}", "- ", "  ")


def parameters(proxy):
    """The parameters in the groups and the order of ParaView's panel."""
    by_name = {setting.get("name"): setting for setting in settings_of(proxy)}
    titles = {}
    for group in proxy.iter("PropertyGroup"):
        for member in group:
            titles.setdefault(member.get("name"), group.get("label"))
    groups = {}
    alone = "Points that are set in the view"
    sizes = Counter(titles.get(name) for name in by_name)
    for name in [name for name in titles if name in by_name] + [name for name in by_name if name not in titles]:
        title = titles.get(name, "Other parameters")
        is_point = sizes[title] == 1 and label_of(by_name[name]) == title
        groups.setdefault(alone if is_point else title, []).append(by_name[name])
    for title, settings in groups.items():
        yield f"*{title}*"
        yield "\n".join(parameter(setting) for setting in settings)


def inputs(proxy):
    for port, setting in enumerate(sorted(inputs_of(proxy), key=lambda each: int(each.get("port_index") or 0))):
        text = sentence_of(setting)
        yield wrapped(f"**{label_of(setting)}** (port {port}): {text}", "- ", "  ")


# Arrays and field data, from the class comments


def class_comment(header):
    """The lines of the comment that has @class in it, without the asterisks."""
    text = header.read_text(encoding="utf-8")
    for comment in re.findall(r"/\*\*(.*?)\*/", text, re.DOTALL):
        if "@class" in comment:
            return [re.sub(r"^\s*\*? ?", "", line).rstrip() for line in comment.split("\n")]
    raise ValueError(f"{header.name}: no comment with @class")


def bullets(lines):
    """The bullets of a comment, each as (line before its list, text)."""
    title, texts = "", []
    for line in [*lines, ""]:
        if line.startswith("- "):
            texts.append(line[2:])
        elif texts and line.strip() and not TITLE.match(line):
            texts[-1] += " " + line.strip()
        else:
            yield from ((title, text) for text in texts)
            texts = []
            title = line.strip() or title


def arrays_of(header):
    """{title of a list of arrays in the class comment: [text of each entry]}."""
    found = {}
    for title, text in bullets(class_comment(header)):
        if TITLE.match(title):
            found.setdefault(title.rstrip(":"), []).append(text)
    return found


def remarks_of(header):
    """{title of a list of arrays: the paragraph above it}, for paragraphs between two such lists."""
    paragraphs = [part.split("\n") for part in "\n".join(class_comment(header)).split("\n\n")]
    found = {}
    for before, above, here in zip(paragraphs, paragraphs[1:], paragraphs[2:]):
        if TITLE.match(before[0]) and TITLE.match(here[0]) and not TITLE.match(above[0]):
            found[here[0].rstrip(":")] = " ".join(line.strip() for line in above)
    return found


def array_names(header):
    """The names of all arrays in a class comment."""
    heads = [text.split(":")[0] for entries in arrays_of(header).values() for text in entries]
    return [name for head in heads for name in re.findall("`([^`]+)`", head)]


def array_lists(header):
    remarks = remarks_of(header)
    for title, entries in arrays_of(header).items():
        yield f"*{title}*"
        if title in remarks:
            yield wrapped(remarks[title])
        yield "\n".join(wrapped(entry, "- ", "  ") for entry in entries)


# The page


def proxies(repository):
    """All proxies of the plugin, in the order of its menu, readers first among those that are not in it."""
    found = {
        proxy.get("name"): proxy
        for path in sorted((repository / "Plugin").glob("*.xml"))
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup")
        for proxy in group.iter("SourceProxy")
        if group.get("name") != "internal_filters"  # what the window uses alone
    }
    menu = [proxy.get("name") for proxy in ElementTree.parse(repository / "Plugin/Menu.xml").getroot().iter("Proxy")]
    return [found[name] for name in [*menu, *(name for name in found if name not in menu)]]


def guides(repository):
    """{label of a filter: the page of docs that explains it}, from the list of filters in README.md."""
    readme = (repository / "README.md").read_text(encoding="utf-8")
    return dict(re.findall(r"^- \[([^\]]+)\]\(docs/reference\.md#[^)]+\).*?\(docs/(\w+\.md)\b", readme, re.M))


def page_of(proxy, repository):
    """The page of a proxy that is no filter of README.md's list: one of a reader, or of VTK's or Python's filters."""
    neuro = ElementTree.parse(repository / "Plugin/NeuroFiles.xml").getroot().iter("SourceProxy")
    return "cortex.md" if proxy.get("name") in [other.get("name") for other in neuro] else "volumes.md"


def section(proxy, repository):
    kind, label = proxy.get("class"), proxy.get("label")
    header = repository / "Filters" / f"{kind}.h"
    yield f"## {label}"
    language = "C++" if kind.startswith("vtk") else "Python"
    # paraview.simple has the label, without its spaces.
    yield wrapped(f"`{label.replace(' ', '')}` in scripts, `{kind}` in {language}. {sentence_of(proxy)}")
    if label in guides(repository):
        page = guides(repository)[label]
        yield f"More: [{page}]({page})."
    elif not header.exists():
        own = " The class is VTK's own." if kind.startswith("vtk") else ""
        page = page_of(proxy, repository)
        yield f"More: [{page}]({page}).{own}"
    if inputs_of(proxy):
        yield f"### {label}: inputs"
        yield "\n".join(inputs(proxy))
    yield f"### {label}: parameters"
    yield from parameters(proxy)
    if header.exists():
        yield f"### {label}: arrays"
        yield from array_lists(header)


def blocks_section(repository):
    header = repository / "Filters/vtkBlockwisePolyDataAlgorithm.h"
    if not arrays_of(header):
        return
    yield "## Composite data sets"
    yield wrapped(
        "Every filter takes composite data sets, block by block ([composite_data.md](composite_data.md)), and adds to "
        "the field data of the whole:"
    )
    yield from array_lists(header)


def reference(repository):
    repository = Path(repository)
    parts = [INTRODUCTION.strip()]
    for proxy in proxies(repository):
        parts += section(proxy, repository)
    parts += blocks_section(repository)
    return "\n\n".join(parts) + "\n"


def undocumented(repository):
    """Parameters and arrays without a sentence, and arrays that the sources write but no class comment lists."""
    repository = Path(repository)
    for proxy in proxies(repository):
        for setting in [*settings_of(proxy), *inputs_of(proxy)]:
            if len(sentence_of(setting)) < 10:
                yield f"{proxy.get('name')}: {setting.get('name')} has no text"
        header = repository / "Filters" / f"{proxy.get('class')}.h"
        if header.exists():
            for text in (text for texts in arrays_of(header).values() for text in texts if not ARRAY.match(text)):
                yield f"{header.name}: the form of this entry is wrong: {text}"
            listed = array_names(header)
            if not listed:
                yield f"{header.name}: no arrays are listed"
            for name in sorted(written_names(header.with_suffix(".cxx")) - set(listed)):
                yield f"{header.name}: {name} is written but not listed"


WRITES = re.compile(
    r"\b(?:setDatum|setIds|addPointArray|addCellArray|addCellFlags|addFlags|addColumn|count|SetName)(?:<\w+>)?"
    r'\(\s*(?:[\w>()-]+,\s*)?"([A-Z]\w+)"'
)


def written_names(source):
    """The names of arrays that stand as literals in a source file where arrays are written."""
    return set(WRITES.findall(source.read_text(encoding="utf-8")))


def main():
    repository = Path(__file__).resolve().parents[2]
    (repository / "docs/reference.md").write_text(reference(repository), encoding="utf-8")
    print("\n".join(undocumented(repository)))


if __name__ == "__main__":
    main()
