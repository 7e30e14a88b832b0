// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/SparseFactorization.h"

#include "Base/BlasLock.h"
#include "Base/Errors.h"
#include "Base/InterruptibleCall.h"

#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>

#include <new>
#include <utility>

namespace flattening
{
namespace
{

// An order is given up that makes the factor so many times as large as it was. A factorization takes
// about a quarter longer then (time grows as the power 3/2 of the fill), so that the search for a new
// order, which costs one, pays after four more. Greater values slow long sequences down, smaller ones
// search too often.
constexpr double GreatestGrowth = 1.15;

// CHOLMOD and UMFPACK return where they should throw.
void requireMemory(bool hasMemory)
{
  if (!hasMemory)
  {
    throw std::bad_alloc();
  }
}

// Solves L y = e_i with the factor L whose entries are stored one by one.
class HalfSolution
{
public:
  HalfSolution(cholmod_factor* factor, cholmod_common& common)
    : Factor(factor)
    , Common(common)
    , RightSide(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(factor->n)))
    , Row(static_cast<Eigen::Index>(factor->n), 1)
  {
    this->Row.insert(0, 0) = 1.0;
    this->Row.makeCompressed();
  }

  ~HalfSolution()
  {
    cholmod_free_dense(&this->Solution, &this->Common);
    cholmod_free_sparse(&this->Rows, &this->Common);
    cholmod_free_dense(&this->Work[0], &this->Common);
    cholmod_free_dense(&this->Work[1], &this->Common);
  }

  HalfSolution(const HalfSolution&) = delete;
  HalfSolution& operator=(const HalfSolution&) = delete;

  void solve(int row)
  {
    this->RightSide[row] = 1.0;
    this->Row.innerIndexPtr()[0] = row;
    cholmod_dense right = Eigen::viewAsCholmod(this->RightSide);
    cholmod_sparse pattern = Eigen::viewAsCholmod(this->Row);
    cholmod_solve2(CHOLMOD_L,
      this->Factor,
      &right,
      &pattern,
      &this->Solution,
      &this->Rows,
      &this->Work[0],
      &this->Work[1],
      &this->Common);
    this->RightSide[row] = 0.0;
  }

  // Appends the entries of the last solution as column @p column.
  void appendTo(std::vector<Eigen::Triplet<double>>& entries, int column) const
  {
    const auto* rows = static_cast<const int*>(this->Rows->i);
    const auto* values = static_cast<const double*>(this->Solution->x);
    for (int k = 0; k < static_cast<const int*>(this->Rows->p)[1]; ++k)
    {
      entries.emplace_back(rows[k], column, values[rows[k]]);
    }
  }

private:
  cholmod_factor* Factor;
  cholmod_common& Common;
  Eigen::VectorXd RightSide;
  SparseMatrix Row; // the pattern of the right side
  cholmod_dense* Solution = nullptr;
  cholmod_sparse* Rows = nullptr; // the pattern of the solution
  cholmod_dense* Work[2] = { nullptr, nullptr };
};

} // namespace

struct SparseCholesky::Factor : Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower>
{
  Factor(Ordering search, EliminationOrder order, Kernel kernel)
    : Search(search)
    , Order(std::move(order))
    , UsesBlas(kernel == Kernel::Blocks)
  {
    this->cholmod().print = 0; // the caller reports
    if (kernel == Kernel::Entries)
    {
      this->cholmod().final_asis = 0;
      this->cholmod().final_ll = 1;
      this->cholmod().supernodal = CHOLMOD_SIMPLICIAL;
    }
  }

  void factor(const SparseMatrix& matrix)
  {
    if (!(this->HasConstantPattern && this->m_analysisIsOk) && !this->reuseOrder(matrix) &&
        !this->findOrder(matrix))
    {
      return;
    }
    const std::unique_ptr<BlasLock> lock = this->blasLock();
    this->factorize(matrix);
    this->requireMemoryAndSize();
  }

  Eigen::MatrixXd solution(const Eigen::Ref<const Eigen::MatrixXd>& rightSide)
  {
    const std::unique_ptr<BlasLock> lock = this->blasLock();
    Eigen::MatrixXd result = this->solve(rightSide);
    this->requireMemoryAndSize();
    return result;
  }

  // With A = L L^T, the entry of the inverse at (i, j) is the product of the solutions of L y = e_i and
  // L y = e_j, which have few entries.
  Eigen::MatrixXd inverseAt(const std::vector<int>& unknowns)
  {
    const auto size = static_cast<int>(this->m_cholmodFactor->n);
    const auto* order = static_cast<const int*>(this->m_cholmodFactor->Perm);
    std::vector<int> rank(size);
    for (int k = 0; k < size; ++k)
    {
      rank[order[k]] = k;
    }
    HalfSolution half(this->m_cholmodFactor, this->cholmod());
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
    {
      half.solve(rank[unknowns[i]]);
      this->requireMemoryAndSize();
      half.appendTo(entries, static_cast<int>(i));
    }
    SparseMatrix solutions(size, static_cast<Eigen::Index>(unknowns.size()));
    solutions.setFromTriplets(entries.begin(), entries.end());
    return SparseMatrix(solutions.transpose() * solutions).toDense();
  }

  // Analyses the pattern in the order that is known. False if that order does not serve.
  bool reuseOrder(const SparseMatrix& matrix)
  {
    if (static_cast<Eigen::Index>(this->Order.Unknowns.size()) != matrix.rows())
    {
      return false;
    }
    cholmod_common& common = this->cholmod();
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
    const int methods = common.nmethods;
    common.nmethods = 1; // only the first method, which is the given order
    cholmod_factor* factor = cholmod_analyze_p(&view, this->Order.Unknowns.data(), nullptr, 0, &common);
    common.nmethods = methods;
    this->requireMemoryAndSize();
    if (!factor || common.lnz > GreatestGrowth * this->Order.Fill)
    {
      cholmod_free_factor(&factor, &common);
      return false;
    }
    cholmod_free_factor(&this->m_cholmodFactor, &common);
    this->m_cholmodFactor = factor;
    this->m_isInitialized = true;
    this->m_info = Eigen::Success;
    this->m_analysisIsOk = true;
    this->m_factorizationIsOk = false;
    return true;
  }

  // False, as if the matrix were not positive definite, if CHOLMOD does not accept it: it has no
  // entries.
  bool findOrder(const SparseMatrix& matrix)
  {
    cholmod_common& common = this->cholmod();
    const int methods = common.nmethods;
    const int first = common.method[0].ordering;
    if (this->Search == Ordering::Quick)
    {
      common.nmethods = 1;
      common.method[0].ordering = CHOLMOD_AMD;
    }
    this->analyzePattern(matrix);
    common.nmethods = methods;
    common.method[0].ordering = first;
    this->requireMemoryAndSize();
    if (!this->m_cholmodFactor)
    {
      this->m_analysisIsOk = false;
      this->m_info = Eigen::NumericalIssue;
      return false;
    }
    const auto* order = static_cast<const int*>(this->m_cholmodFactor->Perm);
    this->Order.Unknowns.assign(order, order + matrix.rows());
    this->Order.Fill = common.lnz;
    return true;
  }

  // After every call of CHOLMOD.
  void requireMemoryAndSize()
  {
    requireMemory(this->cholmod().status != CHOLMOD_OUT_OF_MEMORY);
    if (this->cholmod().status == CHOLMOD_TOO_LARGE)
    {
      throw InvalidInput(
        "the factor of a linear system has more entries than CHOLMOD can count: reduce the "
        "surface, e.g. with Decimate");
    }
  }

  std::unique_ptr<BlasLock> blasLock() const
  {
    return this->UsesBlas ? std::make_unique<BlasLock>() : nullptr;
  }

  Ordering Search;
  EliminationOrder Order;
  bool UsesBlas;
  bool HasConstantPattern = false;
};

SparseCholesky::SparseCholesky(Ordering ordering)
  : Shared(std::make_shared<Factor>(ordering, EliminationOrder(), Kernel::Blocks))
{
}

SparseCholesky::SparseCholesky(EliminationOrder order, Kernel kernel)
  : Shared(std::make_shared<Factor>(Ordering::Quick, std::move(order), kernel))
{
}

SparseCholesky::SparseCholesky(const SparseMatrix& matrix)
  : SparseCholesky(Ordering::Quick)
{
  this->compute(matrix);
}

SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::compute(const SparseMatrix& matrix)
{
  this->Shared->factor(matrix);
}

void SparseCholesky::compute(SparseMatrix matrix,
  const ProgressCallback& progress,
  double fraction,
  const char* stage)
{
  callInterruptibly(
    [factor = this->Shared, owned = std::make_shared<const SparseMatrix>(std::move(matrix))]()
    { factor->factor(*owned); },
    progress,
    fraction,
    stage);
}

void SparseCholesky::expectConstantPattern()
{
  this->Shared->HasConstantPattern = true;
}

Eigen::ComputationInfo SparseCholesky::info() const
{
  return this->Shared->info();
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const
{
  return this->Shared->solution(rightSide);
}

Eigen::MatrixXd SparseCholesky::inverseAt(const std::vector<int>& unknowns) const
{
  return this->Shared->inverseAt(unknowns);
}

const EliminationOrder& SparseCholesky::order() const
{
  return this->Shared->Order;
}

EliminationOrder SparseCholesky::orderOf(SparseMatrix pattern,
  Ordering ordering,
  const ProgressCallback& progress,
  double fraction,
  const char* stage)
{
  const auto factor = std::make_shared<Factor>(ordering, EliminationOrder(), Kernel::Blocks);
  callInterruptibly([factor, owned = std::make_shared<const SparseMatrix>(std::move(pattern))]()
    { factor->findOrder(*owned); },
    progress,
    fraction,
    stage);
  return factor->Order;
}

struct SparseLu::Factors : Eigen::UmfPackLU<SparseMatrix>
{
  explicit Factors(SparseMatrix matrix)
    : Matrix(std::move(matrix))
  {
  }

  void factor()
  {
    const BlasLock lock;
    this->analyzePattern(this->Matrix);
    requireMemory(this->m_fact_errorCode != UMFPACK_ERROR_out_of_memory);
    this->factorize(this->Matrix);
    requireMemory(this->m_fact_errorCode != UMFPACK_ERROR_out_of_memory);
  }

  // @param system UMFPACK_A, or UMFPACK_At for the transposed matrix
  Eigen::MatrixXd solution(int system, const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const
  {
    Eigen::MatrixXd solution(rightSide.rows(), rightSide.cols());
    const BlasLock lock;
    double control[UMFPACK_CONTROL];
    double info[UMFPACK_INFO];
    umfpack_di_defaults(control);
    control[UMFPACK_IRSTEP] = 0; // callers refine by residuals of their own
    for (Eigen::Index k = 0; k < rightSide.cols(); ++k)
    {
      const int status = umfpack_di_solve(system,
        this->mp_matrix.outerIndexPtr(),
        this->mp_matrix.innerIndexPtr(),
        this->mp_matrix.valuePtr(),
        solution.col(k).data(),
        rightSide.col(k).data(),
        this->m_numeric,
        control,
        info);
      requireMemory(status != UMFPACK_ERROR_out_of_memory);
    }
    return solution;
  }

  const SparseMatrix Matrix; // which UMFPACK reads again for every solution
};

SparseLu::SparseLu(SparseMatrix matrix)
  : SparseLu(std::move(matrix), {}, 0.0, "")
{
}

SparseLu::SparseLu(SparseMatrix matrix,
  const ProgressCallback& progress,
  double fraction,
  const char* stage)
  : Shared(std::make_shared<Factors>(std::move(matrix)))
{
  callInterruptibly([factors = this->Shared]() { factors->factor(); }, progress, fraction, stage);
}

SparseLu::~SparseLu() = default;

Eigen::ComputationInfo SparseLu::info() const
{
  return this->Shared->info();
}

Eigen::MatrixXd SparseLu::solve(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const
{
  return this->Shared->solution(UMFPACK_A, rightSide);
}

Eigen::MatrixXd SparseLu::solveTransposed(const Eigen::Ref<const Eigen::MatrixXd>& rightSide) const
{
  return this->Shared->solution(UMFPACK_At, rightSide);
}

} // namespace flattening
