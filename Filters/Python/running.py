# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a VTK filter such that its errors are exceptions."""

from __future__ import annotations

import re
import sys
import warnings
from typing import Any, Callable, List, Optional

from .errors import Cancelled, FlatteningError, FlatteningWarning

Progress = Optional[Callable[[float, str], Any]]
Abort = Optional[Callable[[], bool]]

# What VTK writes before a message: the line of the source, and the address of the object.
_PREFIX = re.compile(r"^\s*(?:ERROR|Warning)[^\n]*\n[^\n]*?\(0x[0-9a-f]+\):\s*", re.IGNORECASE)


def run(filter: Any, progress: Progress = None, abort: Abort = None) -> Any:
    """Updates the filter and returns its output; its warnings are issued once it has ended.

    progress: is called with the share of the work that is done, from 0 to 1, and with what is being done.
    abort: is called as often; the filter stops if it returns True, and Cancelled is raised.
    Raises FlatteningError with the filter's message if it failed. An exception in a callback stops the filter and is
    raised from here.
    """
    errors: List[str] = []
    said: List[str] = []
    raised: List[BaseException] = []

    def on_error(_object: Any, _event: str, text: str) -> None:
        errors.append(_message(text))

    def on_warning(_object: Any, _event: str, text: str) -> None:
        said.append(_message(text))

    def on_progress(_object: Any, _event: str) -> None:
        try:
            if progress:
                progress(filter.GetProgress(), filter.GetProgressText() or "")
            if abort and abort():
                raise Cancelled(f"{filter.GetClassName()} was stopped by the callback abort")
        except BaseException as exception:  # VTK would print it and go on
            raised.append(exception)
            filter.SetAbortExecute(True)

    on_error.CallDataType = on_warning.CallDataType = "string0"
    filter.AddObserver("ErrorEvent", on_error)
    filter.AddObserver("WarningEvent", on_warning)
    filter.GetExecutive().AddObserver("ErrorEvent", on_error)
    if progress or abort:
        filter.AddObserver("ProgressEvent", on_progress)
    filter.Update()
    try:
        _warn(said)
    finally:  # an error goes before a warning that is turned into one
        if raised:
            raise raised[0]
        if errors:
            raise FlatteningError("\n".join(errors))
    return filter.GetOutput()


def _message(text: Optional[str]) -> str:
    if text is None:  # VTK's wrappers cannot decode it
        return "the filter's message quotes a name that is not UTF-8: give the arrays other names"
    return _PREFIX.sub("", text).strip()


def _warn(texts: List[str]) -> None:
    """Issues warnings for the line that called this package."""
    frame, level = sys._getframe(), 1
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    for text in texts:
        warnings.warn(text, FlatteningWarning, stacklevel=level)
