#include "ConformalStart.h"

#include "PieceSystem.h"

#include <cmath>
#include <limits>

namespace bolster {

namespace {

using Mat2 = Eigen::Matrix2d;

constexpr int mostCorrections = 8;   // of what single precision leaves
constexpr double closeEnough = 1e-7; // of the distance of what is held: a start

/// The map (u, v) keeps angles where grad v is grad u turned by 90 degrees. Unknowns are u and v of each vertex but
/// those that are held.
class ConformalSystem {
public:
    ConformalSystem(std::span<const Facet> facets, const Eigen::Matrix3Xd& places, const std::vector<int>& order,
                    std::pair<int, int> held, const std::stop_token& stop)
        : m_places(places)
        , m_order(order)
        , m_held(held)
        , m_stop(stop)
        , m_number(static_cast<std::size_t>(places.cols()), -1)
    {
        for (Eigen::Index v = 0; v < places.cols(); ++v)
            if (v != held.first && v != held.second)
                m_number[v] = 2 * m_free++;
        assemble(facets);
    }

    Eigen::MatrixX2d solve() const
    {
        Eigen::MatrixX2d at = Eigen::MatrixX2d::Zero(m_places.cols(), 2);
        at.row(m_held.second) = Eigen::RowVector2d(apart(), 0);
        PieceSystem system(m_matrix, orderOfUnknowns(), m_stop);
        if (!system.factor(m_matrix, bent(), m_stop)) {
            at.setConstant(std::numeric_limits<double>::quiet_NaN());
            return at;
        }
        const Eigen::VectorXd solved = corrected(system);
        for (Eigen::Index v = 0; v < m_places.cols(); ++v)
            if (m_number[v] >= 0)
                at.row(v) = solved.segment<2>(m_number[v]).transpose();
        return at;
    }

private:
    double apart() const { return (m_places.col(m_held.second) - m_places.col(m_held.first)).norm(); }

    void assemble(std::span<const Facet> facets)
    {
        std::vector<Eigen::Triplet<double>> lower;
        m_right = Eigen::VectorXd::Zero(2 * m_free);
        for (const Facet& facet : facets)
            for (int i = 0; i < 3 && !m_stop.stop_requested(); ++i) {
                const int row = m_number[facet.corners[i]];
                for (int j = 0; j < 3 && row >= 0; ++j)
                    add(row, facet.corners[j], block(facet, i, j), lower);
            }
        m_matrix.resize(2 * m_free, 2 * m_free);
        m_matrix.setFromTriplets(lower.begin(), lower.end());
    }

    static Mat2 block(const Facet& facet, int i, int j)
    {
        const Vec2 a = facet.gradient.col(i), b = facet.gradient.col(j);
        const double dot = facet.weight * a.dot(b), cross = facet.weight * (a.x() * b.y() - a.y() * b.x());
        return (Mat2() << dot, -cross, cross, dot).finished();
    }

    void add(int row, int vertex, const Mat2& block, std::vector<Eigen::Triplet<double>>& lower)
    {
        if (vertex == m_held.second)
            m_right.segment<2>(row) -= apart() * block.col(0);
        const int column = m_number[vertex];
        for (int r = 0; r < 2 && column >= 0; ++r)
            for (int c = 0; c < 2; ++c)
                if (row + r >= column + c)
                    lower.emplace_back(row + r, column + c, block(r, c));
    }

    std::vector<int> orderOfUnknowns() const
    {
        std::vector<int> order;
        order.reserve(2 * m_order.size());
        for (const int v : m_order)
            if (m_number[v] >= 0)
                order.insert(order.end(), {m_number[v], m_number[v] + 1});
        return order;
    }

    /// The square of a complex number is a conformal map: bent like that the system hardly resists.
    Eigen::MatrixXd bent() const
    {
        const Vec3 from = m_places.col(m_held.first), along = (m_places.col(m_held.second) - from) / apart();
        Eigen::MatrixXd places(2 * m_free, 1);
        for (Eigen::Index v = 0; v < m_places.cols(); ++v) {
            if (m_number[v] < 0)
                continue;
            const Vec3 way = m_places.col(v) - from;
            const double x = way.dot(along) / apart(), y = (way - way.dot(along) * along).norm() / apart();
            places.middleRows<2>(m_number[v]) << x * x - y * y, 2 * x * y;
        }
        return places;
    }

    Eigen::VectorXd corrected(PieceSystem& system) const
    {
        Eigen::VectorXd solved = Eigen::VectorXd::Zero(2 * m_free), left = m_right;
        for (int round = 0; round < mostCorrections && !m_stop.stop_requested(); ++round) {
            const Eigen::VectorXd step = system.solve(left);
            solved += step;
            if (!(step.cwiseAbs().maxCoeff() > closeEnough * apart()))
                break;
            left = m_right - m_matrix.selfadjointView<Eigen::Lower>() * solved;
        }
        return solved;
    }

    const Eigen::Matrix3Xd& m_places;
    const std::vector<int>& m_order; // of vertices
    std::pair<int, int> m_held;
    const std::stop_token& m_stop;
    std::vector<int> m_number; // of a vertex' u; v is the next
    int m_free = 0;            // vertices
    Eigen::SparseMatrix<double> m_matrix;
    Eigen::VectorXd m_right;
};

} // namespace

Eigen::MatrixX2d conformalStart(std::span<const Facet> facets, const Eigen::Matrix3Xd& places,
                                const std::vector<int>& order, std::pair<int, int> held,
                                const std::stop_token& stop)
{
    return ConformalSystem(facets, places, order, held, stop).solve();
}

} // namespace bolster
