# SPDX-License-Identifier: GPL-3.0-or-later
"""help() of every class says what it does and when it fails, and of every setter what it sets."""

import re

import surfaceflattening

classes = {name: getattr(surfaceflattening, name) for name in dir(surfaceflattening) if name.startswith("vtk")}
filters = {name: kind for name, kind in classes.items() if name != "vtkBlockwisePolyDataAlgorithm"}
assert len(filters) == 15, sorted(filters)


def text_of(method):
    """The documentation without the signatures."""
    paragraphs = re.split(r"\n\s*\n", method.__doc__ or "")
    return " ".join(" ".join(paragraphs[1:]).split())


missing = []
for name, kind in filters.items():
    text = kind.__doc__
    # VTK takes what is in angle brackets out of the documentation: nothing may depend on it.
    if "``" in text or text.count("`") % 2:
        missing.append(f"{name}: something between angle brackets is lost")
    if not re.search(r"\b[Ee]rrors?, each with", " ".join(text.split())):
        missing.append(f"{name}: no errors")
    if not re.search(r"empty (output|image)", text):
        missing.append(f"{name}: nothing about empty inputs")
    for setter, method in vars(kind).items():
        if not setter.startswith("Set") or re.search(r"To[A-Z]\w*$|Data$|From[A-Z]\w+$", setter):
            continue  # a value of an enumeration, or a data object in place of a connection
        if len(text_of(method)) < 25:
            missing.append(f"{name}::{setter}: {text_of(method)!r}")
assert not missing, "\n".join(missing)
