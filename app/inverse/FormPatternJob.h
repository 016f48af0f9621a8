// The pattern of a form, beside the window.
#pragma once

#include "Flatten.h"
#include "FormPattern.h"

#include <QString>

#include <memory>

namespace bolster {

struct FormWanted {
    int number = 0;
    std::shared_ptr<const TriangleMesh> mesh; ///< mm; null: that of the file
    QString file;                             ///< its unit and axes are guessed where it does not say them
    FormCuts cuts;
    FormPatternOrder order;
    bool draft = false; ///< something moves: nearly right, soon
};

struct FormMade {
    int number = 0;
    bool draft = false;
    Message problem;
    std::optional<Vec3> size; ///< mm, of the form of a file
    Form form;
    std::vector<FlatPiece> flat;
    FormPattern pattern;
};

/// `draft`: always the same one; that of the answer is that of the wish.
FormMade patternOfForm(const FormWanted& wanted, FormDraft& draft, const std::stop_token& stop);

} // namespace bolster
