// SPDX-License-Identifier: GPL-3.0-or-later
/// Progress, abort and error handling that all filters share, so that no exception leaves RequestData.
/// All guards for VTK versions are here.
#pragma once

#include "Core/Base/Errors.h"
#include "Core/Base/Progress.h"
#include "vtkBlockwisePolyDataAlgorithm.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>
#include <vtkSetGet.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string>

namespace flattening
{

inline bool abortRequested(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230000)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// A progress callback for Core that reports to the filter and reads its abort flag. The filter's
/// progress never decreases: copies of the callback share the greatest fraction.
inline ProgressCallback progressOf(vtkAlgorithm* filter)
{
  return [filter, greatest = std::make_shared<double>(0.0)](double fraction, const char* stage)
  {
    *greatest = std::max(*greatest, fraction);
    filter->SetProgressText(stage);
    filter->UpdateProgress(*greatest);
    return !abortRequested(filter);
  };
}

/// Empties every output of the request.
inline void emptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}

/// Reports an error of the filter, with the name of the current block of a composite data set, if any.
inline void reportError(vtkAlgorithm* filter, const std::string& message)
{
  std::string text = message;
  auto* blockwise = vtkBlockwisePolyDataAlgorithm::SafeDownCast(filter);
  if (blockwise && !blockwise->GetBlockPrefix().empty())
  {
    text = blockwise->GetBlockPrefix() + message;
    blockwise->RecordBlockError(text);
  }
  vtkErrorWithObjectMacro(filter, << text);
}

/// Runs the body of RequestData. An exception is reported once as an error of the filter, with exactly
/// its message, and leaves empty outputs; an abort leaves empty outputs without an error.
/// @return the return value of RequestData: 1, even after a failure. With 0 the pipeline would not
/// update the filters downstream, and a view would keep showing the previous result.
template <typename Body>
int runFilter(vtkAlgorithm* filter, vtkInformationVector* outputs, Body&& body)
{
  try
  {
    body();
    return 1;
  }
  catch (const Cancelled&)
  {
    emptyOutputs(outputs);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    reportError(filter,
      "out of memory: reduce the input, e.g. a surface with Decimate or an image with Extract Subset, "
      "or "
      "what the settings ask for, such as points, pixels or samples");
  }
  catch (const FlatteningError& error)
  {
    reportError(filter, error.what());
  }
  catch (const std::exception& error)
  {
    // Libraries throw other exceptions, such as oneTBB where no thread can be started.
    reportError(filter,
      std::string("a library has failed (") + error.what() +
        "): if memory or the number of threads is limited, raise the limit or reduce the input");
  }
  catch (...)
  {
    reportError(filter, "failed for an unknown reason");
  }
  emptyOutputs(outputs);
  return 1;
}

} // namespace flattening
