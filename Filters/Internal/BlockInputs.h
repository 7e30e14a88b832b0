// SPDX-License-Identifier: GPL-3.0-or-later
/// The inputs of a filter, taken apart into those of one block of a composite data set at a time.
#pragma once

#include <vtkDataObject.h>
#include <vtkInformationVector.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkCompositeDataIterator;
class vtkCompositeDataSet;

namespace flattening
{

/// The first port that brings a composite data set; -1 if there is none.
int leadingPort(vtkInformationVector** inputs, int portCount);

/// An iterator over all leaves, the empty ones too.
vtkSmartPointer<vtkCompositeDataIterator> leavesOf(vtkCompositeDataSet* data);

/// What users call the leaves, by flat index: `"left"`, `"left", piece 2` or `3`, the flat index itself,
/// if neither the leaf nor a block above it has a name.
std::map<unsigned int, std::string> leafNames(vtkCompositeDataSet* data);

/// What the ports of a filter have for one leaf after the other of the leading port.
class BlockInputs
{
public:
  /// @throws InvalidInput if another composite input has another number of leaves.
  BlockInputs(vtkAlgorithm* filter, vtkInformationVector** inputs, int leadingPort);

  /// Valid until the next call.
  /// @throws InvalidInput if a port has nothing for this leaf, or not what the filter takes.
  vtkInformationVector** of(vtkCompositeDataIterator* leaf);

private:
  vtkDataObject* dataOf(int port, vtkCompositeDataIterator* leaf) const;
  void requireType(int port, vtkDataObject* data) const;

  vtkAlgorithm* Filter;
  std::vector<vtkSmartPointer<vtkDataObject>> Data;
  std::vector<vtkSmartPointer<vtkInformationVector>> Vectors;
  std::vector<vtkInformationVector*> Pointers;
};

} // namespace flattening
