#include "OpenCuts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr double openCut = 0.36;   // mm between the sides of a cut
constexpr double openWithin = 20;  // mm from its end on
constexpr double longerSide = 0.1; // mm: of what opens

// Of one piece.
class CutOpener {
public:
    CutOpener(const FormPiece& piece, std::size_t number, FlatPiece& flat)
        : m_piece(piece)
        , m_number(static_cast<int>(number))
        , m_flat(flat)
    {}

    /// Of each place of the border, mm.
    std::vector<double> open()
    {
        std::vector<double> rooms(m_piece.border.size(), openCut);
        std::vector<Vec2> moves = apartAtCuts(rooms);
        for (std::size_t r = 0; r < m_piece.rows.size(); ++r) {
            const BorderRow& row = m_piece.rows[r];
            if (row.matePiece != m_number)
                continue;
            const double longer = lengthWith(r, moves) - lengthWith(row.mateRow, moves);
            const double room = openCut * std::min(1.0, longerSide / std::max(std::abs(longer), 1e-9));
            for (std::size_t k = 0; k <= row.count; ++k) {
                double& there = rooms[(row.first + k) % rooms.size()];
                there = std::min(there, room);
            }
        }
        if (std::ranges::min(rooms) < openCut)
            moves = apartAtCuts(rooms);
        for (std::size_t k = 0; k < moves.size(); ++k)
            m_flat.at[m_piece.border[k]] += moves[k];
        return rooms;
    }

private:
    const Vec2& flatPoint(std::size_t k) const { return m_flat.at[m_piece.border[k]]; }
    bool isCutEdge(std::size_t k) const { return m_piece.mates[k].piece == m_number; }

    /// How far it is along the cut to where it ends inside the piece, of each place of the border; infinite where
    /// there is no such end.
    std::vector<double> distancesToTips() const
    {
        const std::size_t count = m_piece.border.size();
        std::vector<double> distances(count, std::numeric_limits<double>::infinity());
        for (std::size_t tip = 0; tip < count; ++tip)
            if (isCutEdge(tip) && m_piece.mates[tip].edge == static_cast<int>(m_piece.before(tip)))
                distances[tip] = 0; // what comes before the end of a cut is sewn to what comes after it
        const auto goAlong = [&](std::size_t edge, std::size_t from, std::size_t to) {
            if (isCutEdge(edge))
                distances[to] = std::min(distances[to], distances[from] + (flatPoint(to) - flatPoint(from)).norm());
        };
        for (std::size_t k = 0; k < 2 * count; ++k) // twice around: a cut may go over the beginning
            goAlong(k % count, k % count, m_piece.after(k % count));
        for (std::size_t k = 2 * count; k-- > 0;)
            goAlong(k % count, m_piece.after(k % count), k % count);
        return distances;
    }

    /// Of a row, when its places have moved; mm.
    double lengthWith(std::size_t r, const std::vector<Vec2>& moves) const
    {
        const BorderRow& row = m_piece.rows[r];
        const auto at = [&](std::size_t k) {
            const std::size_t place = (row.first + k) % moves.size();
            return Vec2(flatPoint(place) + moves[place]);
        };
        double length = 0;
        for (std::size_t k = 0; k < row.count; ++k)
            length += (at(k + 1) - at(k)).norm();
        return length;
    }

    /// Of each place of the border, for so much room there, mm.
    std::vector<Vec2> apartAtCuts(const std::vector<double>& most) const
    {
        const std::size_t count = m_piece.border.size();
        const std::vector<double> toTip = distancesToTips();
        std::vector<Vec2> ways(count, Vec2::Zero()); // the sum of the directions into the piece that ask for room,
        std::vector<double> rooms(count, 0);         // and of how much each asks for
        const auto ask = [&](std::size_t k, std::size_t mate, const Vec2& inside) {
            const Vec2 apart = flatPoint(k) - flatPoint(mate);
            const double room = std::min(most[k], openCut / openWithin * toTip[k]) - apart.dot(inside);
            if (k == mate || room <= 0 || apart.norm() > 2 * openCut)
                return;
            ways[k] += inside;
            rooms[k] += room / 2;
        };
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = m_piece.after(k);
            const Vec2 way = flatPoint(next) - flatPoint(k);
            if (!isCutEdge(k) || !(way.norm() > 0))
                continue;
            const Vec2 inside = Vec2(-way.y(), way.x()).normalized(); // of what runs counter-clockwise
            const auto mate = static_cast<std::size_t>(m_piece.mates[k].edge);
            ask(k, m_piece.after(mate), inside);
            ask(next, mate, inside);
        }
        for (std::size_t k = 0; k < count; ++k) // where two directions ask, both get it
            ways[k] *= rooms[k] / std::max(ways[k].squaredNorm(), 0.5);
        return ways;
    }

    const FormPiece& m_piece;
    int m_number;
    FlatPiece& m_flat;
};

} // namespace

std::vector<double> openCuts(const Form& form, std::size_t p, FlatPiece& flat)
{
    return CutOpener(form.pieces[p], p, flat).open();
}

double opensWithin(double room)
{
    return openWithin / openCut * room;
}

bool liesAtOtherSide(const Form& form, std::size_t p, std::size_t row, const FlatPiece& flat)
{
    const FormPiece& piece = form.pieces[p];
    const std::vector<int>& border = piece.border;
    const std::size_t middle = (piece.rows[row].first + piece.rows[row].count / 2) % border.size();
    const EdgeMate& mate = piece.mates[middle];
    return mate.piece == static_cast<int>(p) &&
           (flat.at[border[middle]] - flat.at[border[piece.after(mate.edge)]]).norm() < 2 * openCut;
}

} // namespace bolster
