#include "PatternWarp.h"

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

constexpr double mostDistortion = 3; // of a triangle against its first shape

} // namespace

double distortion(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Vec2>& before,
                  const std::vector<Vec2>& after)
{
    double most = 1;
    for (const auto& [a, b, c] : triangles) {
        Eigen::Matrix2d from, to;
        from << before[b] - before[a], before[c] - before[a];
        to << after[b] - after[a], after[c] - after[a];
        const double growth = to.determinant() / from.determinant(); // s1 s2 of the singular values
        if (!(growth > 0))
            return std::numeric_limits<double>::infinity();
        // s1 / s2 is what cotangent weights can grow by, s1 s2 what areas grow by.
        const double sum = (to * from.inverse()).squaredNorm() / (2 * growth); // (s1 / s2 + s2 / s1) / 2
        most = std::max({most, growth, sum + std::sqrt(std::max(0.0, sum * sum - 1))});
    }
    return most;
}

PatternWarp::PatternWarp(const SewnMesh& mesh)
    : m_triangles(mesh.topology->triangles)
    , m_base(mesh.rest())
{}

PatternWarp::Inside& PatternWarp::insideOf(const SewnMesh& mesh, int part)
{
    const auto [found, isNew] = m_insides.try_emplace(part);
    Inside& inside = found->second;
    if (!isNew)
        return inside;
    const SewnMesh::Part& range = mesh.parts[part];
    std::vector<int> index(range.vertexCount, -1); // free ones get theirs below
    const auto& lines = mesh.topology->lines;
    const auto end = part + 1 < std::ssize(mesh.firstLine) ? mesh.firstLine[part + 1] : std::ssize(lines);
    std::vector<char> follows(range.vertexCount, 0);
    std::fill_n(follows.begin(), range.boundaryCount, 1);
    for (auto line = mesh.firstLine[part]; line < end; ++line)
        for (const std::uint32_t vertex : lines[line].vertices)
            follows[static_cast<int>(vertex) - range.firstVertex] = 1;
    for (int k = 0; k < range.vertexCount; ++k)
        if (!follows[k]) {
            index[k] = static_cast<int>(inside.vertices.size());
            inside.vertices.push_back(range.firstVertex + k);
        }
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < std::ssize(inside.vertices); ++row) {
        const int vertex = inside.vertices[row];
        inside.firstEdge.push_back(static_cast<int>(inside.edges.size()));
        double sum = 0;
        for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k) {
            const SewnMesh::RingEdge& edge = mesh.ring[k];
            inside.edges.push_back(edge);
            sum += edge.weight;
            if (const int column = index[edge.vertex - range.firstVertex]; column >= 0 && column < row)
                entries.emplace_back(row, column, -edge.weight);
        }
        entries.emplace_back(row, row, sum);
    }
    inside.firstEdge.push_back(static_cast<int>(inside.edges.size()));
    Eigen::SparseMatrix<double> matrix(std::ssize(inside.vertices), std::ssize(inside.vertices));
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (matrix.rows() > 0)
        inside.laplacian.compute(matrix);
    return inside;
}

std::optional<std::vector<Vec2>> PatternWarp::warped(const SewnMesh& mesh, const OutlineSampling& sampling)
{
    std::vector<Vec2> moves(m_base.size(), Vec2::Zero());
    std::vector<Vec2> pattern = m_base;
    for (int p = 0; p < std::ssize(mesh.parts); ++p) {
        const SewnMesh::Part& part = mesh.parts[p];
        const OutlineSampling::Outline& outline = sampling.outlines[p];
        bool moved = false;
        const auto follow = [&](std::uint32_t vertex, const Vec2& point) {
            moves[vertex] = point - m_base[vertex];
            moved = moved || point != m_base[vertex];
        };
        for (int k = 0; k < part.boundaryCount; ++k)
            follow(static_cast<std::uint32_t>(part.firstVertex + k), outline.points[k]);
        for (std::size_t line = 0; line < outline.lines.size(); ++line) {
            const auto& vertices = mesh.topology->lines[mesh.firstLine[p] + line].vertices;
            for (std::size_t k = 0; k < outline.lines[line].shape.points.size(); ++k)
                follow(vertices[k], outline.lines[line].shape.points[k]);
        }
        if (!moved)
            continue;
        Inside& inside = insideOf(mesh, p);
        const Eigen::Index count = std::ssize(inside.vertices);
        Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
        for (Eigen::Index row = 0; row < count; ++row)
            for (int k = inside.firstEdge[row]; k < inside.firstEdge[row + 1]; ++k)
                right.row(row) += inside.edges[k].weight * moves[inside.edges[k].vertex].transpose();
        if (count > 0) {
            if (inside.laplacian.info() != Eigen::Success)
                return std::nullopt;
            const Eigen::MatrixX2d solution = inside.laplacian.solve(right);
            for (Eigen::Index row = 0; row < count; ++row)
                moves[inside.vertices[row]] = solution.row(row);
        }
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v)
            pattern[v] += moves[v];
    }
    if (distortion(m_triangles, m_base, pattern) > mostDistortion)
        return std::nullopt;
    return pattern;
}

} // namespace bolster
