# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of ParaView's help are in the plugin: one per filter, none with a dead reference.

TestHelp.py SurfaceFlattening.qch SurfaceFlattening.so
"""

import base64
import re
import sqlite3
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

collection, plugin = map(Path, sys.argv[1:])

with sqlite3.connect(collection) as connection:
    files = {
        name: zlib.decompress(data[4:])  # after its size, as Qt compresses
        for name, data in connection.execute(
            "SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON FileId = Id WHERE Name <> ''"
        )
    }
pages = {name: data.decode("utf-8") for name, data in files.items() if name.endswith(".html")}

# Their panels have little to see.
WITHOUT_PICTURE = (
    "AnatomicalScanReader",
    "CortexReader",
    "DICOMFolderReader",
    "ImageCast",
    "ImagePad",
    "NIFTIImageReader",
    "PatientSpace",
    "RegionTable",
    "ScanInPatientSpace",
)

# ParaView looks a filter's page up as <group>.<name>.html.
filters = {
    f"{group.get('name')}.{proxy.get('name')}.html": proxy
    for path in (Path(__file__).resolve().parents[2] / "Plugin").glob("*.xml")
    for group in ElementTree.parse(path).getroot().iter("ProxyGroup")
    for proxy in group.iter("SourceProxy")
    if group.get("name") != "internal_filters"  # what the window uses alone
}
assert len(filters) > 10, filters
for name, proxy in filters.items():
    text = pages[name]
    assert f"<title>{proxy.get('label')}</title>" in text, name
    documented = [p for p in proxy if p.tag.endswith("Property") and p.find("Documentation") is not None]
    assert text.count("<tr>") == len(documented) + 1, (name, text.count("<tr>"), len(documented))
    assert "<img" in text or proxy.get("name") in WITHOUT_PICTURE, name

# No picture is cut off at the window's edge.
pictures = {name: data for name, data in files.items() if name.endswith(".png")}
assert len(pictures) > 10, list(pictures)
for name, data in pictures.items():
    assert 100 < int.from_bytes(data[16:20], "big") <= 660, name  # a PNG file's width

references = 0
for name, text in pages.items():
    assert "](" not in re.sub(r"<code.*?</code>", "", text, flags=re.S), f"{name}: a link was not converted"
    for target in re.findall(r'(?:href|src)="([^"]*)"', text):
        if "://" in target:
            continue
        references += 1
        page, _, section = target.partition("#")
        assert not page or page in files, f"{name}: {target}"
        assert not section or f'id="{section}"' in pages[page or name], f"{name}: {target}"
assert references > 60, references

# The plugin has the file in base 64.
begin = base64.b64encode(collection.read_bytes()[:3000])
assert begin in plugin.read_bytes(), "the plugin does not have these pages"
