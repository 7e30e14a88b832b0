# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors that tests of the package expect."""


def raised(kind, function, *arguments, **settings):
    """The message of the error of exactly this kind that a call raises."""
    try:
        function(*arguments, **settings)
    except kind as error:
        assert type(error) is kind, repr(error)
        return str(error)
    raise AssertionError(f"no {kind.__name__} from {function.__name__} with {settings}")
