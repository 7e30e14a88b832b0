# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens surfaces to a planar domain with every area kept: the VTK filters of SurfaceFlattening.

    from surfaceflattening import vtkDistortionMetrics
"""

from .SurfaceFlatteningFilters import *  # noqa: F401,F403
