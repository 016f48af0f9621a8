// What the mirror shows of seams, fixations, trims, and what is drawn in patches. Private to the library.
#pragma once

#include "Design.h"
#include "PatchMark.h"

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
    /// The same place on the twin.
    std::optional<OutlinePlace> of(const OutlinePlace& place) const;
    std::optional<PatchPoint> of(const PatchPoint& point) const;
    /// Of marks on patches with a twin.
    template <PatchMark T>
    std::optional<T> of(const T& mark) const;

    /// Whether two stretches are the same place. On patches without twins, ends may differ by 2 mm.
    bool same(const Stretch& a, const Stretch& b) const;
    bool same(const OutlinePlace& a, const OutlinePlace& b) const;
    bool same(const PatchPoint& a, const PatchPoint& b) const;

    struct Counterpart {
        ElementId id = noElement; ///< noElement: there is none
        bool swapped = false;     ///< the first side of one is the second of the other
    };
    /// The seam where the mirror shows this one; itself when it is its own mirror image.
    Counterpart counterpart(const Seam& seam) const;
    Counterpart counterpart(const FixationSeam& fixation) const;
    template <PatchMark T>
    Counterpart counterpart(const T& mark) const;

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

template <PatchMark T>
std::optional<T> SewnMirror::of(const T& mark) const
{
    const auto& where = whereOf(mark);
    if (twin(where.patch) == noElement)
        return std::nullopt;
    T result = mark;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(where)>, Stretch>) {
        const auto image = of(where);
        if (!image)
            return std::nullopt;
        whereOf(result) = image->stretch;
    } else {
        const auto image = of(where);
        if (!image)
            return std::nullopt;
        whereOf(result) = *image;
    }
    return result;
}

template <PatchMark T>
SewnMirror::Counterpart SewnMirror::counterpart(const T& mark) const
{
    Counterpart result;
    const auto image = of(mark);
    if (!image)
        return result;
    m_design.each<T>([&](ElementId id, const T& other) {
        if (result.id == noElement && same(whereOf(other), whereOf(*image)))
            result.id = id;
    });
    return result;
}

/// The curve drawn in another patch, as the mirror shows it, without a link; null when it would be too large.
ElementPtr mirroredDrawn(const Element& drawn, ElementId patch, const Symmetry& symmetry);

} // namespace bolster::edits
