// What the mirror shows of seams, fixations, trims, and what is drawn in patches. Private to the library.
#pragma once

#include "Design.h"

#include <map>

namespace bolster::edits {

/// Looks at one design, which must outlive it, with these twins (originals by follower).
class SewnMirror {
public:
    using Pairs = std::map<ElementId, ElementId>;

    SewnMirror(const Design& design, const Pairs& pairs);

    /// noElement when it has none.
    ElementId twin(ElementId id) const;

    struct Image {
        Stretch stretch;
        bool backwards = false; ///< it is walked the other way round
    };
    /// The same parameters on the twin; or the other side of a patch that is its own mirror image (within 1 mm).
    std::optional<Image> of(const Stretch& stretch) const;
    /// At least one of the patches must have a twin; also the fixed one, while a curve may be its own mirror image.
    std::optional<Seam> of(const Seam& seam) const;
    std::optional<FixationSeam> of(const FixationSeam& fixation) const;
    std::optional<OutlineTrim> of(const OutlineTrim& trimmed) const;

    /// Whether two stretches are the same place. On patches without twins, ends may differ by 2 mm.
    bool same(const Stretch& a, const Stretch& b) const;

    struct Counterpart {
        ElementId id = noElement; ///< noElement: there is none
        bool swapped = false;     ///< the first side of one is the second of the other
    };
    /// The seam where the mirror shows this one; itself when it is its own mirror image.
    Counterpart counterpart(const Seam& seam) const;
    Counterpart counterpart(const FixationSeam& fixation) const;
    Counterpart counterpart(const OutlineTrim& trimmed) const;

    /// Whether all points on those stretches that lie on twins go their own ways: then the seam does, too.
    bool released(const Element& sewn) const;

private:
    const Design& m_design;
    Pairs m_twins;     // both ways
    Pairs m_originals; // by follower
};

/// The twins of a design that are twins in another one, too; of fixation curves all, because what is fixed anew may
/// need new ones.
SewnMirror::Pairs heldPairs(const Design& design, const Design& other);

/// No stretches for other kinds than seams, fixations and outline trims.
std::vector<Stretch> stretchesOf(const Element& element);

/// The curve drawn in another patch, as the mirror shows it, without a link; null when it would be too large.
ElementPtr mirroredDrawn(const Element& drawn, ElementId patch, const Symmetry& symmetry);

} // namespace bolster::edits
