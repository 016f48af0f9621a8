// What is said of each field of a twin's link.
#pragma once

#include "Field.h"
#include "Twin.h"

namespace bolster {

struct AnyKind; // that of the element itself

template <>
struct Description<Twin> {
    static constexpr const char* section = "see [twins](#twins)";
    template <class V, class... S>
    static void of(V& v, S&... s)
    {
        v.field({.key = "of",
                 .meaning =
                     "the other one, the original, which is of the same kind, has no `twin` itself, and no other "
                     "follower",
                 .presence = Presence::Required},
                Refers<AnyKind>{Need::Linked}, s.of...);
        v.field({.key = "released",
                 .meaning =
                     "numbers of points, 0 the first, of both curves that go their own ways; those of a handle's "
                     "`target` are numbered from 10,000"},
                PointNumbers{}, s.released...);
    }
};

inline constexpr Field twinField{.key = "twin",
                                 .label = QT_TRANSLATE_NOOP("Field", "Mirror twin"),
                                 .without = QT_TRANSLATE_NOOP("Field", "none")};

} // namespace bolster
