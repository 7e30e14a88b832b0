// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkBlockwisePolyDataAlgorithm
 * @brief   runs a filter on a surface, or on every surface of a composite data set
 *
 * A derived filter implements Execute() for inputs that are neither composite nor empty. An exception
 * that it throws becomes an error of the filter, and an empty input gives an empty output. If an input
 * is a vtkMultiBlockDataSet, vtkPartitionedDataSet or vtkPartitionedDataSetCollection, Execute() is
 * called once for each of its blocks (leaves), and every output port holds a composite data set of the
 * same structure and names. The progress runs once from 0 to 1 over all blocks.
 *
 * vtkCompositeDataPipeline can loop over the blocks of a composite data set, too. This class does so
 * itself, because that executive loops over one input only and does not pair the blocks of several
 * inputs, does not name the block in an error, and leaves no record of the errors in the output.
 *
 * A block that fails is left out of the output (its leaf is null), and the other blocks go on. Its one
 * error begins with the name of the block or, if it has none, with its flat index:
 *
 *     block "left": the surface is closed, ...
 *
 * The field data of each output block holds what the filter reports of that block.
 *
 * Field data of a composite output:
 * - `FailedBlocks` (vtkIdType): number of blocks of this process that failed.
 * - `BlockErrors` (string): one error message per failed block, after those of the filters before;
 *   absent if there is none.
 *
 * If several inputs are composite, their blocks are paired in order; a different number of blocks is an
 * error, with an empty output. An input that is not composite is used for every block. If the second
 * input is a vtkSelection, a block is given the nodes that were made for it and those that were made
 * for no block.
 *
 * In a parallel run each process works on the blocks that it has, and no process waits for another.
 */
#ifndef vtkBlockwisePolyDataAlgorithm_h
#define vtkBlockwisePolyDataAlgorithm_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include <vtkPolyDataAlgorithm.h>

#include <string>
#include <vector>

class vtkCompositeDataIterator;
class vtkCompositeDataSet;

namespace flattening
{
class BlockInputs;
}

class SURFACEFLATTENINGFILTERS_EXPORT vtkBlockwisePolyDataAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBlockwisePolyDataAlgorithm, vtkPolyDataAlgorithm);

  vtkTypeBool ProcessRequest(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

#ifndef __VTK_WRAP__
  /**
   * The beginning of each error and warning about the current block, such as `block "left": `. Empty if
   * no input is composite.
   */
  const std::string& GetBlockPrefix() const
  {
    return this->BlockPrefix;
  }

  /**
   * Stores an error of the current block for the field data of the output. It does not print the error.
   */
  void RecordBlockError(const std::string& message);
#endif

protected:
  vtkBlockwisePolyDataAlgorithm() = default;
  ~vtkBlockwisePolyDataAlgorithm() override = default;

  /**
   * Takes vtkPolyData, or a composite data set of such, on every port.
   */
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * Announces any data object, as its class depends on the inputs. Derived classes override
   * GetBlockOutputType() instead.
   */
  int FillOutputPortInformation(int port, vtkInformation* info) final;

  /**
   * Does the work of the filter. All inputs but the optional ones have data, and the outputs are new.
   * The field data of the first output becomes that of all outputs. An exception is reported as one
   * error with exactly the message of the exception, and leaves all outputs empty.
   */
  virtual void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

  /**
   * The class of the data object that Execute() writes to an output port for these inputs, none of which
   * is composite. Default: vtkPolyData.
   */
  virtual const char* GetBlockOutputType(int port, vtkInformationVector** inputVector);

  /**
   * Requests the whole extent of inputs that come in extents, such as images. Otherwise VTK would
   * request the extent of an output image from them.
   */
  int RequestUpdateExtent(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Runs Execute() on inputs that are not composite.
   */
  int RequestData(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;

private:
  bool HasInputs(vtkInformationVector** inputVector);
  int CreateOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  int RequestBlocks(vtkInformationVector** inputVector,
    vtkInformationVector* outputVector,
    int leadingPort);
  void CreateBlockOutputs(vtkInformationVector** blockInputs, vtkInformationVector* results);
  void ExecuteBlock(flattening::BlockInputs& inputs,
    vtkCompositeDataIterator* leaf,
    const std::vector<vtkCompositeDataSet*>& outputs);

  std::string BlockPrefix;
  std::vector<std::string> BlockErrors;

  vtkBlockwisePolyDataAlgorithm(const vtkBlockwisePolyDataAlgorithm&) = delete;
  void operator=(const vtkBlockwisePolyDataAlgorithm&) = delete;
};

#endif
