#include "Flatten.h"

#include "WorkerPool.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace bolster {

namespace {

using Mat2 = Eigen::Matrix2d;
using Mat23 = Eigen::Matrix<double, 2, 3>;
using Sparse = Eigen::SparseMatrix<double>;

constexpr std::array seamWeights{1.0, 4.0}; // of sewn edges against the sheet's area beside them, pass by pass
constexpr double splinter = 0.02;           // of the mean area: what cuts have left of a triangle says nothing
constexpr double mostStrain = 0.5;          // as in the sheet's local step
constexpr double leastHeight = 0.005;       // of a triangle, of its longest edge, to count in full
constexpr double noHeight = 1e-6;           // likewise, to have a shape: cuts leave ones without an area
constexpr double holding = 1e-9;            // of every vertex where it is, against cotangents

/// A triangle of the form in its own plane.
struct Facet {
    std::array<int, 3> corners{};
    Mat23 gradient; ///< of the three hat functions, 1/mm
    double area = 0;
    double weight = 0;                       ///< of its energy, mm^2
    Vec3 x = Vec3::Zero(), y = Vec3::Zero(); ///< of that plane
};

/// One that is little more than its longest edge counts for less: its weights would drown those of all others, and
/// of one without an area it is chance how it lies. The faces of CAD programs can consist of such triangles alone.
Facet facetOf(const std::array<int, 3>& corners, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const std::array<Vec3, 3> places{a, b, c};
    const auto edge = [&](std::size_t k) { return Vec3(places[(k + 1) % 3] - places[k]); };
    const std::size_t base = edge(0).norm() >= edge(1).norm() ? (edge(0).norm() >= edge(2).norm() ? 0 : 2)
                                                              : (edge(1).norm() >= edge(2).norm() ? 1 : 2);
    const double longest = edge(base).norm();
    Facet facet{corners, Mat23::Zero()};
    if (!(longest > 0))
        return facet;
    const Vec3 x = edge(base) / longest, way = places[(base + 2) % 3] - places[base];
    const double along = way.dot(x), height = std::max((way - along * x).norm(), noHeight * longest);
    std::array<Vec2, 3> at;
    at[base] = Vec2(0, 0);
    at[(base + 1) % 3] = Vec2(longest, 0);
    at[(base + 2) % 3] = Vec2(along, height);
    facet.area = longest * height / 2;
    facet.weight = facet.area * std::min(1.0, height / (leastHeight * longest));
    facet.x = x;
    facet.y = (way - along * x).normalized();
    for (int k = 0; k < 3; ++k) {
        const Vec2 opposite = at[(k + 2) % 3] - at[(k + 1) % 3];
        facet.gradient.col(k) = Vec2(-opposite.y(), opposite.x()) / (2 * facet.area);
    }
    return facet;
}

/// The rotation nearest to a plane map.
Mat2 nearestRotation(const Mat2& map)
{
    const double c = map(0, 0) + map(1, 1), s = map(1, 0) - map(0, 1), length = std::hypot(c, s);
    if (!(length > 0))
        return Mat2::Identity();
    return (Mat2() << c, -s, s, c).finished() / length;
}

/// A sewn edge of the border: its length is pulled to the mean of both sides.
struct SewnEdge {
    int from = 0, to = 0;
    double weight = 0; ///< 1
    EdgeMate mate;
    std::size_t edge = 0;
};

class PieceSheet {
public:
    PieceSheet(const Form& form, const FormPiece& piece, double poisson)
        : m_form(form)
        , m_piece(piece)
        , m_poisson(poisson)
        , m_count(static_cast<Eigen::Index>(piece.points.size()))
    {
        for (const auto& corners : piece.triangles)
            m_facets.push_back(facetOf(corners, point(corners[0]), point(corners[1]), point(corners[2])));
        addSewnEdges();
        startConformally();
    }

    void factor(double seamWeight)
    {
        m_seamWeight = seamWeight;
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int i, int j, double value) { entries.emplace_back(i, j, value); };
        for (const Facet& facet : m_facets) {
            const Eigen::Matrix3d block = facet.weight * facet.gradient.transpose() * facet.gradient;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    add(facet.corners[i], facet.corners[j], block(i, j));
        }
        for (const SewnEdge& edge : m_sewn) {
            const double w = seamWeight * edge.weight;
            add(edge.from, edge.from, w);
            add(edge.to, edge.to, w);
            add(edge.from, edge.to, -w);
            add(edge.to, edge.from, -w);
        }
        for (int v = 0; v < m_count; ++v)
            add(v, v, v == 0 ? 1 : holding); // it may lie anywhere
        Sparse matrix(m_count, m_count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        if (!m_solver) { // what is where stays from pass to pass
            m_solver = std::make_unique<Eigen::SimplicialLDLT<Sparse>>();
            m_solver->analyzePattern(matrix);
        }
        m_solver->factorize(matrix);
        if (m_solver->info() != Eigen::Success)
            m_at.setConstant(std::numeric_limits<double>::quiet_NaN());
    }

    double length(std::size_t edge) const
    {
        return (at(m_piece.border[m_piece.after(edge)]) - at(m_piece.border[edge])).norm();
    }

    /// One round; `wanted` are the lengths of the sewn edges. Returns how far the farthest vertex has moved, mm.
    double iterate(const std::vector<double>& wanted)
    {
        if (!m_at.allFinite())
            return 0;
        Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(m_count, 2);
        for (const Facet& facet : m_facets) {
            const Eigen::Matrix<double, 3, 2> pull =
                facet.weight * facet.gradient.transpose() * target(facet).transpose();
            for (int k = 0; k < 3; ++k)
                right.row(facet.corners[k]) += pull.row(k);
        }
        for (const SewnEdge& edge : m_sewn) {
            const Vec2 way = at(edge.to) - at(edge.from);
            const double now = way.norm();
            const Vec2 pull =
                m_seamWeight * edge.weight * wanted[edge.edge] * (now > 0 ? Vec2(way / now) : Vec2(1, 0));
            right.row(edge.to) += pull.transpose();
            right.row(edge.from) -= pull.transpose();
        }
        right += holding * m_at;
        right.row(0) += (1 - holding) * m_at.row(0);
        const Eigen::MatrixX2d next = m_solver->solve(right);
        // Where the piece lies does not matter: what counts is how its shape has changed.
        const Eigen::RowVector2d drift = (next - m_at).colwise().mean();
        const double moved = ((next - m_at).rowwise() - drift).rowwise().norm().maxCoeff();
        m_at = next;
        return moved;
    }

    const std::vector<SewnEdge>& sewn() const { return m_sewn; }

    /// That 99 % of the area do not exceed.
    double percentile99(const std::vector<float>& strains) const
    {
        std::vector<std::pair<float, double>> sizes;
        double all = 0;
        for (std::size_t t = 0; t < strains.size(); ++t) {
            sizes.emplace_back(strains[t], m_facets[t].area);
            all += m_facets[t].area;
        }
        std::ranges::sort(sizes);
        double sum = 0;
        for (const auto& [strain, area] : sizes)
            if ((sum += area) >= 0.99 * all)
                return strain;
        return 0;
    }

    FlatPiece result()
    {
        turnUpwards();
        FlatPiece flat;
        if (!m_at.allFinite()) { // triangles without an area, all over
            flat.at.assign(static_cast<std::size_t>(m_count), Vec2::Zero());
            flat.strain.assign(m_facets.size(), 0);
            flat.turnedOver = static_cast<int>(m_facets.size());
            flat.turnedShare = 1;
            return flat;
        }
        double sum = 0, area = 0, turnedArea = 0;
        for (const Facet& facet : m_facets) {
            const Mat2 map = jacobian(facet);
            const double turned = map.determinant();
            const bool counts = facet.area > splinter * m_meanArea;
            flat.turnedOver += counts && turned <= 0;
            turnedArea += turned <= 0 ? facet.area : 0;
            flat.area += facet.area * turned;
            const Eigen::Vector2d sizes = map.jacobiSvd().singularValues();
            area += facet.area;
            double largest = 0;
            for (int k = 0; k < 2; ++k) {
                const double strain = sizes[k] > 1e-3 ? 1 / sizes[k] - 1 : 1e3; // flat to form
                sum += facet.area * std::min(strain * strain, 1.0) / 2;
                largest = std::max(largest, std::abs(strain));
                if (counts && std::abs(strain) > flat.strainMost) {
                    flat.strainMost = std::abs(strain);
                    flat.strainedAt =
                        (point(facet.corners[0]) + point(facet.corners[1]) + point(facet.corners[2])) / 3;
                }
            }
            flat.strain.push_back(static_cast<float>(counts ? largest : 0));
        }
        flat.strainRms = area > 0 ? std::sqrt(sum / area) : 0;
        flat.strainP99 = percentile99(flat.strain);
        flat.turnedShare = area > 0 ? turnedArea / area : 0;
        for (Eigen::Index v = 0; v < m_count; ++v)
            flat.at.emplace_back(m_at.row(v).transpose());
        return flat;
    }

private:
    const Vec3& point(int vertex) const { return m_form.points[m_piece.points[vertex]]; }
    Vec2 at(int vertex) const { return m_at.row(vertex).transpose(); }

    Mat2 jacobian(const Facet& facet) const
    {
        Mat2 map = Mat2::Zero();
        for (int k = 0; k < 3; ++k)
            map += at(facet.corners[k]) * facet.gradient.col(k).transpose();
        return map;
    }

    /// What the triangle would be if it could choose: turned, and as much wider as it is stretched across, by the
    /// Poisson number (docs/solver.md, local step).
    Mat2 target(const Facet& facet) const
    {
        const Mat2 map = jacobian(facet), turn = nearestRotation(map);
        Mat2 strain = turn.transpose() * map - Mat2::Identity();
        strain = (0.5 * (strain + strain.transpose())).cwiseMax(-mostStrain).cwiseMin(mostStrain);
        return turn * (Mat2::Identity() - m_poisson * (strain.trace() * Mat2::Identity() - strain));
    }

    void addSewnEdges()
    {
        std::vector<double> beside(m_piece.border.size(), 0);
        for (const Facet& facet : m_facets)
            m_meanArea += facet.area / static_cast<double>(m_facets.size());
        for (std::size_t k = 0; k < m_piece.border.size(); ++k) {
            if (m_piece.mates[k].none())
                continue;
            const int from = m_piece.border[k], to = m_piece.border[m_piece.after(k)];
            const double rest = (point(to) - point(from)).squaredNorm();
            m_sewn.push_back({from, to, rest > 0 ? m_meanArea / rest : 0, m_piece.mates[k], k});
        }
    }

    /// Two vertices of the border are held, those that are farthest from each other; the others lie where triangles
    /// keep their angles best.
    void startConformally()
    {
        const auto [first, second] = farApart();
        std::vector<Eigen::Index> number(m_count, -1);
        Eigen::Index free = 0;
        for (Eigen::Index v = 0; v < m_count; ++v)
            if (v != first && v != second)
                number[v] = free++;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * std::ssize(m_facets));
        const double apart = (point(second) - point(first)).norm();
        for (Eigen::Index f = 0; f < std::ssize(m_facets); ++f) {
            const Facet& facet = m_facets[f];
            const double root = std::sqrt(facet.weight);
            for (int k = 0; k < 3; ++k) { // the map (u, v) keeps angles where grad v is grad u turned by 90 degrees
                const Vec2 g = root * facet.gradient.col(k);
                const int v = facet.corners[k];
                if (v == first)
                    continue; // at the origin
                if (v == second) {
                    right[2 * f] -= g.x() * apart;
                    right[2 * f + 1] -= g.y() * apart;
                    continue;
                }
                entries.emplace_back(2 * f, 2 * number[v], g.x());
                entries.emplace_back(2 * f, 2 * number[v] + 1, -g.y());
                entries.emplace_back(2 * f + 1, 2 * number[v], g.y());
                entries.emplace_back(2 * f + 1, 2 * number[v] + 1, g.x());
            }
        }
        Sparse rows(2 * std::ssize(m_facets), 2 * free);
        rows.setFromTriplets(entries.begin(), entries.end());
        const Sparse transposed = rows.transpose();
        const Eigen::SimplicialLDLT<Sparse> solver(transposed * rows);
        m_at = Eigen::MatrixX2d::Zero(m_count, 2);
        if (solver.info() != Eigen::Success) { // its values are anything then
            m_at.setConstant(std::numeric_limits<double>::quiet_NaN());
            return;
        }
        const Eigen::VectorXd places = solver.solve(transposed * right);
        m_at.row(second) = Eigen::RowVector2d(apart, 0);
        for (Eigen::Index v = 0; v < m_count; ++v)
            if (number[v] >= 0)
                m_at.row(v) = places.segment<2>(2 * number[v]).transpose();
        scaleToArea();
    }

    void scaleToArea()
    {
        double wanted = 0, found = 0;
        for (const Facet& facet : m_facets) {
            wanted += facet.area;
            found += facet.area * jacobian(facet).determinant();
        }
        if (found > 0)
            m_at *= std::sqrt(wanted / found);
    }

    std::pair<int, int> farApart() const
    {
        const auto farthest = [&](int from) {
            return *std::ranges::max_element(m_piece.border, {},
                                             [&](int v) { return (point(v) - point(from)).squaredNorm(); });
        };
        const int first = farthest(m_piece.border.front());
        return {first, farthest(first)};
    }

    /// Up on the form is +y.
    void turnUpwards()
    {
        const auto inPlane = [&](const Vec3& direction) {
            Vec2 sum = Vec2::Zero();
            for (const Facet& facet : m_facets) {
                const Vec2 here(direction.dot(facet.x), direction.dot(facet.y));
                sum += facet.area * (nearestRotation(jacobian(facet)) * here);
            }
            return sum;
        };
        double area = 0;
        for (const Facet& facet : m_facets)
            area += facet.area;
        Vec2 up = inPlane(Vec3::UnitZ());
        if (up.norm() < 0.3 * area)
            up = inPlane(Vec3::UnitY());
        const Vec2 middle = m_at.colwise().mean().transpose();
        const double angle = up.norm() > 0 ? std::atan2(up.x(), up.y()) : 0;
        const Mat2 turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
        for (Eigen::Index v = 0; v < m_count; ++v)
            m_at.row(v) = (turn * (at(static_cast<int>(v)) - middle)).transpose();
    }

    const Form& m_form;
    const FormPiece& m_piece;
    double m_poisson;
    Eigen::Index m_count;
    std::vector<Facet> m_facets;
    std::vector<SewnEdge> m_sewn;
    double m_seamWeight = 0;
    double m_meanArea = 0; // of facets, mm^2
    std::unique_ptr<Eigen::SimplicialLDLT<Sparse>> m_solver;
    Eigen::MatrixX2d m_at;
};

/// The lengths that sewn edges shall have: the mean of both sides. Springs leave a little of every difference, so
/// the wish goes further than the mean, by what the two sides of a whole seam have differed so far.
class CommonLengths {
public:
    CommonLengths(const Form& form, const std::vector<PieceSheet>& sheets)
        : m_form(form)
        , m_sheets(sheets)
        , m_beyond(sheets.size())
    {
        for (std::size_t p = 0; p < sheets.size(); ++p)
            m_beyond[p].resize(form.pieces[p].rows.size(), 0);
    }

    /// Of each piece, of each edge of its border; what is not sewn has none.
    std::vector<std::vector<double>> wanted()
    {
        std::vector<std::vector<double>> lengths(m_sheets.size());
        for (std::size_t p = 0; p < m_sheets.size(); ++p) {
            const FormPiece& piece = m_form.pieces[p];
            lengths[p].resize(piece.border.size());
            for (std::size_t r = 0; r < piece.rows.size(); ++r)
                if (piece.rows[r].isSewn())
                    wish(p, piece.rows[r], m_beyond[p][r], lengths[p]);
        }
        return lengths;
    }

private:
    void wish(std::size_t p, const BorderRow& row, double& beyond, std::vector<double>& lengths) const
    {
        const FormPiece& piece = m_form.pieces[p];
        double mine = 0, other = 0;
        for (std::size_t k = 0; k < row.count; ++k) {
            const std::size_t edge = (row.first + k) % piece.border.size();
            const EdgeMate& mate = piece.mates[edge];
            const double here = m_sheets[p].length(edge), there = m_sheets[mate.piece].length(mate.edge);
            if (!std::isfinite(there)) { // what cannot be laid flat asks for nothing
                mine = other = 0;
                lengths[edge] = here;
                continue;
            }
            mine += here;
            other += there;
            lengths[edge] = 0.5 * (here + there);
        }
        if (mine + other > 0)
            beyond += gain * (other - mine) / (other + mine);
        for (std::size_t k = 0; k < row.count; ++k)
            lengths[(row.first + k) % piece.border.size()] *= 1 + beyond;
    }

    static constexpr double gain = 0.3;

    const Form& m_form;
    const std::vector<PieceSheet>& m_sheets;
    std::vector<std::vector<double>> m_beyond; // of each row, relative
};

} // namespace

std::vector<FlatPiece> flatten(const Form& form, const FlattenOrder& order, const std::stop_token& stop)
{
    WorkerPool pool(0);
    std::vector<std::optional<PieceSheet>> made(form.pieces.size());
    pool.forTasks(static_cast<int>(made.size()), [&](int p) {
        if (!stop.stop_requested())
            made[p].emplace(form, form.pieces[p], order.poisson);
    });
    if (stop.stop_requested() || made.empty())
        return {};
    std::vector<PieceSheet> sheets;
    for (std::optional<PieceSheet>& sheet : made)
        sheets.push_back(std::move(*sheet));
    CommonLengths lengths(form, sheets);
    for (const double weight : seamWeights) {
        pool.forTasks(static_cast<int>(sheets.size()), [&](int p) { sheets[p].factor(weight); });
        for (int round = 0; round < order.mostRounds; ++round) {
            const std::vector<std::vector<double>> wanted = lengths.wanted();
            if (stop.stop_requested())
                return {};
            std::vector<double> moved(sheets.size(), 0);
            pool.forTasks(static_cast<int>(sheets.size()), [&](int p) { moved[p] = sheets[p].iterate(wanted[p]); });
            if (std::ranges::max(moved) < order.settled)
                break;
        }
    }
    std::vector<FlatPiece> pieces;
    for (PieceSheet& sheet : sheets)
        pieces.push_back(sheet.result());
    return pieces;
}

} // namespace bolster
