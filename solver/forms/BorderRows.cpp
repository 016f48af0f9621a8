#include "BorderRows.h"

#include <set>

namespace bolster {

namespace {

class RowFinder {
public:
    explicit RowFinder(Form& form)
        : m_form(form)
    {}

    void find()
    {
        for (const FormPiece& piece : m_form.pieces)
            findBreaks(piece);
        for (FormPiece& piece : m_form.pieces)
            divide(piece);
        for (FormPiece& piece : m_form.pieces)
            for (BorderRow& row : piece.rows)
                findMate(piece, row);
    }

private:
    /// The mate of the next edge is the one before this one's mate; but not where a cut ends inside a piece.
    bool goesOn(const FormPiece& piece, std::size_t edge) const
    {
        const EdgeMate &here = piece.mates[edge], &next = piece.mates[piece.after(edge)];
        if (!here.none() && &m_form.pieces[here.piece] == &piece &&
            static_cast<std::size_t>(here.edge) == piece.after(edge))
            return false;
        if (here.none() || next.none())
            return here.none() && next.none();
        return here.piece == next.piece &&
               m_form.pieces[here.piece].before(here.edge) == static_cast<std::size_t>(next.edge);
    }

    static int pointAt(const FormPiece& piece, std::size_t k) { return piece.points[piece.border[k]]; }

    /// Points of the form at which rows end on whichever border they lie.
    void findBreaks(const FormPiece& piece)
    {
        bool any = false;
        for (std::size_t k = 0; k < piece.border.size(); ++k)
            if (!goesOn(piece, k)) {
                m_breaks.insert(pointAt(piece, piece.after(k)));
                any = true;
            }
        if (any || piece.border.empty())
            return;
        m_breaks.insert(pointAt(piece, 0));
        m_breaks.insert(pointAt(piece, piece.border.size() / 2));
    }

    void divide(FormPiece& piece) const
    {
        const std::size_t count = piece.border.size();
        std::size_t start = 0;
        while (start < count && !m_breaks.contains(pointAt(piece, start)))
            ++start;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t edge = (start + k) % count;
            if (k == 0 || m_breaks.contains(pointAt(piece, edge)))
                piece.rows.push_back({edge, 0, -1, -1});
            ++piece.rows.back().count;
        }
    }

    /// Its last edge is sewn to the first one of the other row.
    void findMate(const FormPiece& piece, BorderRow& row) const
    {
        const EdgeMate& mate = piece.mates[(row.first + row.count - 1) % piece.border.size()];
        if (mate.none())
            return;
        const std::vector<BorderRow>& rows = m_form.pieces[mate.piece].rows;
        for (int r = 0; r < std::ssize(rows); ++r)
            if (rows[r].first == static_cast<std::size_t>(mate.edge)) {
                row.matePiece = mate.piece;
                row.mateRow = r;
            }
    }

    Form& m_form;
    std::set<int> m_breaks; // points of the form
};

} // namespace

void findRows(Form& form)
{
    RowFinder(form).find();
}

} // namespace bolster
