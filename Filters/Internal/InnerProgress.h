// SPDX-License-Identifier: GPL-3.0-or-later
/// Progress and abort of a filter that another one runs.
#pragma once

#include "Core/Base/Progress.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

namespace flattening
{

/// Forwards the progress of an inner filter to a callback, and an abort to the inner filter, as long as
/// it lives.
class InnerProgress
{
public:
  /// @param stage the stage that the callback is told where the inner filter names none
  InnerProgress(vtkAlgorithm* inner, ProgressCallback progress, const char* stage)
    : Inner(inner)
    , Progress(std::move(progress))
    , Stage(stage)
    , Tag(inner->AddObserver(vtkCommand::ProgressEvent, this, &InnerProgress::reported))
  {
  }
  InnerProgress(const InnerProgress&) = delete;
  InnerProgress& operator=(const InnerProgress&) = delete;
  ~InnerProgress() { this->Inner->RemoveObserver(this->Tag); }

private:
  void reported()
  {
    const char* stage = this->Inner->GetProgressText();
    if (!this->Progress(this->Inner->GetProgress(), stage && *stage ? stage : this->Stage))
    {
      this->Inner->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Inner;
  ProgressCallback Progress;
  const char* Stage;
  unsigned long Tag;
};

} // namespace flattening
