#include "FactoredSystem.h"

#include "NestedDissection.h"

namespace bolster {

FactoredSystem::FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places,
                               const std::stop_token& stop)
    : FactoredSystem(matrix, nestedDissection(matrix, places, stop), stop)
{}

FactoredSystem::FactoredSystem(const Eigen::SparseMatrix<double>& matrix, std::vector<int> order,
                               const std::stop_token& stop)
{
    if (stop.stop_requested())
        return; // an order that was not found to its end would fill all of the factor
    SymbolicFactor symbolic(matrix, std::move(order));
    if (stop.stop_requested())
        return;
    m_packed = PackedFactor(std::move(symbolic));
    m_ordered = true;
}

bool FactoredSystem::factor(const Eigen::SparseMatrix<double>& matrix, WorkerPool& pool,
                            const std::stop_token& stop)
{
    m_ok = m_ordered && (matrix.rows() == 0 || m_packed.factor(matrix.valuePtr(), pool, stop));
    return m_ok;
}

} // namespace bolster
