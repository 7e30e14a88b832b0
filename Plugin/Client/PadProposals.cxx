// SPDX-License-Identifier: GPL-3.0-or-later
#include "PadProposals.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>

#include <vtkDataSetAttributes.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVDataSetAttributesInformation.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMSourceProxy.h>

#include <string>

namespace
{

constexpr int Margin = 10; // voxels, as of Volume To Surface

} // namespace

PadProposals::PadProposals(QObject* parent)
  : QObject(parent)
{
  connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::sourceAdded,
    this,
    &PadProposals::propose);
}

void PadProposals::propose(pqPipelineSource* source)
{
  vtkSMProxy* proxy = source->getProxy();
  if (std::string(proxy->GetXMLName()) != "ImagePad")
  {
    return;
  }
  vtkSMPropertyHelper input(proxy, "Input");
  auto* scan =
    vtkSMSourceProxy::SafeDownCast(input.GetNumberOfElements() > 0 ? input.GetAsProxy() : nullptr);
  vtkPVDataInformation* data = scan ? scan->GetDataInformation(input.GetOutputPort()) : nullptr;
  vtkSMPropertyHelper extent(proxy, "OutputWholeExtent");
  if (!data || data->GetNumberOfPoints() == 0 || extent.GetAsInt(0) <= extent.GetAsInt(1))
  {
    return; // there is no volume yet, or the filter comes from a state or a script that has an extent
  }
  for (int k = 0; k < 6; ++k)
  {
    extent.Set(k, data->GetExtent()[k] + (k % 2 == 0 ? -Margin : Margin));
  }
  if (vtkPVArrayInformation* voxels =
        data->GetPointDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS))
  {
    vtkSMPropertyHelper(proxy, "Constant").Set(voxels->GetComponentRange(0)[0]);
  }
}
