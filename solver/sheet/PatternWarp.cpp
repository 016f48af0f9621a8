#include "PatternWarp.h"

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

constexpr double mostWarp = 3; // of a triangle against its first shape

/// Of the vertices of a part those on its outline and lines.
std::vector<char> followers(const SewnMesh& mesh, int part)
{
    const SewnMesh::Part& range = mesh.parts[part];
    std::vector<char> follows(range.vertexCount, 0);
    std::fill_n(follows.begin(), range.boundaryCount, 1);
    const auto& lines = mesh.topology->lines;
    const int end =
        part + 1 < std::ssize(mesh.firstLine) ? mesh.firstLine[part + 1] : static_cast<int>(lines.size());
    for (int line = mesh.firstLine[part]; line < end; ++line)
        for (const std::uint32_t vertex : lines[line].vertices)
            follows[static_cast<int>(vertex) - range.firstVertex] = 1;
    return follows;
}

double distortionOf(const std::array<std::uint32_t, 3>& triangle, const std::vector<Vec2>& before,
                    const std::vector<Vec2>& after)
{
    const auto& [a, b, c] = triangle;
    Eigen::Matrix2d from, to;
    from << before[b] - before[a], before[c] - before[a];
    to << after[b] - after[a], after[c] - after[a];
    if (from == to)
        return 1;                                                // exactly, whatever is lost by rounding below
    const double growth = to.determinant() / from.determinant(); // s1 s2 of the singular values
    if (!(growth > 0))
        return std::numeric_limits<double>::infinity();
    // s1 / s2 is what cotangent weights can grow by, s1 s2 what areas grow by.
    const double sum = (to * from.inverse()).squaredNorm() / (2 * growth); // (s1 / s2 + s2 / s1) / 2
    return std::max({1.0, growth, sum + std::sqrt(std::max(0.0, sum * sum - 1))});
}

} // namespace

double distortion(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Vec2>& before,
                  const std::vector<Vec2>& after, WorkerPool& pool)
{
    const int count = static_cast<int>(triangles.size());
    std::vector<double> most(1 + WorkerPool::chunkCount(count), 1);
    pool.forChunks(count, [&](int chunk, int begin, int end) {
        for (int t = begin; t < end; ++t)
            most[chunk] = std::max(most[chunk], distortionOf(triangles[t], before, after));
    });
    return *std::ranges::max_element(most);
}

PatternWarp::PatternWarp(const SewnMesh& mesh)
    : m_triangles(mesh.topology->triangles)
    , m_base(mesh.rest())
{}

PatternWarp::Inside::Inside(const SewnMesh& mesh, int part)
{
    const SewnMesh::Part& range = mesh.parts[part];
    const std::vector<char> follows = followers(mesh, part);
    std::vector<int> index(range.vertexCount, -1);
    for (int k = 0; k < range.vertexCount; ++k)
        if (!follows[k]) {
            index[k] = static_cast<int>(vertices.size());
            vertices.push_back(range.firstVertex + k);
        }
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < std::ssize(vertices); ++row) {
        const int vertex = vertices[row];
        firstEdge.push_back(static_cast<int>(edges.size()));
        double sum = 0;
        for (int k = mesh.ringStart[vertex]; k < mesh.ringStart[vertex + 1]; ++k) {
            const SewnMesh::RingEdge& edge = mesh.ring[k];
            edges.push_back(edge);
            sum += edge.weight;
            if (const int column = index[edge.vertex - range.firstVertex]; column >= 0 && column < row)
                entries.emplace_back(row, column, -edge.weight);
        }
        entries.emplace_back(row, row, sum);
    }
    firstEdge.push_back(static_cast<int>(edges.size()));
    Eigen::SparseMatrix<double> matrix(std::ssize(vertices), std::ssize(vertices));
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!vertices.empty())
        laplacian.compute(matrix);
}

bool PatternWarp::Inside::solve(std::vector<Vec2>& moves) const
{
    if (vertices.empty())
        return true;
    if (laplacian.info() != Eigen::Success)
        return false;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(std::ssize(vertices), 2);
    for (Eigen::Index row = 0; row < right.rows(); ++row)
        for (int k = firstEdge[row]; k < firstEdge[row + 1]; ++k)
            right.row(row) += edges[k].weight * moves[edges[k].vertex].transpose();
    const Eigen::MatrixX2d solution = laplacian.solve(right);
    for (Eigen::Index row = 0; row < right.rows(); ++row)
        moves[vertices[row]] = solution.row(row);
    return true;
}

/// Moves what lies on outline and lines of a part. False when nothing has moved.
bool PatternWarp::follow(const SewnMesh& mesh, const OutlineSampling& sampling, int part,
                         std::vector<Vec2>& moves) const
{
    bool moved = false;
    const auto put = [&](std::size_t vertex, const Vec2& point) {
        moves[vertex] = point - m_base[vertex];
        moved = moved || point != m_base[vertex];
    };
    const OutlineSampling::Outline& outline = sampling.outlines[part];
    for (int k = 0; k < mesh.parts[part].boundaryCount; ++k)
        put(static_cast<std::size_t>(mesh.parts[part].firstVertex + k), outline.points[k]);
    for (std::size_t line = 0; line < outline.lines.size(); ++line) {
        const auto& vertices = mesh.topology->lines[mesh.firstLine[part] + line].vertices;
        for (std::size_t k = 0; k < outline.lines[line].shape.points.size(); ++k)
            put(vertices[k], outline.lines[line].shape.points[k]);
    }
    return moved;
}

std::optional<std::vector<Vec2>> PatternWarp::warped(const SewnMesh& mesh, const OutlineSampling& sampling,
                                                     WorkerPool& pool)
{
    std::vector<Vec2> moves(m_base.size(), Vec2::Zero());
    for (int part = 0; part < std::ssize(mesh.parts); ++part) {
        if (!follow(mesh, sampling, part, moves))
            continue;
        auto inside = m_insides.find(part);
        if (inside == m_insides.end())
            inside = m_insides.try_emplace(part, mesh, part).first;
        if (!inside->second.solve(moves))
            return std::nullopt;
    }
    std::vector<Vec2> pattern = m_base;
    for (std::size_t v = 0; v < pattern.size(); ++v)
        pattern[v] += moves[v];
    if (distortion(m_triangles, m_base, pattern, pool) > mostWarp)
        return std::nullopt;
    return pattern;
}

} // namespace bolster
