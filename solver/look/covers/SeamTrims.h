// Stitches and piping of a design on its cover.
#pragma once

#include "Design.h"
#include "RefinedPlaces.h"
#include "TrimMesh.h"

#include <optional>
#include <stop_token>

namespace bolster {

/// Keeps where stitches and piping lie in the pattern: while only the cover moves the next mesh costs positions
/// alone. Not to be used by two threads at once.
class SeamTrims {
public:
    /// Whether a design has stitches or piping.
    static bool any(const Design& design);
    /// Null when no seam has any, or when it was stopped. What belongs to patches that the cover does not have is
    /// left out.
    TrimMeshPtr make(const Design& design, const CoverMesh& cover, const std::stop_token& stop = {});

private:
    /// A run of stitches: stitchPoints places each.
    struct Row {
        ElementId element{};
        ElementId patch{};
        std::vector<PatternPlace> places;
    };
    /// What a pipe follows: the places of one side, and of the other one of a seam.
    struct Pipe {
        ElementId element{};
        ElementId patch{}, other{};
        bool closed = false;
        std::vector<PatternPlace> places, otherSide;
    };

    bool prepared(const Design& design, const CoverMesh& cover) const;
    void prepare(const Design& design, const CoverMesh& cover, const std::stop_token& stop);
    void addRows(const Design& design, ElementId id, const Element& element);
    void addPipe(const Design& design, ElementId id, const Element& element);
    void skinRow(const Design& design, const CoverMesh& cover, const Row& row, TrimMesh& to) const;
    void skinPipe(const Design& design, const CoverMesh& cover, const Pipe& pipe, TrimMesh& to) const;

    std::optional<RefinedPlaces> m_places;
    std::vector<ElementPtr> m_of; ///< the elements that the rows were made of
    std::vector<Row> m_rows;
    std::vector<Pipe> m_pipes;
};

} // namespace bolster
