#include "FactoredSystem.h"

#include "NestedDissection.h"

namespace bolster {

FactoredSystem::FactoredSystem(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix3Xd& places)
    : m_packed(SymbolicFactor(matrix, nestedDissection(matrix, places)))
{}

bool FactoredSystem::factor(const Eigen::SparseMatrix<double>& matrix, WorkerPool& pool,
                            const std::stop_token& stop)
{
    m_ok = matrix.rows() == 0 || m_packed.factor(matrix.valuePtr(), pool, stop);
    return m_ok;
}

} // namespace bolster
