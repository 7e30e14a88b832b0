# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of Area Weights, filled from the labels in the data.

    from surfaceflattening_regions import fill_region_factors

    weights = AreaWeights(Input=brain, WeightArray=["CELLS", "Region"])
    fill_region_factors(weights)
    weights.LabelFactors  # 1, 1.0, 2, 1.0, ...: a label and its factor in turn

The module comes with the plugin. The macro "Fill Region Factors" calls it for the Area Weights that is selected
in the pipeline browser; then the factors are typed into the table.
"""

from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMUncheckedPropertyHelper
from paraview.modules.vtkRemotingViews import vtkPVProminentValuesInformation
from vtkmodules.vtkCommonDataModel import vtkDataObject


def fill_region_factors(weights=None, factor=1.0):
    """Sets Weights From of @weights, an Area Weights (by default the active source), to Label Table and gives
    every label of its Weight Array a row with @factor. Rows that the table has keep theirs.

    @raise ValueError if there is no Area Weights or no array, or its values are no labels.
    """
    weights = weights or simple.GetActiveSource()
    if weights is None or weights.GetXMLName() != "AreaWeights":
        raise ValueError("select an Area Weights in the pipeline browser first")
    table = list(weights.LabelFactors)
    factors = dict(zip(table[0::2], table[1::2]))
    for label in labels(weights):
        factors.setdefault(label, factor)
    weights.WeightsFrom = "Label Table"
    weights.LabelFactors = [number for row in sorted(factors.items()) for number in row]


def labels(weights):
    """The labels in the Weight Array of @weights, in order; that of the panel if it is not applied yet."""
    chosen = vtkSMUncheckedPropertyHelper(weights.SMProxy, "WeightArray")
    association, name = chosen.GetAsString(3), chosen.GetAsString(4)
    if name in ("", "None"):
        raise ValueError("choose the Weight Array of Area Weights first")
    source = weights.Input
    source.UpdatePipeline()
    values = vtkPVProminentValuesInformation()
    values.SetPortNumber(source.Port)
    values.SetFieldAssociation(vtkDataObject.GetAssociationTypeAsString(int(association)))
    values.SetFieldName(name)
    values.SetNumberOfComponents(1)
    values.SetForce(True)  # more than 32
    source.SMProxy.GatherInformation(values)
    found = values.GetProminentComponentValues(0)
    if found is None or found.GetNumberOfTuples() == 0:
        raise ValueError(f"the input of Area Weights has no array {name}: choose another one")
    numbers = sorted(found.GetVariantValue(k).ToDouble() for k in range(found.GetNumberOfTuples()))
    fraction = next((number for number in numbers if number != int(number)), None)
    if fraction is not None:
        raise ValueError(
            f"{name} has the value {fraction}: labels are whole numbers. Choose the array of labels, or set "
            "Weights From to Scalars"
        )
    return numbers
