// SPDX-License-Identifier: GPL-3.0-or-later
/// The error of a filter that another one runs.
#pragma once

#include "Core/Base/Errors.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <string>

namespace flattening
{

/// Keeps the error of an inner filter from being shown, as long as it lives, so that the outer filter
/// can report it as its own.
class InnerError
{
public:
  explicit InnerError(vtkAlgorithm* inner)
    : Inner(inner)
    , Tag(inner->AddObserver(vtkCommand::ErrorEvent, this, &InnerError::reported))
  {
  }
  InnerError(const InnerError&) = delete;
  InnerError& operator=(const InnerError&) = delete;
  ~InnerError() { this->Inner->RemoveObserver(this->Tag); }

  /// @throws InvalidInput with the message of the inner filter, if it has reported an error.
  void rethrow() const
  {
    if (!this->Message.empty())
    {
      throw InvalidInput(this->Message);
    }
  }

private:
  // VTK's text is "ERROR: In file, line 1\nclass (address): message\n\n".
  void reported(vtkObject*, unsigned long, void* data)
  {
    const std::string text = static_cast<const char*>(data);
    const std::size_t begin = text.find("): ");
    this->Message = begin == std::string::npos ? text : text.substr(begin + 3);
    this->Message.erase(this->Message.find_last_not_of('\n') + 1);
  }

  vtkAlgorithm* Inner;
  std::string Message;
  unsigned long Tag;
};

} // namespace flattening
