// Outlines cut into pieces at corners and stretch ends; the first half of OutlineSampling.
#pragma once

#include "ArcLength.h"
#include "Design.h"

#include <map>
#include <memory>
#include <vector>

namespace bolster {

/// One cut of an outline.
struct Cut {
    double s = 0; ///< arc length from the domain's start, within [0, total), mm
    double t = 0; ///< parameter
};

/// An outline with its cuts, by increasing arc length. Piece k runs from cut k to the next one.
struct CutOutline {
    ElementId patch{};
    const BSpline2* curve = nullptr;
    ArcLength2 length;
    std::vector<Cut> cuts;

    CutOutline(ElementId id, const BSpline2& outline)
        : patch(id)
        , curve(&outline)
        , length(outline)
    {}

    double total() const { return length.total(); }
    int pieceCount() const { return static_cast<int>(cuts.size()); }
    std::pair<double, double> pieceLengths(int piece) const;    ///< arc lengths of the ends, unwrapped
    std::pair<double, double> pieceParameters(int piece) const; ///< parameters of the ends, unwrapped
    /// The nearest cut within the tolerance (mm), or -1.
    int near(double s, double tolerance) const;
    /// Adds a cut unless one lies within the tolerance (mm). Returns whether it did.
    bool add(double t, double tolerance);

private:
    double wrap(double s) const;
};

/// A stretch of an outline in unwrapped parameter and arc length.
struct OutlineSpan {
    int outline = 0;
    double t0 = 0, t1 = 0;
    double s0 = 0, s1 = 0;
};

/// A walked part of a fixation curve, or the whole target of a handle.
struct CurveSpan {
    const BSpline3* curve = nullptr;
    std::shared_ptr<const ArcLength3> length;
    double t0 = 0, t1 = 0;

    CurveSpan(const Design& design, const FixationSeam& fixation);
    explicit CurveSpan(const BSpline3& whole);
    double parameterAt(double fraction, Match match) const;
    double fractionOf(double t, Match match) const;
};

struct SeamSpans {
    ElementId id{};
    const Seam* seam = nullptr;
    OutlineSpan a, b;
};

struct FixationSpan {
    ElementId id{};
    const FixationSeam* fixation = nullptr;
    OutlineSpan span;
};

/// All outlines of a design with their cuts, and where its seams and fixations run on them. The design must outlive
/// it.
class OutlineCuts {
public:
    /// One cut of a stretch, with its place along it: a fraction of arc length or of the parameter.
    struct Along {
        int cut = 0;
        double fraction = 0;
    };

    /// Knows the spans; makes no cuts yet.
    explicit OutlineCuts(const Design& design);

    /// A line inside a patch that ends at its outline. A cut within `reach` (mm) of it is its end.
    struct LineEnd {
        int outline = 0;
        double t = 0;
        double reach = 0;
    };

    /// Cuts at corners, stretch ends, corners of fixation curves and line ends, and carries the cuts across the
    /// seams until both sides of each have the same. Returns what could not be matched.
    Problems cut(const std::vector<LineEnd>& lineEnds = {});

    const std::vector<CutOutline>& outlines() const { return m_outlines; }
    const std::vector<SeamSpans>& seams() const { return m_seams; }
    const std::vector<FixationSpan>& fixations() const { return m_fixations; }       ///< those with a curve
    const std::vector<FixationSpan>& orientations() const { return m_orientations; } ///< those with directions
    int outlineOf(ElementId patch) const { return m_index.at(patch); }
    double edgeLength() const { return m_edge; }
    /// The cuts of a stretch, both ends included, in increasing parameter, or backwards.
    std::vector<Along> along(const OutlineSpan& span, Match match, bool backwards = false) const;

private:
    OutlineSpan span(const Stretch& stretch) const;
    Problems strayStretches() const;
    void cutAtCornersAndEnds();
    void cutAtCurveCorners(const FixationSpan& fixation);
    static std::vector<std::size_t> partners(const std::vector<Along>& from, const std::vector<Along>& to,
                                             double near);
    bool carry(const SeamSpans& seam, bool forward);
    double parameterAt(const OutlineSpan& span, double fraction, Match match) const;
    Problem problem(ElementId id, const char* field, const char* sentence) const;

    const Design& m_design;
    double m_edge;
    std::map<ElementId, int> m_index;
    std::vector<CutOutline> m_outlines; // by increasing patch id
    std::vector<SeamSpans> m_seams;
    std::vector<FixationSpan> m_fixations;
    std::vector<FixationSpan> m_orientations;
};

} // namespace bolster
