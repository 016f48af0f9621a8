#include "SolvePeers.h"

#include <Eigen/SparseCholesky>

#include <cholmod.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace bolster::bench {

namespace {

constexpr int rightSides = 3; // x, y, z

class Cholmod {
public:
    explicit Cholmod(int supernodal)
    {
        cholmod_start(&m_common);
        m_common.supernodal = supernodal;
        m_common.nmethods = 3; // CHOLMOD keeps the one with the least fill
        m_common.method[0].ordering = CHOLMOD_AMD;
        m_common.method[1].ordering = CHOLMOD_METIS;
        m_common.method[2].ordering = CHOLMOD_NESDIS;
    }
    ~Cholmod()
    {
        cholmod_free_factor(&m_factor, &m_common);
        cholmod_free_dense(&m_right, &m_common);
        cholmod_free_dense(&m_solution, &m_common);
        cholmod_free_dense(&m_workspaces[0], &m_common);
        cholmod_free_dense(&m_workspaces[1], &m_common);
        cholmod_finish(&m_common);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    void factor(const Eigen::SparseMatrix<double>& lower)
    {
        cholmod_sparse matrix = view(lower);
        m_factor = cholmod_analyze(&matrix, &m_common);
        cholmod_factorize(&matrix, m_factor, &m_common);
        if (m_common.status != CHOLMOD_OK)
            throw std::runtime_error("CHOLMOD could not factor a benchmark's matrix");
        m_right = cholmod_ones(matrix.nrow, rightSides, CHOLMOD_REAL, &m_common);
    }
    /// The workspaces are kept, so nothing is allocated.
    void solve()
    {
        cholmod_solve2(CHOLMOD_LDLt, m_factor, m_right, nullptr, &m_solution, nullptr, &m_workspaces[0],
                       &m_workspaces[1], &m_common);
    }

private:
    /// Nothing is copied.
    static cholmod_sparse view(const Eigen::SparseMatrix<double>& matrix)
    {
        cholmod_sparse sparse{};
        sparse.nrow = static_cast<std::size_t>(matrix.rows());
        sparse.ncol = static_cast<std::size_t>(matrix.cols());
        sparse.nzmax = static_cast<std::size_t>(matrix.nonZeros());
        sparse.p = const_cast<int*>(matrix.outerIndexPtr());
        sparse.i = const_cast<int*>(matrix.innerIndexPtr());
        sparse.x = const_cast<double*>(matrix.valuePtr());
        sparse.stype = -1;
        sparse.itype = CHOLMOD_INT;
        sparse.xtype = CHOLMOD_REAL;
        sparse.dtype = CHOLMOD_DOUBLE;
        sparse.sorted = 1;
        sparse.packed = 1;
        return sparse;
    }

    cholmod_common m_common{};
    cholmod_factor* m_factor = nullptr;
    cholmod_dense* m_right = nullptr;
    cholmod_dense* m_solution = nullptr;
    cholmod_dense* m_workspaces[2] = {nullptr, nullptr};
};

struct EigenPeer {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor; // AMD, its best
    Eigen::MatrixXd right, solution;

    explicit EigenPeer(const Eigen::SparseMatrix<double>& lower)
        : factor(lower)
        , right(Eigen::MatrixXd::Ones(lower.rows(), rightSides))
    {}
    void solve()
    {
        solution = right;
        factor.matrixL().solveInPlace(solution);
        solution = factor.vectorD().asDiagonal().inverse() * solution;
        factor.matrixU().solveInPlace(solution);
    }
};

} // namespace

std::function<void()> solveBy(SolvePeer peer, const Eigen::SparseMatrix<double>& lower)
{
    if (peer == SolvePeer::EigenLdlt)
        return [eigen = std::make_shared<EigenPeer>(lower)] { eigen->solve(); };
    const auto cholmod =
        std::make_shared<Cholmod>(peer == SolvePeer::CholmodSupernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL);
    cholmod->factor(lower);
    return [cholmod] { cholmod->solve(); };
}

} // namespace bolster::bench
