// How the lengths of a seam's two sides match.
#pragma once

#include "Design.h"

#include <QString>

namespace bolster {

struct SeamEase {
    double a = 0;      ///< length of the first side, mm; 0 when it does not lie on its outline
    double b = 0;      ///< of the second side
    double wanted = 0; ///< mm: by so much the second side shall be longer

    bool known() const { return a > 0 && b > 0; }
    /// mm; positive when the second side is longer, as Seam::ease.
    double difference() const { return b - a; }
    /// The difference over the shorter side, with its sign.
    double ratio() const;
    /// More than cloth can take up without folds, beyond what is wanted.
    bool puckers() const;

    /// "+12.5 mm"; "" when not known.
    QString differenceText() const;
    /// "+2.4 %"
    QString ratioText() const;
};

SeamEase seamEaseOf(const Design& design, const Seam& seam);

} // namespace bolster
