# SPDX-License-Identifier: GPL-3.0-or-later
"""mesh.flatten() for PyVista. PyVista 0.48 and newer finds this module by its entry point pyvista.accessors; before that,
`import surfaceflattening.accessors` does the same."""

import pyvista

from .functions import flatten


class Flatten:
    """mesh.flatten(...) is surfaceflattening.flatten(mesh, ...)."""

    def __init__(self, mesh):
        self._mesh = mesh

    def __call__(self, **settings):
        return flatten(self._mesh, **settings)


Flatten.__call__.__doc__ = flatten.__doc__

if hasattr(pyvista, "register_dataset_accessor"):
    pyvista.register_dataset_accessor("flatten", pyvista.PolyData)(Flatten)
else:
    pyvista.PolyData.flatten = property(Flatten)
