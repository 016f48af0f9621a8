#include "SeamSides.h"

#include "ArcLength.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

constexpr int sideRounds = 4;
constexpr double equal = 0.01;          // mm
constexpr double farthestPoint = 1;     // mm, of a control point
constexpr double differences = 1e-3;    // mm, for derivatives
constexpr double onALine = 1e-6;        // mm
constexpr double hardlySolvable = 1e-9; // of the largest: sides that no point can change

/// A curve as its own control points, which belong to it alone but for the ends.
struct Freedoms {
    int begin = 0, end = 0; ///< numbers of its ends
    int inner = 0;          ///< the first of those between; of straight curves these follow the ends
    bool straight = false;
};

bool lieOnALine(const std::vector<Vec2>& points)
{
    const Vec2 way = (points.back() - points.front()).normalized();
    return way.norm() > 0 && std::ranges::all_of(points, [&](const Vec2& point) {
               const Vec2 off = point - points.front();
               return std::abs(off.x() * way.y() - off.y() * way.x()) < onALine;
           });
}

class Sides {
    using Numbers = std::vector<std::vector<Freedoms>>; // of each curve of each piece

public:
    Sides(const Form& form, std::vector<PieceCurves>& pieces)
        : m_form(form)
        , m_pieces(pieces)
        , m_lengths(pieces.size())
    {
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            number(p);
            m_lengths[p].resize(pieces[p].curves.size());
            measure(p);
        }
        for (std::size_t p = 0; p < pieces.size(); ++p)
            for (std::size_t r = 0; r < pieces[p].rows.size(); ++r)
                addCondition(p, r);
    }

    /// The largest, mm.
    double difference() const
    {
        double most = 0;
        for (const Condition& condition : m_conditions)
            most = std::max(most, std::abs(differenceOf(condition)));
        return most;
    }

    /// The largest move of a point, mm.
    double step()
    {
        using Matrix = Eigen::SparseMatrix<double>;
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd wanted(std::ssize(m_conditions));
        for (std::size_t c = 0; c < m_conditions.size(); ++c) {
            wanted[static_cast<Eigen::Index>(c)] = -differenceOf(m_conditions[c]);
            addDerivatives(m_conditions[c].side, 1, static_cast<int>(c), entries);
            if (m_conditions[c].sewn)
                addDerivatives(m_conditions[c].other, -1, static_cast<int>(c), entries);
        }
        Matrix rows(std::ssize(m_conditions), 2 * m_points);
        rows.setFromTriplets(entries.begin(), entries.end());
        Matrix system = rows * Matrix(rows.transpose());
        const double most = system.nonZeros() > 0 ? system.diagonal().maxCoeff() : 0;
        Matrix little(system.rows(), system.cols());
        little.setIdentity();
        system += hardlySolvable * std::max(most, 1.0) * little;
        const Eigen::SimplicialLDLT<Matrix> factor(system);
        if (factor.info() != Eigen::Success)
            return 0;
        const Eigen::VectorXd moves = rows.transpose() * factor.solve(wanted);
        double farthestMove = 0;
        for (Eigen::Index k = 0; k < m_points; ++k)
            farthestMove = std::max(farthestMove, moves.segment<2>(2 * k).norm());
        if (farthestMove <= farthestPoint)
            move(moves);
        return farthestMove;
    }

private:
    struct Side {
        std::size_t piece = 0, row = 0;
    };
    struct Condition {
        Side side, other;
        bool sewn = false;
        double length = 0; ///< mm: to be kept where it is not sewn
    };

    void number(std::size_t p)
    {
        const std::vector<BSpline2>& curves = m_pieces[p].curves;
        std::vector<Freedoms>& numbers = m_numbers.emplace_back();
        const int first = m_points;
        m_points += static_cast<int>(curves.size()); // the corners
        for (std::size_t c = 0; c < curves.size(); ++c) {
            Freedoms& mine = numbers.emplace_back();
            mine.begin = first + static_cast<int>(c);
            mine.end = first + static_cast<int>((c + 1) % curves.size());
            mine.straight = lieOnALine(curves[c].points());
            mine.inner = m_points;
            if (!mine.straight)
                m_points += curves[c].pointCount() - 2;
        }
    }

    void measure(std::size_t p)
    {
        for (std::size_t c = 0; c < m_lengths[p].size(); ++c)
            m_lengths[p][c] = ArcLength2(m_pieces[p].curves[c]).total();
    }

    std::size_t endOf(const Side& side) const
    {
        const PieceCurves& piece = m_pieces[side.piece];
        return side.row + 1 < piece.rows.size() ? piece.rows[side.row + 1] : piece.curves.size();
    }

    double lengthOf(const Side& side) const
    {
        double length = 0;
        for (std::size_t c = m_pieces[side.piece].rows[side.row]; c < endOf(side); ++c)
            length += m_lengths[side.piece][c];
        return length;
    }

    double differenceOf(const Condition& condition) const
    {
        return lengthOf(condition.side) - (condition.sewn ? lengthOf(condition.other) : condition.length);
    }

    void addCondition(std::size_t p, std::size_t r)
    {
        const BorderRow& row = m_form.pieces[p].rows[r];
        const bool sewn = row.isSewn() && !m_pieces[p].isShut(r) && !m_pieces[row.matePiece].curves.empty();
        Condition condition{{p, r}, {}, sewn, 0};
        if (condition.sewn) {
            condition.other = {static_cast<std::size_t>(row.matePiece), static_cast<std::size_t>(row.mateRow)};
            if (std::pair(condition.other.piece, condition.other.row) <= std::pair(p, r))
                return; // the other side has it; what is sewn to itself always fits
        } else {
            condition.length = lengthOf(condition.side);
        }
        m_conditions.push_back(condition);
    }

    void addDerivatives(const Side& side, double sign, int condition,
                        std::vector<Eigen::Triplet<double>>& entries) const
    {
        for (std::size_t c = m_pieces[side.piece].rows[side.row]; c < endOf(side); ++c) {
            const BSpline2& curve = m_pieces[side.piece].curves[c];
            const Freedoms& numbers = m_numbers[side.piece][c];
            const auto add = [&](int point, const Vec2& derivative) {
                entries.emplace_back(condition, 2 * point, sign * derivative.x());
                entries.emplace_back(condition, 2 * point + 1, sign * derivative.y());
            };
            if (numbers.straight) {
                const Vec2 way = (curve.points().back() - curve.points().front()).normalized();
                add(numbers.begin, -way);
                add(numbers.end, way);
                continue;
            }
            for (int k = 0; k < curve.pointCount(); ++k)
                add(k == 0                        ? numbers.begin
                    : k + 1 == curve.pointCount() ? numbers.end
                                                  : numbers.inner + k - 1,
                    derivative(curve, k));
        }
    }

    /// Of the curve's length by a control point.
    static Vec2 derivative(const BSpline2& curve, int k)
    {
        Vec2 result;
        for (int axis = 0; axis < 2; ++axis) {
            std::array<double, 2> lengths{};
            for (const int way : {0, 1}) {
                std::vector<Vec2> points = curve.points();
                points[k][axis] += way == 0 ? -differences : differences;
                lengths[way] =
                    ArcLength2(BSpline2(curve.degree(), false, std::move(points), curve.knots())).total();
            }
            result[axis] = (lengths[1] - lengths[0]) / (2 * differences);
        }
        return result;
    }

    void move(const Eigen::VectorXd& moves)
    {
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            for (std::size_t c = 0; c < m_pieces[p].curves.size(); ++c) {
                BSpline2& curve = m_pieces[p].curves[c];
                const Freedoms& numbers = m_numbers[p][c];
                const Vec2 begin = moves.segment<2>(2 * numbers.begin), end = moves.segment<2>(2 * numbers.end);
                std::vector<Vec2> points = curve.points();
                const Vec2 from = points.front(), way = points.back() - from;
                for (int k = 0; k < curve.pointCount(); ++k) {
                    if (k == 0 || k + 1 == curve.pointCount())
                        points[k] += k == 0 ? begin : end;
                    else if (numbers.straight)
                        points[k] += begin + (points[k] - from).dot(way) / way.squaredNorm() * (end - begin);
                    else
                        points[k] += moves.segment<2>(2 * (numbers.inner + k - 1));
                }
                curve = BSpline2(curve.degree(), false, std::move(points), curve.knots());
            }
            measure(p);
        }
    }

    const Form& m_form;
    std::vector<PieceCurves>& m_pieces;
    int m_points = 0;
    Numbers m_numbers;
    std::vector<std::vector<double>> m_lengths; // mm, of each curve
    std::vector<Condition> m_conditions;
};

} // namespace

void makeSidesEqual(const Form& form, std::vector<PieceCurves>& pieces, const std::stop_token& stop)
{
    const std::vector<PieceCurves> before = pieces;
    Sides sides(form, pieces);
    double way = 0;
    for (int round = 0; round < sideRounds && sides.difference() > equal && way <= farthestPoint; ++round)
        way += stop.stop_requested() ? 2 * farthestPoint : sides.step();
    if (way > farthestPoint || !std::isfinite(way))
        pieces = before;
}

} // namespace bolster
