# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that get their names once they are complete, so that a full disk does not take the earlier ones.

    from surfaceflattening_whole_file import whole_file

    with whole_file("flat.csv") as part, open(part, "w") as stream:
        stream.write("...")
"""

import contextlib
import os
import tempfile


class WriteError(OSError):
    """That a file could not be written, in a sentence for the user. @reason: that of the system alone."""

    def __init__(self, path, reason):
        super().__init__(f"{path} cannot be written ({reason}): choose another folder or name, or make room")
        self.reason = reason


def reason_of(error):
    """What the system says of an OSError."""
    return getattr(error, "reason", None) or error.strerror or str(error)


@contextlib.contextmanager
def whole_file(path):
    """A path to write to: of the same name, in a new folder beside the file. All files that are in that folder at the
    end take the places of earlier ones beside @path. Raises WriteError, also if a writer that says nothing wrote nothing.
    """
    folder, name = os.path.split(os.path.realpath(path))
    try:
        with tempfile.TemporaryDirectory(prefix=".part-", dir=folder) as new:
            part = os.path.join(new, name)
            yield part
            if not os.path.isfile(part):
                open(part, "xb").close()  # the system says why, such as a name that is too long
                raise WriteError(path, "its writer wrote nothing")
            _move_files(new, folder)
    except WriteError:
        raise
    except OSError as error:
        raise WriteError(path, reason_of(error)) from None


def _move_files(old, new):
    for folder, _folders, names in os.walk(old):
        place = os.path.join(new, os.path.relpath(folder, old))
        os.makedirs(place, exist_ok=True)
        for name in names:
            os.replace(os.path.join(folder, name), os.path.join(place, name))
