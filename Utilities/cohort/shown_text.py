# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts as tables and standard output can take them."""

import sys
import unicodedata


def without_controls(text):
    """The text with its control characters written out, but for ends of lines and tabs: messages of readers quote
    damaged files, and pvbatch's standard output takes no null character."""
    return "".join(
        letter.encode("unicode_escape").decode("ascii")
        if unicodedata.category(letter) == "Cc" and letter not in "\n\t"
        else letter
        for letter in text
    )


def printable(text):
    """The text as standard output can take it: names of files need not be text in its encoding, nor in any."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"  # pvbatch's standard output tells none
    return without_controls(text).encode(encoding, "backslashreplace").decode(encoding)
