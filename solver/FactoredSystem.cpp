#include "FactoredSystem.h"

#include "NestedDissection.h"

#include <cholmod.h>

#include <cmath>
#include <new>

namespace bolster {

struct FactoredSystem::Cholmod {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* x = nullptr;
    cholmod_dense* y = nullptr;
    cholmod_dense* e = nullptr;
    bool ok = false;

    Cholmod()
    {
        cholmod_start(&common);
        // Large ones are factored by supernodes, faster by far, but solved column by column, faster for the few
        // right-hand sides that we have.
        common.supernodal = CHOLMOD_AUTO;
        common.supernodal_switch = 100; // operations per entry of the factor: some 100,000 unknowns
        common.final_super = 0;
        common.final_ll = 1;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_GIVEN;
        common.print = 0;
        common.error_handler = [](int, const char*, int, const char*) {}; // the status says it
    }
    ~Cholmod()
    {
        cholmod_free_dense(&x, &common);
        cholmod_free_dense(&y, &common);
        cholmod_free_dense(&e, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }

    /// A view, nothing is copied.
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

    /// Success alone means little: NaN input is reported as a success too.
    void factorize(cholmod_sparse& matrix)
    {
        cholmod_factorize(&matrix, factor, &common);
        if (common.status == CHOLMOD_OUT_OF_MEMORY)
            throw std::bad_alloc();
        const double condition = factor ? cholmod_rcond(factor, &common) : 0;
        ok = common.status == CHOLMOD_OK && std::isfinite(condition) && condition > 1e-15;
    }
};

FactoredSystem::FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places)
    : m_cholmod(std::make_unique<Cholmod>())
{
    m_cholmod->ok = matrix.rows() == 0; // every vertex is held
    if (m_cholmod->ok)
        return;
    cholmod_sparse view = Cholmod::view(matrix);
    std::vector<int> order = nestedDissection(matrix, places);
    m_cholmod->factor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &m_cholmod->common);
    if (!m_cholmod->factor)
        throw std::bad_alloc();
    m_cholmod->factorize(view);
}

FactoredSystem::~FactoredSystem() = default;
FactoredSystem::FactoredSystem(FactoredSystem&&) noexcept = default;
FactoredSystem& FactoredSystem::operator=(FactoredSystem&&) noexcept = default;

bool FactoredSystem::ok() const
{
    return m_cholmod->ok;
}

bool FactoredSystem::refactor(const Eigen::SparseMatrix<double>& matrix)
{
    if (matrix.rows() == 0)
        return m_cholmod->ok;
    cholmod_sparse view = Cholmod::view(matrix);
    m_cholmod->factorize(view);
    return m_cholmod->ok;
}

void FactoredSystem::solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x)
{
    if (b.rows() == 0) {
        x = b;
        return;
    }
    cholmod_dense right{};
    right.nrow = static_cast<std::size_t>(b.rows());
    right.ncol = static_cast<std::size_t>(b.cols());
    right.nzmax = static_cast<std::size_t>(b.size());
    right.d = right.nrow;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    Cholmod& c = *m_cholmod;
    if (!cholmod_solve2(CHOLMOD_A, c.factor, &right, nullptr, &c.x, nullptr, &c.y, &c.e, &c.common))
        throw std::bad_alloc();
    x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(c.x->x), b.rows(), b.cols());
}

} // namespace bolster
