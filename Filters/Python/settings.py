# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a VTK filter as keyword arguments: their names, their defaults, and what they mean, as its class has
them."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
import textwrap
from typing import Any, Dict, Type

from vtkmodules.vtkCommonDataModel import vtkDataObject

from .meshes import as_polydata

# Settings that name an array: the input array to process, and the setting that turns its use on.
ARRAYS = {
    "RegionOfInterest": (0, "UseRegionOfInterest"),
    "AreaWeightArray": (0, "UseAreaWeight"),
    "RegionArray": (0, "UseRegionArray"),
    "LabelArray": (None, None),  # see array_index()
}
# Settings that are lists, with the method that adds an element.
LISTS = {"SeamPoints": "AddSeamPoint", "SeamPathStarts": "AddSeamPathStart"}
# Settings that are a second input.
INPUTS = {"SeamLines": "SetSeamLinesData", "Domain": "SetDomainData", "Selection": "SetSelectionData"}
ADDED_TEXT = {
    "RegionOfInterest": "Name of the array that is not 0 where the surface is not to be cut.",
    "AreaWeightArray": "Name of the point array of the weights.",
    "RegionArray": "Name of the array of the regions.",
    "LabelArray": "Name of the array of the labels.",
    "SeamPoints": "Points that the seam goes through, in order.",
    "SeamPathStarts": "Numbers of the seam points with which a further path begins.",
    "SeamLines": "Lines along which the surface is cut: a second mesh.",
    "Domain": "Polygon to map to: a second mesh.",
    "Selection": "The selected part: a second mesh.",
}


def array_index(filter_class: Type, setting: str) -> int:
    """The input array to process of a setting; Surface To Disk has the labels of its cut second."""
    if setting == "LabelArray":
        return 1 if hasattr(filter_class, "SetCutMode") else 0
    return ARRAYS[setting][0]


@functools.lru_cache(maxsize=None)
def defaults_of(filter_class: Type) -> Dict[str, Any]:
    """The settings of a filter class by name, in the order of the alphabet, with their defaults."""
    filter = filter_class()
    names = {}
    inherited = set(dir(filter_class.__mro__[1]))
    for method in dir(filter_class):
        name = method[3:]
        if method.startswith("Set") and hasattr(filter, "Get" + name) and method not in inherited:
            if not name.endswith(("Connection", "Data")) and "NumberOf" not in name:
                try:
                    names[name] = getattr(filter, "Get" + name)()
                except TypeError:  # of one element of a list
                    continue
    for name, (_, switch) in ARRAYS.items():
        has_labels = name == "LabelArray" and (hasattr(filter, "SetCutLabel") or hasattr(filter, "SetLabel"))
        if has_labels or (switch and hasattr(filter, "Set" + switch)):
            names[name] = None
    names.update({name: () for name, method in LISTS.items() if hasattr(filter, method)})
    names.update({name: None for name, method in INPUTS.items() if hasattr(filter, method)} if names else {})
    if hasattr(filter, "SetRegionFrom") and hasattr(filter, "SetSelectionConnection"):
        names["Selection"] = None
    return dict(sorted(names.items()))


def snake_case(name: str) -> str:
    """CutMode as cut_mode."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def setting_named(filter_class: Type, keyword: str) -> str | None:
    """The setting that a keyword means, cut_mode or CutMode; None if the class has none."""
    plain = keyword.replace("_", "").lower()
    return next((name for name in defaults_of(filter_class) if name.lower() == plain), None)


def shared_settings(classes: tuple) -> set:
    """The settings that several of the classes have and that may differ. Maps that follow each other are normalised
    alike."""
    names = [name for c in classes for name in defaults_of(c)]
    return {name for name in names if names.count(name) > 1} - {"NormalizeTo"}


def unknown_setting(function: str, keyword: str, classes: tuple) -> TypeError:
    """The error for a keyword that is no setting."""
    known = sorted({snake_case(name) for c in classes for name in defaults_of(c)})
    close = difflib.get_close_matches(snake_case(keyword), known, 1, 0.5)
    hint = f"did you mean {close[0]}?" if close else f"it has {', '.join(known)}"
    return TypeError(f"{function}() has no setting {keyword}: {hint}")


def apply(filter: Any, surface: Any, name: str, value: Any) -> None:
    """Sets one setting of a filter whose input is the surface."""
    if name in LISTS and hasattr(filter, LISTS[name]):
        for element in value:
            getattr(filter, LISTS[name])(*(element if hasattr(element, "__len__") else (element,)))
    elif name in INPUTS and value is None:
        return
    elif name in INPUTS and hasattr(value, "IsA"):
        if name == "Selection":
            filter.SetInputDataObject(1, value)
        else:
            getattr(filter, INPUTS[name])(as_polydata(value))
    elif name in ARRAYS:
        if value is not None:
            filter.SetInputArrayToProcess(array_index(type(filter), name), 0, 0, _association(surface, value), value)
            if ARRAYS[name][1]:
                getattr(filter, "Set" + ARRAYS[name][1])(True)
    elif isinstance(value, str):
        _apply_text(filter, name, value)
    elif isinstance(value, (tuple, list)) or hasattr(value, "tolist") and getattr(value, "ndim", 0):
        getattr(filter, "Set" + name)(*(float(v) for v in value))
    else:
        getattr(filter, "Set" + name)(value.item() if hasattr(value, "item") else value)


def _apply_text(filter: Any, name: str, value: str) -> None:
    plain = re.sub(r"[ _-]", "", value).lower()
    choices = {}
    for method in dir(filter):
        start = f"Set{name}To" if method.startswith(f"Set{name}To") else f"Set{name}"
        if method.startswith(start) and len(method) > len(start):
            choices[method[len(start) :].lower()] = method
    if plain in choices:
        getattr(filter, choices[plain])()
    elif isinstance(getattr(filter, "Get" + name)(), str) or not choices:
        getattr(filter, "Set" + name)(value)
    else:
        words = sorted(re.sub(f"^Set{name}(To)?", "", method) for method in choices.values())
        raise ValueError(f"{snake_case(name)} is {value!r}: it must be one of {', '.join(words)}")


def _association(surface: Any, array: str) -> int:
    for data, association in (
        (surface.GetPointData(), vtkDataObject.FIELD_ASSOCIATION_POINTS),
        (surface.GetCellData(), vtkDataObject.FIELD_ASSOCIATION_CELLS),
    ):
        if data.HasArray(array):
            return association
    data = (surface.GetPointData(), surface.GetCellData())
    names = [str(d.GetArrayName(i)) for d in data for i in range(d.GetNumberOfArrays())]
    raise ValueError(f"the surface has no array {array}: it has {', '.join(names) or 'none'}")


def documented(*classes: Type) -> Any:
    """A decorator that adds the settings of filter classes to the signature and to the help of a function."""

    def decorate(function: Any) -> Any:
        given = inspect.signature(function)
        fixed = [p for p in given.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        names = {n: d for c in classes for n, d in defaults_of(c).items() if n not in shared_settings(classes)}
        settings = [
            inspect.Parameter(snake_case(n), inspect.Parameter.KEYWORD_ONLY, default=d) for n, d in sorted(names.items())
        ]
        function.__signature__ = given.replace(parameters=[*fixed, *settings])
        lines = [inspect.cleandoc(function.__doc__)]
        for c in classes:
            lines.append(f"\nSettings of {c.__name__}, all by keyword:\n")
            for name in defaults_of(c):
                text = textwrap.fill(f"{snake_case(name)}: {_meaning(c, name)}", 100, subsequent_indent="    ")
                lines.append(textwrap.indent(text, "  "))
        function.__doc__ = "\n".join(lines)
        return function

    return decorate


def _meaning(filter_class: Type, name: str) -> str:
    if name in ADDED_TEXT and not (name == "Domain" and hasattr(filter_class, "SetDomain")):
        return ADDED_TEXT[name]
    text = getattr(filter_class, "Set" + name).__doc__ or ""
    paragraphs = [p for p in text.split("\n\n") if not re.match(r"\s*(Set|V\.|C\+\+)", p)]
    return re.sub(r"\s+", " ", re.sub(r"C\+\+: .*", "", " ".join(paragraphs))).strip()
