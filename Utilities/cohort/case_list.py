# SPDX-License-Identifier: GPL-3.0-or-later
"""The cases of a cohort: their names and their order."""

import hashlib
import os
from dataclasses import dataclass

from case_files import voxel_files

# Bytes of the name of a case: file systems take 255, and the longest ending, .interrupted, has 12.
LONGEST_NAME = 200
HASH_DIGITS = 16


class CaseNameError(Exception):
    """Why the files of a cohort have no names of their own, in a sentence for the user."""


@dataclass(frozen=True)
class Case:
    """One surface or volume; its name is that of its result."""

    name: str
    path: str

    def size(self):
        """Bytes of the file and of those with its voxels, which the time grows with; 0 if there is no such file."""
        return sum(os.path.getsize(path) for path in self._files() if os.path.isfile(path))

    def identity(self):
        """Tells whether the file, and those with its voxels, are still the ones that a result was made of."""
        if not os.path.isfile(self.path):
            return "missing"
        own, *others = (_identity(path) for path in self._files())
        if not others:
            return own
        # A hash stands for all of them, as a volume may have a file for each slice. It is one of bytes, as names need
        # not be UTF-8.
        return f"{own} {hashlib.sha256(os.fsencode(' '.join(others))).hexdigest()}"

    def _files(self):
        return [self.path, *voxel_files(self.path)]


def _identity(path):
    try:
        status = os.stat(path)
    except OSError:
        return f"{os.path.abspath(path)} missing"
    return f"{os.path.abspath(path)} {status.st_size} {status.st_mtime_ns}"


def stem(path):
    """The file's name without .vtk, .nii.gz and the like."""
    name = os.path.basename(os.path.normpath(path))
    if name.endswith(".gz"):
        name = name[: -len(".gz")]
    return os.path.splitext(name)[0]


def shortened(name):
    """The name, or if that is too long for a file its beginning and a hash of it all: the same in each run."""
    if len(os.fsencode(name)) <= LONGEST_NAME:
        return name
    beginning = name
    while len(os.fsencode(beginning)) > LONGEST_NAME - HASH_DIGITS - 1:
        beginning = beginning[:-1]
    return f"{beginning}-{hashlib.sha256(os.fsencode(name)).hexdigest()[:HASH_DIGITS]}"


def named_cases(paths):
    """A case per file, named by its stem; files of one stem get the names of their folders before it.

    Raises CaseNameError if two files would still have one name.
    """
    paths = list(dict.fromkeys(os.path.abspath(path) for path in paths))
    stems = [stem(path) for path in paths]
    if len(set(stems)) < len(stems):
        common = os.path.commonpath([os.path.dirname(path) for path in paths])
        stems = [
            "__".join(os.path.relpath(path, common).split(os.sep)[:-1] + [stem(path)]) for path in paths
        ]
    if len(set(stems)) < len(stems):
        twice = sorted({name for name in stems if stems.count(name) > 1})
        raise CaseNameError(f"two files would both be the case {twice[0]}: rename one of them")
    return [Case(shortened(name), path) for name, path in zip(stems, paths)]


def in_order(cases, interruptions=lambda case: 0):
    """The largest first, so that no rank is left alone with a large one at the end.

    A case during which a run was killed comes after those during which fewer were, in case it is what ends them:
    then each run gets through at least one case that no run has tried as often.
    """
    return sorted(cases, key=lambda case: (interruptions(case), -case.size(), case.name))
