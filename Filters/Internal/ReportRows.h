// SPDX-License-Identifier: GPL-3.0-or-later
/// The table in which a filter reports its changes, and numbers with the nouns that they count.
#pragma once

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <string>

namespace flattening
{

inline std::string counted(long long number, const std::string& singular)
{
  return std::to_string(number) + " " + singular + (number == 1 ? "" : "s");
}

/// The columns of the table: how much, what, and the label of the parameter in ParaView that decides it.
class ReportRows
{
public:
  void add(double amount, const std::string& change, const std::string& setting)
  {
    this->Amount->InsertNextValue(amount);
    this->Change->InsertNextValue(change);
    this->Setting->InsertNextValue(setting);
  }

  /// Adds a row if the amount is not 0.
  void addChange(double amount, const std::string& change, const std::string& setting)
  {
    if (amount != 0.0)
    {
      this->add(amount, change, setting);
    }
  }

  void fill(vtkTable* table)
  {
    this->Amount->SetName("Amount");
    this->Change->SetName("Change");
    this->Setting->SetName("Setting");
    table->AddColumn(this->Amount);
    table->AddColumn(this->Change);
    table->AddColumn(this->Setting);
  }

private:
  vtkNew<vtkDoubleArray> Amount;
  vtkNew<vtkStringArray> Change;
  vtkNew<vtkStringArray> Setting;
};

} // namespace flattening
