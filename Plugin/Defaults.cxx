// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defaults.h"

#include <vtkSMSettings.h>

namespace
{

// Below the settings of the user and of the site, which have priorities from 1 on.
constexpr double Priority = 0.5;

// -1 is "Never" of the automatic rescaling: the ranges are fixed, so that maps can be compared.
//
// ScaledCurvature is grey, as nine tenths of a surface are from -1 to 1 and a little contrast is left for
// the rest. AreaDistortion is the logarithm of the area ratio; its annotations are percent, from two
// thirds to one and a half.
//
// DataMode 1 is Binary: Debian's ParaView 5.11 cannot read its own default, Appended.
constexpr const char* Settings = R"({
  "array_lookup_tables": {
    "ScaledCurvature": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "ScalarRangeInitialized": 1,
      "ColorSpace": 0,
      "RGBPoints": [-1.5, 0.0, 0.0, 0.0, 1.5, 1.0, 1.0, 1.0]
    } },
    "AreaDistortion": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "ScalarRangeInitialized": 1,
      "ColorSpace": 3,
      "RGBPoints": [-0.405465, 0.231373, 0.298039, 0.752941, 0.0, 0.865003, 0.865003, 0.865003,
                    0.405465, 0.705882, 0.0156863, 0.14902],
      "Annotations": ["-0.405465", "-33 %", "-0.223144", "-20 %", "-0.10536", "-10 %", "0", "0 %",
                      "0.09531", "+10 %", "0.223144", "+25 %", "0.405465", "+50 %"]
    } },
    "AngleDistortion": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "ScalarRangeInitialized": 1,
      "RGBPoints": [0.0, 1.0, 1.0, 1.0, 1.5, 0.4, 0.0, 0.3]
    } }
  },
  "writers": {
    "XMLPolyDataWriter": { "DataMode": 1 },
    "XMLImageDataWriter": { "DataMode": 1 },
    "XMLUnstructuredGridWriter": { "DataMode": 1 },
    "XMLMultiBlockDataWriter": { "DataMode": 1 },
    "XMLPartitionedDatasetCollectionWriter": { "DataMode": 1 }
  }
})";

} // namespace

void surfaceFlatteningDefaults()
{
  vtkSMSettings::GetInstance()->AddCollectionFromString(Settings, Priority);
}
