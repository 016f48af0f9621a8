#include "ChangeCost.h"

#include <Eigen/SparseCore>

#include <map>
#include <utility>
#include <vector>

namespace bolster {

namespace {

constexpr double smoothShare = 4; // of second differences along an outline, against the changes themselves

/// Rows of second differences along an outline: what moves points shall move their neighbours alike.
std::vector<Eigen::Triplet<double>> smoothRows(const Design& design, std::span<const Freedom> freedoms, int& count)
{
    std::map<std::pair<ElementId, int>, std::vector<Eigen::Index>> at; // freedoms of each control point
    for (std::size_t k = 0; k < freedoms.size(); ++k)
        if (freedoms[k].kind == Freedom::Kind::OutlinePoint)
            at[{freedoms[k].element, freedoms[k].index}].push_back(static_cast<Eigen::Index>(k));
    std::vector<Eigen::Triplet<double>> entries;
    count = 0;
    for (const auto& [point, here] : at) {
        if (here.size() != 1)
            continue; // a corner
        const auto& [patch, index] = point;
        const int points = design.find<Patch>(patch)->outline.pointCount();
        const Vec2 direction = freedoms[static_cast<std::size_t>(here.front())].direction;
        for (const auto& [offset, weight] : {std::pair(-1, 1.0), std::pair(0, -2.0), std::pair(1, 1.0)})
            if (const auto found = at.find({patch, (index + offset + points) % points}); found != at.end())
                for (const Eigen::Index k : found->second)
                    entries.emplace_back(count, k,
                                         weight * freedoms[static_cast<std::size_t>(k)].direction.dot(direction));
        ++count;
    }
    return entries;
}

} // namespace

ChangeCost::ChangeCost(const Design& design, std::span<const Freedom> freedoms, double weight)
    : m_steps(std::ssize(freedoms))
{
    for (Eigen::Index k = 0; k < m_steps.size(); ++k)
        m_steps[k] = freedoms[static_cast<std::size_t>(k)].step;
    int count = 0;
    const auto entries = smoothRows(design, freedoms, count);
    Eigen::SparseMatrix<double> rows(count, m_steps.size());
    rows.setFromTriplets(entries.begin(), entries.end());
    m_squares = smoothShare * Eigen::MatrixXd(rows.transpose() * rows);
    m_squares.diagonal().array() += 1;
    m_squares *= weight * weight;
}

double ChangeCost::of(const Eigen::VectorXd& values) const
{
    const Eigen::VectorXd steps = inSteps(values);
    return steps.dot(m_squares * steps);
}

} // namespace bolster
