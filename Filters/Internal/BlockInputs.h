// SPDX-License-Identifier: GPL-3.0-or-later
/// The inputs of a filter for one block of its composite inputs at a time.
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

/// The first port with a composite data set; -1 if there is none.
int leadingPort(vtkInformationVector** inputs, int portCount);

/// An iterator over all leaves, including empty ones.
vtkSmartPointer<vtkCompositeDataIterator> leavesOf(vtkCompositeDataSet* data);

/// The names of the leaves in messages, by flat index: `"left"`, `"left", piece 2`, or the flat index,
/// such as `3`, if neither the leaf nor a block above it has a name.
std::map<unsigned int, std::string> leafNames(vtkCompositeDataSet* data);

/// Pairs each leaf of the leading port with the data of the other ports.
class BlockInputs
{
public:
  /// @throws InvalidInput if another composite input has a different number of leaves.
  BlockInputs(vtkAlgorithm* filter, vtkInformationVector** inputs, int leadingPort);

  /// The inputs for a leaf, valid until the next call.
  /// @throws InvalidInput if a port has no data for this leaf, or data of a type that the filter does
  /// not take.
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
