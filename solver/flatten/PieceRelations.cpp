#include "PieceRelations.h"

#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

PieceRelations::PieceRelations(const Form& form)
    : m_form(form)
    , m_around(form.pieces.size())
{
    const std::size_t count = m_form.pieces.size();
    UnionFind sewn(static_cast<int>(count));
    for (std::size_t p = 0; p < count; ++p)
        for (const EdgeMate& mate : piece(p).mates)
            if (!mate.none())
                sewn.join(static_cast<int>(p), mate.piece);
    m_group = sewn.labels();
    m_open.resize(count, false);
    for (std::size_t p = 0; p < count; ++p)
        if (std::ranges::any_of(piece(p).mates, &EdgeMate::none))
            m_open[m_group[p]] = true;
}

double PieceRelations::bendAlong(std::size_t p, const BorderRow& row) const
{
    double sum = 0, length = 0;
    for (std::size_t k = 0; k < row.count; ++k) {
        const std::size_t edge = (row.first + k) % piece(p).border.size();
        const EdgeMate& mate = piece(p).mates[edge];
        const double weight = (formPoint(p, piece(p).after(edge)) - formPoint(p, edge)).norm();
        const Vec3 here = normalBeside(p, edge), there = normalBeside(mate.piece, mate.edge);
        sum += weight * std::acos(std::clamp(here.dot(there), -1.0, 1.0)) * 180 / std::numbers::pi;
        length += weight;
    }
    return length > 0 ? sum / length : 0;
}

Vec3 PieceRelations::normalBeside(std::size_t p, std::size_t edge) const
{
    const int from = piece(p).border[edge], to = piece(p).border[piece(p).after(edge)];
    const auto point = [&](int v) { return m_form.points[piece(p).points[v]]; };
    for (const auto& triangle : trianglesAt(p, from))
        for (int k = 0; k < 3; ++k)
            if (triangle[k] == from && triangle[(k + 1) % 3] == to)
                return (point(to) - point(from)).cross(point(triangle[(k + 2) % 3]) - point(from)).normalized();
    return Vec3::UnitZ();
}

/// Those around a vertex; made for a piece when it is first asked for.
const std::vector<std::array<int, 3>>& PieceRelations::trianglesAt(std::size_t p, int vertex) const
{
    auto& around = m_around[p];
    if (around.empty()) {
        around.resize(piece(p).points.size());
        for (const auto& triangle : piece(p).triangles)
            for (const int corner : triangle)
                around[corner].push_back(triangle);
    }
    return around[vertex];
}

bool PieceRelations::mirrors(std::size_t p, std::size_t q, double farthest) const
{
    for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
        const Vec3 here = formPoint(p, k).cwiseProduct(Vec3(-1, 1, 1));
        double nearest = 2 * farthest;
        for (std::size_t i = 0; i < piece(q).border.size() && nearest > farthest; ++i) {
            const Vec3 from = formPoint(q, i), way = formPoint(q, piece(q).after(i)) - from;
            const double along = std::clamp((here - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (from + along * way - here).norm());
        }
        if (nearest > farthest)
            return false;
    }
    return true;
}

} // namespace bolster
