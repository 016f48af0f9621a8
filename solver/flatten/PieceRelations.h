// How the pieces of a form are to each other. Private to the library.
#pragma once

#include "Form.h"

#include <array>
#include <vector>

namespace bolster {

/// Pieces are meant by their numbers. The form outlives this. For one thread.
class PieceRelations {
public:
    explicit PieceRelations(const Form& form);

    /// The pieces that hang together have one number, 0, 1, ...
    int group(std::size_t p) const { return m_group[p]; }
    /// What hangs together with it has no border: it is closed all around.
    bool isClosed(std::size_t p) const { return !m_open[m_group[p]]; }

    /// The angle by which the form bends across a row of a piece that is sewn, on average; degrees.
    double bendAlong(std::size_t p, const BorderRow& row) const;

    /// Whether the border of one piece, mirrored at x = 0, lies within `farthest` (mm) of that of the other one.
    bool mirrors(std::size_t p, std::size_t q, double farthest) const;

private:
    const FormPiece& piece(std::size_t p) const { return m_form.pieces[p]; }
    const Vec3& formPoint(std::size_t p, std::size_t k) const
    {
        return m_form.points[piece(p).points[piece(p).border[k]]];
    }
    Vec3 normalBeside(std::size_t p, std::size_t edge) const;
    const std::vector<std::array<int, 3>>& trianglesAt(std::size_t p, int vertex) const;

    const Form& m_form;
    std::vector<int> m_group;                                                   // of each piece
    std::vector<bool> m_open;                                                   // of each group: it has a border
    mutable std::vector<std::vector<std::vector<std::array<int, 3>>>> m_around; // of each vertex of each piece
};

} // namespace bolster
