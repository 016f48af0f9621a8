// The outlines of a form's pieces, as they are laid flat. Private to the library.
#pragma once

#include "Flatten.h"
#include "SeamSides.h"

#include <stop_token>
#include <vector>

namespace bolster {

/// Smooth outlines with corners where seams meet and where a border turns sharply, flat or on the form. Cuts that
/// lie edge to edge are drawn apart a little, sides that are sewn to each other are equally long, and no outline
/// crosses itself. Pieces are meant by their numbers, places of a piece's border by theirs. The form outlives this.
class PieceOutlines {
public:
    /// `tolerance` in mm. When stopped what there is means nothing.
    PieceOutlines(const Form& form, std::vector<FlatPiece> flat, double tolerance, const std::stop_token& stop);

    /// Closed, counter-clockwise, mm; empty where the piece is left out.
    const BSpline2& outline(std::size_t p) const { return m_joined[p].outline; }
    /// The parameters of the outline at which the piece's rows begin.
    std::vector<double> rowStarts(std::size_t p) const;

    /// The pieces with their cuts drawn apart.
    const std::vector<FlatPiece>& flat() const { return m_flat; }

    /// Pieces that are left out, and why.
    const std::vector<Message>& notes() const { return m_notes; }

    /// Whether the outline has a corner there.
    bool isCorner(std::size_t p, std::size_t k) const;
    /// Where a border goes over a crease of the form; laid flat it may be straight there.
    bool turnsOnForm(std::size_t p, std::size_t k) const;

private:
    /// An outline, and where the curves begin that it is made of.
    struct Joined {
        BSpline2 outline; ///< empty where they make none
        std::vector<double> starts;
    };

    bool goesOn(std::size_t p) const { return p < m_form.pieces.size() && !m_stop.stop_requested(); }
    const FormPiece& piece(std::size_t p) const { return m_form.pieces[p]; }
    const Vec3& formPoint(std::size_t p, std::size_t k) const
    {
        return m_form.points[piece(p).points[piece(p).border[k]]];
    }
    const Vec2& flatPoint(std::size_t p, std::size_t k) const { return m_flat[p].at[piece(p).border[k]]; }
    std::vector<Vec2> flatPoints(std::size_t p, const std::vector<std::size_t>& places) const;

    bool beginsRow(std::size_t p, std::size_t k) const;
    double flatTurn(std::size_t p, std::size_t k) const;
    bool standsAlone(std::size_t p, std::size_t k) const;

    void makeCurves(std::size_t p);
    void fitCurves(std::size_t p);
    PieceCurves curvesOf(std::size_t p) const;
    std::size_t otherSide(std::size_t p, std::size_t k) const;
    BSpline2 besideOtherSide(std::size_t p, std::vector<std::size_t> places) const;
    bool isThere(std::size_t p) const { return !m_outlines[p].curves.empty(); }
    void joinCurves();
    static Joined joined(const PieceCurves& curves);
    double widthOf(std::size_t p) const;
    void leaveOut(std::size_t p);

    const Form& m_form;
    std::vector<FlatPiece> m_flat;
    std::stop_token m_stop;
    std::vector<PieceCurves> m_outlines;      // of each piece
    std::vector<Joined> m_joined;             // of each piece
    std::vector<double> m_tolerances;         // of each piece's outline, mm
    std::vector<std::vector<double>> m_rooms; // of each place of its border: how far a cut there may open, mm
    std::vector<Message> m_notes;
};

} // namespace bolster
