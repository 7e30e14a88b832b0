# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the plugin for the source that is selected in the pipeline browser.

    import surfaceflattening_commands
    surfaceflattening_commands.run("flatten_and_compare")

The menu Filters > Surface Flattening and the macros call run(): an error is a message in the output window, without
a traceback.
"""

# First, for it lets Python find the modules of plugins.
from paraview import simple  # isort: skip

from surfaceflattening_present import FilterFailed
from vtkmodules.vtkCommonCore import vtkOutputWindow


def run(name, file=""):
    """Runs the command for the active source, with the @file that it writes if it writes one. Errors that the user can do
    something about become a message."""
    try:
        COMMANDS[name](simple.GetActiveSource(), *([file] if file else []))
    except FilterFailed:
        pass  # the filter has said why
    except (ValueError, RuntimeError, OSError) as error:
        vtkOutputWindow.GetInstance().DisplayErrorText(str(error))


def _flatten_and_compare(_source):
    from surfaceflattening_layout import flatten_and_compare

    flatten_and_compare()  # which knows when several sources are selected


def _edit_cuts(source):
    from surfaceflattening_cuts import edit_cuts

    edit_cuts(source)


def _fill_region_factors(source):
    from surfaceflattening_regions import fill_region_factors

    fill_region_factors(source)


def _flatten_cortex(source):
    from surfaceflattening_cortex import flatten_cortex_and_show

    flatten_cortex_and_show(source)


def _patient_axes(source):
    from surfaceflattening_axes import patient_axes

    patient_axes(source)


def _save_flat_map(source, file):
    from surfaceflattening_files import save_flat_map

    save_flat_map(source, file)


def _scan_slices(source):
    from surfaceflattening_scan_slices import show_scan_slices

    show_scan_slices(source)


def _show_seams(source):
    from surfaceflattening_seams import show_seams

    show_seams(source)


def _switch_colours(_source):
    from surfaceflattening_colours import switch_colours

    switch_colours()


def _do_again(_source):
    from surfaceflattening_layout import do_again

    do_again()


def _take_back(_source):
    from surfaceflattening_layout import take_back

    take_back()


COMMANDS = {
    "do_again": _do_again,
    "edit_cuts": _edit_cuts,
    "fill_region_factors": _fill_region_factors,
    "flatten_and_compare": _flatten_and_compare,
    "flatten_cortex": _flatten_cortex,
    "patient_axes": _patient_axes,
    "save_flat_map": _save_flat_map,
    "scan_slices": _scan_slices,
    "show_seams": _show_seams,
    "switch_colours": _switch_colours,
    "take_back": _take_back,
}
