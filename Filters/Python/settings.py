# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a VTK filter as keyword arguments: their names, their defaults, and what they mean, as its class has
them."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
import textwrap
from typing import Any, Dict, NamedTuple, Optional, Tuple, Type

from vtkmodules.vtkCommonDataModel import vtkDataObject

from .errors import SettingError
from .meshes import as_polydata

# Settings that name an array: the input array to process.
ARRAYS = {"RegionOfInterest": 0, "AreaWeightArray": 0, "RegionArray": 0, "LabelArray": None}  # see array_index()
# Settings that are lists, with the method that adds an element.
LISTS = {"SeamPoints": "AddSeamPoint", "SeamPathStarts": "AddSeamPathStart"}
# Settings that are a second input.
INPUTS = {"SeamLines": "SetSeamLinesData", "Domain": "SetDomainData", "Selection": "SetSelectionData"}
# Settings that a filter uses only while a switch is on (True) or off (False): giving one sets the switch.
SWITCHES = {
    "RegionOfInterest": ("UseRegionOfInterest", True),
    "AreaWeightArray": ("UseAreaWeight", True),
    "RegionArray": ("UseRegionArray", True),
    "HolePoint": ("UseHolePoint", True),
    "SeamPoints": ("UseSeamPoints", True),
    "SeamPathStarts": ("UseSeamPoints", True),
    "CenterPoint": ("UseCenterPoint", True),
    "BoundaryPoint": ("UseBoundaryPoint", True),
    "LowerLeftCorner": ("UseCorners", True),
    "LowerRightCorner": ("UseCorners", True),
    "UpperRightCorner": ("UseCorners", True),
    "UpperLeftCorner": ("UseCorners", True),
    "Margin": ("AutomaticMargin", False),
}
# Settings that a filter uses only in some modes: the mode, and its values in words. Giving one sets the mode to the
# first word, unless the mode already has one of them.
MODES = {
    "ComponentPoint": {"ComponentMode": ("ClosestToPoint",)},
    "ComponentIndex": {"ComponentMode": ("ByIndex",)},
    "BoundaryPoint": {"BoundaryMode": ("ClosestToPoint",), "Domain": ("Disk",)},
    "HolePoint": {"CutMode": ("Hole", "Automatic")},
    "SeamPoints": {"CutMode": ("Seam", "Automatic")},
    "SeamPathStarts": {"CutMode": ("Seam", "Automatic")},
    "SeamLines": {"CutMode": ("Seam", "Automatic")},
    "PlaneOrigin": {"CutMode": ("Plane",)},
    "PlaneNormal": {"CutMode": ("Plane",)},
    "CutLabel": {"CutMode": ("Label",)},
    "CenterPoint": {"Domain": ("Disk",)},
    "LowerLeftCorner": {"Domain": ("Rectangle",)},
    "LowerRightCorner": {"Domain": ("Rectangle",)},
    "UpperRightCorner": {"Domain": ("Rectangle",)},
    "UpperLeftCorner": {"Domain": ("Rectangle",)},
    "LabelArray": {"CutMode": ("Label",), "RegionFrom": ("Label",)},
    "Label": {"RegionFrom": ("Label",)},
    "Selection": {"RegionFrom": ("Selection",)},
}
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
    return ARRAYS[setting]


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
    for name in ARRAYS:
        has_labels = name == "LabelArray" and (hasattr(filter, "SetCutLabel") or hasattr(filter, "SetLabel"))
        if has_labels or (name in SWITCHES and hasattr(filter, "Set" + SWITCHES[name][0])):
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


def apply_all(filter: Any, surface: Any, settings: Dict[str, Any]) -> None:
    """Sets the settings of a filter whose input is the surface, and the switches and modes by which it uses them.

    A switch or mode that is among the settings stays as it is given. If the filter then leaves a setting unused, that
    is meant where a switch says so, and an error where a mode does.
    """
    for name, value in settings.items():
        apply(filter, surface, name, value)
    used = [name for name, value in settings.items() if _is_given(value)]
    for name in list(used):
        switch, position = SWITCHES.get(name, (None, None))
        if switch in settings:
            if getattr(filter, "Get" + switch)() != position:
                used.remove(name)
        elif switch and hasattr(filter, "Set" + switch):
            getattr(filter, "Set" + switch)(position)
    if "SeamLines" in used and "SeamPoints" in used:
        raise SettingError("seam_lines and seam_points are both given, and the seam is one of them: leave the other out")
    for mode in sorted({mode for name in used for mode in MODES.get(name, {})}):
        if choices_of(type(filter), mode):
            _set_mode(filter, mode, settings, [name for name in used if mode in MODES.get(name, {})])


def _set_mode(filter: Any, mode: str, settings: Dict[str, Any], names: list) -> None:
    """Sets a mode such that the filter uses the settings of these names."""
    choices = choices_of(type(filter), mode)
    present = next(word for word, number in choices.items() if number == getattr(filter, "Get" + mode)())
    if mode in settings:
        defaults = defaults_of(type(filter))
        unused = [name for name in names if present not in MODES[name][mode]]
        for name in unused:
            if not _equal(settings[name], defaults[name]):
                raise SettingError(
                    f"{snake_case(name)} is given, and {snake_case(mode)} is {present}, which does not use it: leave it "
                    f"out, or set {snake_case(mode)} to {' or '.join(MODES[name][mode])}"
                )
        names = [name for name in names if name not in unused]
    needed = {MODES[name][mode][0]: name for name in names}
    if len(needed) > 1:
        (one, first), (other, second) = list(needed.items())[:2]
        raise SettingError(
            f"{snake_case(first)} and {snake_case(second)} are both given, and {snake_case(mode)} can be {one} or "
            f"{other}: leave one of them out"
        )
    if names and present not in MODES[names[0]][mode]:
        getattr(filter, "Set" + mode)(choices[next(iter(needed))])


def _plain(value: Any) -> Any:
    """An array of NumPy as list, or its number; all else as it is."""
    return value.tolist() if hasattr(value, "tolist") else value


def _is_given(value: Any) -> bool:
    """Whether a value is one, as neither None nor an empty list is."""
    return value is not None and _plain(value) not in ((), [], "")


def _equal(value: Any, other: Any) -> bool:
    """Whether two values of a setting are the same, not-a-numbers included."""
    values, others = (tuple(v) if isinstance(v, (tuple, list)) else (v,) for v in (_plain(value), other))
    return len(values) == len(others) and all(a == b or (a != a and b != b) for a, b in zip(values, others))


@functools.lru_cache(maxsize=None)
def choices_of(filter_class: Type, mode: str) -> Dict[str, int]:
    """The values of a mode by the words that its setters have; none if it is no mode."""
    filter = filter_class()
    start = f"Set{mode}" if mode.endswith("From") else f"Set{mode}To"  # SetRegionFromLabel, SetCutModeToHole
    numbers = {}
    for method in dir(filter):
        if method.startswith(start) and method != start:
            getattr(filter, method)()
            numbers[method[len(start) :]] = getattr(filter, "Get" + mode)()
    return numbers


def apply(filter: Any, surface: Any, name: str, value: Any) -> None:
    """Sets one setting of a filter whose input is the surface, and nothing else."""
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
    elif isinstance(value, str):
        _apply_text(filter, name, value)
    else:
        set_number(filter, name, value)


def set_number(filter: Any, name: str, value: Any, keyword: Optional[str] = None) -> None:
    """Sets a number, or several as a sequence. Raises SettingError for one that the filter would change or refuse."""
    keyword = keyword or snake_case(name)
    value = _plain(value)
    if isinstance(value, (tuple, list)):
        given = tuple(float(v) for v in value)
    else:
        given = (value,)
        allowed = range_of(type(filter), name)
        whole = type(getattr(filter, "Get" + name)()) is int
        if isinstance(value, float) and whole:
            if not value.is_integer():
                raise SettingError(f"{keyword} is {value}: it must be a whole number")
            given = (int(value),)
        if allowed and isinstance(value, (int, float)) and not allowed.has(value):
            words = ", ".join(choices_of(type(filter), name))
            also = f", or one of {words}" if words else ""
            raise SettingError(f"{keyword} is {value}: it must be {allowed}{also}")
    try:
        getattr(filter, "Set" + name)(*given)
    except OverflowError as error:
        raise SettingError(f"{keyword} is {value}: {error}") from error
    except TypeError as error:
        raise TypeError(f"{keyword} is {value!r}: {error}") from error
    result = getattr(filter, "Get" + name)()
    if not _equal(given if isinstance(result, tuple) else given[0], result):
        must = "it must be True or False" if isinstance(result, bool) else f"it was changed to {result}"
        raise SettingError(f"{keyword} is {value!r}: {must}")


class Range(NamedTuple):
    """The numbers that a setting may be."""

    least: float
    most: float
    with_least: bool
    with_most: bool

    def has(self, value: float) -> bool:
        above = value >= self.least if self.with_least else value > self.least
        return above and (value <= self.most if self.with_most else value < self.most)

    def __str__(self) -> str:
        least, most = f"{self.least:g}", f"{self.most:g}"
        if self.most == float("inf"):
            return f"{least} or more" if self.with_least else f"above {least}"
        if self.with_least and self.with_most:
            return f"from {least} to {most}"
        return f"{'from' if self.with_least else 'above'} {least} {'to' if self.with_most else 'and below'} {most}"


@functools.lru_cache(maxsize=None)
def range_of(filter_class: Type, name: str) -> Optional[Range]:
    """The range of a setting, as the filter has it or its documentation says; None if neither does."""
    filter = filter_class()
    if hasattr(filter, f"Get{name}MinValue"):
        return Range(getattr(filter, f"Get{name}MinValue")(), getattr(filter, f"Get{name}MaxValue")(), True, True)
    found = re.search(r"\bRange\s+([\[(])([-\w.+]+),\s+([-\w.+]+)([\])])", getattr(filter, "Set" + name).__doc__ or "")
    return found and Range(float(found.group(2)), float(found.group(3)), found.group(1) == "[", found.group(4) == "]")


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
        set_number(filter, name, value)
    else:
        words = sorted(re.sub(f"^Set{name}(To)?", "", method) for method in choices.values())
        raise SettingError(f"{snake_case(name)} is {value!r}: it must be one of {', '.join(words)}")


def _association(surface: Any, array: str) -> int:
    for data, association in (
        (surface.GetPointData(), vtkDataObject.FIELD_ASSOCIATION_POINTS),
        (surface.GetCellData(), vtkDataObject.FIELD_ASSOCIATION_CELLS),
    ):
        if data.HasArray(array):
            return association
    data = (surface.GetPointData(), surface.GetCellData())
    names = [str(d.GetArrayName(i)) for d in data for i in range(d.GetNumberOfArrays())]
    raise SettingError(f"the surface has no array {array}: it has {', '.join(names) or 'none'}")


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
        return " ".join((ADDED_TEXT[name], *_consequences(filter_class, name)))
    text = getattr(filter_class, "Set" + name).__doc__ or ""
    paragraphs = [p for p in text.split("\n\n") if not re.match(r"\s*(Set|V\.|C\+\+)", p)]
    meaning = re.sub(r"\s+", " ", re.sub(r"C\+\+: .*", "", " ".join(paragraphs))).strip()
    return " ".join((meaning, *_consequences(filter_class, name)))


def _consequences(filter_class: Type, name: str) -> Tuple[str, ...]:
    """What apply_all() sets for a setting that is given, in sentences."""
    defaults = defaults_of(filter_class)
    said = []
    switch, position = SWITCHES.get(name, (None, None))
    if switch in defaults:
        said.append(f"If it is given, {snake_case(switch)} is {position}.")
    for mode, words in MODES.get(name, {}).items():
        choices = choices_of(filter_class, mode)
        if choices and defaults[mode] not in [choices[word] for word in words]:
            said.append(f"If it is given, {snake_case(mode)} is {words[0]}.")
    return tuple(said)
