// SPDX-License-Identifier: GPL-3.0-or-later
/// What every filter of this module does around its mathematics: progress, abort, and exceptions that
/// never leave RequestData. All guards for VTK versions are here.
#pragma once

#include "Core/Base/Errors.h"
#include "Core/Base/Progress.h"
#include "vtkBlockwisePolyDataAlgorithm.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>
#include <vtkSetGet.h>
#include <vtkVersionMacros.h>

#include <exception>
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

/// A Core progress callback that drives the filter's own progress and abort.
inline ProgressCallback progressOf(vtkAlgorithm* filter)
{
  return [filter](double fraction, const char* stage)
  {
    filter->SetProgressText(stage);
    filter->UpdateProgress(fraction);
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

/// Reports an error of the filter; while it works on a block of a composite data set, with the block's
/// name.
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

/// Runs the body of RequestData. A failure is reported once as an error of the filter, with word for
/// word the exception's message, and leaves empty outputs; so does an abort, without an error.
/// Returns what RequestData returns: 1, after a failure too. With 0 the pipeline would not go on to what
/// is downstream, and a view would keep showing the result from before.
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
    reportError(filter, "out of memory: reduce the surface, e.g. with Decimate");
  }
  catch (const std::exception& error)
  {
    reportError(filter, error.what());
  }
  catch (...)
  {
    reportError(filter, "failed for an unknown reason");
  }
  emptyOutputs(outputs);
  return 1;
}

} // namespace flattening
