# SPDX-License-Identifier: GPL-3.0-or-later
"""The names of filters and parameters in docs/reference.md are those of paraview.simple."""

import re
import sys
from pathlib import Path

from paraview import servermanager, simple

root = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "Utilities/docs"))

import reference

page = (root / "docs/reference.md").read_text(encoding="utf-8")
sections = dict(re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", page, re.MULTILINE | re.DOTALL))
manager = servermanager.vtkSMProxyManager.GetProxyManager().GetActiveSessionProxyManager()
compared = 0
other = {}
for described in reference.proxies(root):
    text = " ".join(sections[described.get("label")].split())
    kind = re.match(r"`(\w+)` in scripts", text).group(1)
    assert hasattr(simple, kind), kind
    group, names = next(
        (group, attributes)
        for group, attributes in (("filters", servermanager.filters), ("sources", servermanager.sources))
        if hasattr(attributes, kind)
    )
    attributes = vars(getattr(names, kind))
    prototype = manager.GetPrototypeProxy(group, described.get("name"))
    for setting in reference.settings_of(described):
        label, name = reference.label_of(setting), setting.get("name")
        listed = re.search(rf"- \*\*{re.escape(label)}\*\* \(`(\w+)`(?: in pvpython, `(\w+)` elsewhere)?[;)]", text)
        assert listed, (kind, name)
        in_pvpython, elsewhere = listed.group(1), listed.group(2) or listed.group(1)
        assert in_pvpython in attributes, (kind, in_pvpython, sorted(attributes))
        assert elsewhere == name and prototype.GetProperty(name), (kind, elsewhere, name)
        if elsewhere != in_pvpython:
            assert elsewhere not in attributes, (kind, elsewhere)
            other[kind, in_pvpython] = elsewhere
        compared += 1
assert compared > 130, compared
assert other["SurfaceToDisk", "Cut"] == "CutMode", other
