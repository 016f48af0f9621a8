#include "FactoredSystem.h"

#include "NestedDissection.h"

#include <cholmod.h>

#include <cmath>
#include <new>

namespace bolster {

struct FactoredSystem::Cholmod {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;

    Cholmod()
    {
        cholmod_start(&common);
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll = 1;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_GIVEN;
        common.print = 0;
        common.error_handler = [](int, const char*, int, const char*) {}; // the status says it
    }
    ~Cholmod()
    {
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
    bool factorize(cholmod_sparse& matrix)
    {
        cholmod_factorize(&matrix, factor, &common);
        if (common.status == CHOLMOD_OUT_OF_MEMORY)
            throw std::bad_alloc();
        const double condition = factor ? cholmod_rcond(factor, &common) : 0;
        return common.status == CHOLMOD_OK && std::isfinite(condition) && condition > 1e-15;
    }
};

FactoredSystem::FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places)
    : m_cholmod(std::make_unique<Cholmod>())
    , m_ok(matrix.rows() == 0) // every vertex is held
{
    if (m_ok)
        return;
    cholmod_sparse view = Cholmod::view(matrix);
    std::vector<int> order = nestedDissection(matrix, places);
    m_cholmod->factor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &m_cholmod->common);
    if (!m_cholmod->factor)
        throw std::bad_alloc();
    m_ok = m_cholmod->factorize(view);
    if (m_ok)
        m_packed = PackedFactor(*m_cholmod->factor);
}

FactoredSystem::~FactoredSystem() = default;
FactoredSystem::FactoredSystem(FactoredSystem&&) noexcept = default;
FactoredSystem& FactoredSystem::operator=(FactoredSystem&&) noexcept = default;

bool FactoredSystem::refactor(const Eigen::SparseMatrix<double>& matrix)
{
    if (matrix.rows() == 0)
        return m_ok;
    cholmod_sparse view = Cholmod::view(matrix);
    m_ok = m_cholmod->factorize(view);
    if (m_ok)
        m_packed.update(*m_cholmod->factor);
    return m_ok;
}

} // namespace bolster
