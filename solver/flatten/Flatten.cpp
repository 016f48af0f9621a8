#include "Flatten.h"

#include "ConformalStart.h"
#include "NestedDissection.h"
#include "PieceSystem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace bolster {

namespace {

using Mat2 = Eigen::Matrix2d;
using Sparse = Eigen::SparseMatrix<double>;

constexpr std::array seamWeights{1.0, 4.0}; // of sewn edges against the sheet's area beside them, pass by pass
constexpr double splinter = 0.02;           // of the mean area: what cuts have left of a triangle says nothing
constexpr double mostStrain = 0.5;          // as in the sheet's local step
constexpr double holding = 1e-9;            // of every vertex where it is, against cotangents

/// The rotation nearest to a plane map.
Mat2 nearestRotation(const Mat2& map)
{
    const double c = map(0, 0) + map(1, 1), s = map(1, 0) - map(0, 1), length = std::sqrt(c * c + s * s);
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
    PieceSheet(const Form& form, const FormPiece& piece, double poisson, const std::stop_token& stop)
        : m_form(form)
        , m_piece(piece)
        , m_poisson(poisson)
        , m_count(static_cast<Eigen::Index>(piece.points.size()))
    {
        for (const auto& corners : piece.triangles)
            m_facets.push_back(facetOf(corners, {point(corners[0]), point(corners[1]), point(corners[2])}));
        m_places.resize(3, m_count);
        for (int v = 0; v < m_count; ++v)
            m_places.col(v) = point(v);
        if (!piece.isSheet()) {
            m_at.setConstant(m_count, 2, std::numeric_limits<double>::quiet_NaN());
            return;
        }
        addSewnEdges();
        findOrder(stop);
        startConformally(stop);
    }

    void factor(double seamWeight, const std::stop_token& stop)
    {
        if (!m_piece.isSheet())
            return;
        m_seamWeight = seamWeight;
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int i, int j, double value) { entries.emplace_back(i, j, value); };
        for (const Facet& facet : m_facets) {
            const Eigen::Matrix3d block = facet.weight * facet.gradient.transpose() * facet.gradient;
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    if (facet.corners[i] >= facet.corners[j])
                        add(facet.corners[i], facet.corners[j], block(i, j));
        }
        for (const SewnEdge& edge : m_sewn) {
            const double w = seamWeight * edge.weight;
            add(edge.from, edge.from, w);
            add(edge.to, edge.to, w);
            add(std::max(edge.from, edge.to), std::min(edge.from, edge.to), -w);
        }
        for (int v = 0; v < m_count; ++v)
            add(v, v, v == 0 ? 1 : holding); // it may lie anywhere
        Sparse matrix(m_count, m_count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        if (!m_system) // what is where stays from pass to pass
            m_system.emplace(matrix, m_order, stop);
        if (!m_system->factor(matrix, alongIt(), stop))
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
        Eigen::MatrixX2d left = Eigen::MatrixX2d::Zero(m_count, 2); // what pulls at each vertex
        for (const Facet& facet : m_facets) {
            const Mat2 map = jacobian(facet);
            const Eigen::Matrix<double, 3, 2> pull =
                facet.weight * facet.gradient.transpose() * (target(map) - map).transpose();
            for (int k = 0; k < 3; ++k)
                left.row(facet.corners[k]) += pull.row(k);
        }
        for (const SewnEdge& edge : m_sewn) {
            const Vec2 way = at(edge.to) - at(edge.from);
            const double now = way.norm();
            const Vec2 along = now > 0 ? Vec2(way / now) : Vec2(1, 0);
            const Vec2 pull = m_seamWeight * edge.weight * (wanted[edge.edge] * along - way);
            left.row(edge.to) += pull.transpose();
            left.row(edge.from) -= pull.transpose();
        }
        const Eigen::MatrixX2d step = m_system->solve(left);
        m_at += step;
        // Where the piece lies does not matter: what counts is how its shape has changed.
        const Eigen::RowVector2d drift = step.colwise().mean();
        return (step.rowwise() - drift).rowwise().norm().maxCoeff();
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
        FlatPiece flat;
        if (!m_at.allFinite()) { // no sheet, or triangles without an area, all over
            flat.at.assign(static_cast<std::size_t>(m_count), Vec2::Zero());
            flat.strain.assign(m_facets.size(), 0);
            flat.turnedOver = static_cast<int>(m_facets.size());
            flat.turnedShare = 1;
            return flat;
        }
        turnUpwards();
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
    /// Along the longest extent: what springs between neighbours resist least.
    Eigen::MatrixXd alongIt() const
    {
        const auto [first, second] = farApart();
        const Vec3 along = (point(second) - point(first)).normalized();
        return (along.transpose() * (m_places.colwise() - point(first))).transpose();
    }

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
    Mat2 target(const Mat2& map) const
    {
        const Mat2 turn = nearestRotation(map);
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

    /// Both systems of the piece join the same vertices: those of triangles.
    void findOrder(const std::stop_token& stop)
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (const Facet& facet : m_facets)
            for (int k = 0; k < 3; ++k) {
                const auto [first, second] = std::minmax(facet.corners[k], facet.corners[(k + 1) % 3]);
                entries.emplace_back(second, first, 1);
            }
        Sparse joined(m_count, m_count);
        joined.setFromTriplets(entries.begin(), entries.end());
        m_order = nestedDissection(joined, m_places, stop);
    }

    void startConformally(const std::stop_token& stop)
    {
        m_at = conformalStart(m_facets, m_places, m_order, farApart(), stop);
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

    /// Two vertices of the border.
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
    double m_meanArea = 0;     // of facets, mm^2
    Eigen::Matrix3Xd m_places; // of the vertices on the form, mm
    std::vector<int> m_order;  // of elimination
    std::optional<PieceSystem> m_system;
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
            made[p].emplace(form, form.pieces[p], order.poisson, stop);
    });
    if (stop.stop_requested() || made.empty())
        return {};
    std::vector<PieceSheet> sheets;
    for (std::optional<PieceSheet>& sheet : made)
        sheets.push_back(std::move(*sheet));
    CommonLengths lengths(form, sheets);
    for (const double weight : seamWeights) {
        pool.forTasks(static_cast<int>(sheets.size()), [&](int p) { sheets[p].factor(weight, stop); });
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
