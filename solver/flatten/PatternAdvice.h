// Why the cover of a form's pattern will not be like the form. Private to the library.
#pragma once

#include "FormPattern.h"

namespace bolster {

/// What keeps the cover from being like the form, and what to do about that: it is held nowhere, or only at a small
/// hole; pieces are too small for its triangles, or too wide for the fabric; the form is too large to be solved;
/// pieces are strained by more than any fabric bears. Of a pattern that is whole, with its design and patches;
/// `flat` has the pieces as they are in it.
std::vector<Message> patternAdvice(const Form& form, const std::vector<FlatPiece>& flat,
                                   const FormPatternOrder& order, const FormPattern& pattern);

} // namespace bolster
