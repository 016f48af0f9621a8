// The design of a form that was laid flat: outlines, seams, fixation curves.
#pragma once

#include "Design.h"
#include "Flatten.h"

#include <algorithm>

namespace bolster {

/// Where the grain line of the pieces goes.
struct FormGrain {
    Vec3 along = Vec3::Zero(); ///< a direction on the form; zero: all as the angle says
    double angle = 90;         ///< degrees in the pattern, counter-clockwise, as pieces are turned when laid flat;
                               ///< also of pieces that the direction crosses

    static FormGrain up() { return {}; } ///< as pieces are turned
    static FormGrain back() { return {Vec3::UnitY(), 90}; }
    static FormGrain side() { return {Vec3::UnitX(), 0}; }
};

struct FormPatternOrder {
    double tolerance = 0.2; ///< mm, of outlines and fixation curves
    Fabric fabric;
    FormGrain grain;
    double edgeLength = 12; ///< of the design, mm
    bool twins = true;      ///< pieces that are each other's mirror image at x = 0 become twins
    double hardEdge = 20;   ///< degrees: seams that bend by less are rounded (G1)
};

/// A seam of the design that was made, and how long its sides are, mm.
struct FormSeam {
    ElementId seam = noElement;
    double first = 0, second = 0;
};

struct FormPattern {
    Design design;
    std::vector<ElementId> patches; ///< of each piece; none where it could not be made
    std::vector<FormSeam> seams;
    std::vector<Message> notes; ///< pieces that are left out, and why
    bool hasClosed = false;     ///< something is closed all around: held along its seams alone its cover may turn
                                ///< inside out, where no frame keeps it outside
    /// mm: sides of a seam that differ by less are equal to whoever sews them.
    static constexpr double equallyLong = 0.01;
    /// Of a cover: more take their time.
    static constexpr double manyVertices = 60'000;

    std::vector<Message> advice; ///< why its cover will not be like the form, and what to do about that

    /// All is left out.
    bool isEmpty() const { return std::ranges::count(patches, noElement) == std::ssize(patches); }
};

/// Each piece becomes a patch with corners where its seams meet and where its outline turns sharply; each row of
/// edges that two pieces have in common a seam; each row at the form's border a fixation curve with its fixation.
/// When stopped it is not whole.
FormPattern formPattern(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                        const std::stop_token& stop = {});

/// Whether it makes a patch of each piece: nothing is sewn or held for that.
std::vector<bool> becomePatches(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
                                const std::stop_token& stop = {});

} // namespace bolster
