# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a VTK filter such that its errors are exceptions."""

from __future__ import annotations

import re
import warnings
from typing import Any, Callable, List, Optional

from .errors import Cancelled, FlatteningError, FlatteningWarning

Progress = Optional[Callable[[float, str], Any]]
Abort = Optional[Callable[[], bool]]

# What VTK writes before a message: the line of the source, and the address of the object.
_PREFIX = re.compile(r"^\s*(?:ERROR|Warning)[^\n]*\n[^\n]*?\(0x[0-9a-f]+\):\s*", re.IGNORECASE)


def run(filter: Any, progress: Progress = None, abort: Abort = None) -> Any:
    """Updates the filter and returns its output.

    progress: is called with the share of the work that is done, from 0 to 1, and with what is being done.
    abort: is called as often; the filter stops if it returns True, and Cancelled is raised.
    Raises FlatteningError with the filter's message if it failed. An exception in a callback stops the filter and is
    raised from here.
    """
    errors: List[str] = []
    raised: List[BaseException] = []

    def on_error(_object: Any, _event: str, text: str) -> None:
        errors.append(_PREFIX.sub("", text).strip())

    def on_warning(_object: Any, _event: str, text: str) -> None:
        warnings.warn(_PREFIX.sub("", text).strip(), FlatteningWarning, stacklevel=5)

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
    if raised:
        raise raised[0]
    if errors:
        raise FlatteningError("\n".join(errors))
    return filter.GetOutput()
