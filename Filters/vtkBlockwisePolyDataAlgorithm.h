// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkBlockwisePolyDataAlgorithm
 * @brief   takes a surface, or every surface of a composite data set
 *
 * A filter derived from this class implements Execute() for data sets that are neither composite nor
 * empty. Its exceptions become errors, and an empty input an empty output. If an input is a
 * vtkMultiBlockDataSet, vtkPartitionedDataSet or vtkPartitionedDataSetCollection, Execute() is called
 * once for each of its blocks (leaves), and every output port is a composite data set of the same
 * structure and names. Progress runs once from 0 to 1 over all blocks.
 *
 * A block that fails is left out of the output (its leaf is null), and the others go on. There is one
 * error for it, which begins with the block's name (or, without one, its flat index):
 *
 *     block "left": the surface is closed, ...
 *
 * The figures of each block are in the field data of that block. The composite data set itself gets in
 * its field data:
 * - `FailedBlocks`: how many blocks of this process failed;
 * - `BlockErrors`: their errors, one string each, as above; absent if there is none. Errors of the
 * filters before are kept.
 *
 * If several inputs are composite, their blocks belong together one by one; the number of blocks must be
 * the same, or nothing comes out but an error. An input that is not composite serves every block. Of a
 * vtkSelection as second input, a block sees the nodes made for it, and those without a block.
 *
 * In a parallel run each process takes the blocks that it has; no process waits for another.
 */
#ifndef vtkBlockwisePolyDataAlgorithm_h
#define vtkBlockwisePolyDataAlgorithm_h

#include "SurfaceFlatteningFiltersModule.h" // for the export macro
#include <vtkPolyDataAlgorithm.h>

#include <string>
#include <vector>

class SURFACEFLATTENINGFILTERS_EXPORT vtkBlockwisePolyDataAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBlockwisePolyDataAlgorithm, vtkPolyDataAlgorithm);

  vtkTypeBool ProcessRequest(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

#ifndef __VTK_WRAP__
  /**
   * What an error or a warning of the block at work begins with: `block "left": `. Empty if the input is
   * not composite.
   */
  const std::string& GetBlockPrefix() const
  {
    return this->BlockPrefix;
  }

  /**
   * Keeps the error of the block at work for the field data of the output. It does not print it.
   */
  void RecordBlockError(const std::string& message);
#endif

protected:
  vtkBlockwisePolyDataAlgorithm() = default;
  ~vtkBlockwisePolyDataAlgorithm() override = default;

  /**
   * vtkPolyData, or a composite data set of such, on every port.
   */
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * Any data object: which one depends on the input. Derived classes do not override this, but
   * GetBlockOutputType().
   */
  int FillOutputPortInformation(int port, vtkInformation* info) final;

  /**
   * What the filter does. The inputs have data, those that are optional aside; the outputs are new. The
   * field data of the first output becomes that of all. What it throws is reported as one error, with
   * word for word the exception's message, and leaves all outputs empty.
   */
  virtual void Execute(vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

  /**
   * The class of what Execute() writes to an output port for these inputs, none of which is composite:
   * vtkPolyData unless overridden.
   */
  virtual const char* GetBlockOutputType(int port, vtkInformationVector** inputVector);

  /**
   * Asks for the whole of inputs that come in extents, such as images: without, the extent of an image
   * that is an output would be asked of them.
   */
  int RequestUpdateExtent(vtkInformation* request,
    vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Runs Execute() on inputs that are not composite. Derived classes do not override this.
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

  std::string BlockPrefix;
  std::vector<std::string> BlockErrors;

  vtkBlockwisePolyDataAlgorithm(const vtkBlockwisePolyDataAlgorithm&) = delete;
  void operator=(const vtkBlockwisePolyDataAlgorithm&) = delete;
};

#endif
