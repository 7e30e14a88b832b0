# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions of this package raise."""


class FlatteningError(RuntimeError):
    """A filter could not do what it was asked for; the text is the filter's message, which says what to do."""


class SettingError(FlatteningError, ValueError):
    """A setting cannot have the value that it was given; the text names the setting, the value and what it may be."""


class Cancelled(Exception):
    """The callback `abort` has asked for an end."""


class FlatteningWarning(UserWarning):
    """A filter has a result, and something to say about it."""
