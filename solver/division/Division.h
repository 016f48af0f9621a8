// Forms that cannot be laid flat, or that the fabric would not lie on, divided until they can.
#pragma once

#include "FormPattern.h"

#include <functional>

namespace bolster {

/// The strain that a fabric bears along its grain and across it; 1.
double bearableStrain(const Fabric& fabric);

/// How many pieces that lie flat were found, some of which become one again.
using DivisionProgress = std::function<void(int pieces)>;

/// Divides pieces that are closed all around, have a handle, would lie over themselves or be strained by more than
/// the fabric bears (in more than a hundredth of their area) when they lie on the form, until there are none, or
/// they are too small for the edges of the cover. What bends sharply is parted there first. Whatever cuts the form
/// anyway stays. A piece stays as it is where it is so rough that a hundred pieces would not do, the form where
/// that is not what is wrong with it, or when stopped.
Form divided(const Form& form, const FormPatternOrder& order, const std::stop_token& stop = {},
             const DivisionProgress& progress = {});

/// Without cuts of lines that end inside a piece, if with them it would lie over itself and without them it would
/// not, as where it is hollow like a saddle; a note says so. Nothing is divided.
Form withoutClosedSlits(const Form& form, const FormPatternOrder& order, const std::stop_token& stop = {});

} // namespace bolster
