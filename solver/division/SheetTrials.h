// Sheets tried: cut out of their form, laid flat, made into patches. Private to the library.
#pragma once

#include "FormPattern.h"
#include "FormSheet.h"

#include <stop_token>
#include <vector>

namespace bolster {

/// While sheets are divided, many are tried: nearly right, soon.
inline constexpr FlattenOrder trialFlattening{0.3, 120, 0.02};

/// Degrees: what bends by more parts pieces.
inline constexpr double creaseBend = 50;

/// What sheets are tried by. A small one is not divided; its side is that of so many edges of the cover.
class SheetTrials {
public:
    SheetTrials(FormCuts cuts, const FormPatternOrder& order, const std::stop_token& stop);

    FormCuts cuts;

    const std::stop_token& stop() const { return m_stop; }
    bool isStopped() const { return m_stop.stop_requested(); }
    double edgeLength() const { return m_order.edgeLength; } ///< mm, of the cover
    double leastArea() const { return m_least; }             ///< mm^2, of what is divided
    double limit() const { return m_limit; }                 ///< of strain in a pattern; 1
    double limitAlone() const; ///< of one piece: sewn to others it is strained a little more

    Form formOf(const FormSheet& sheet) const { return formOf(sheet, cuts); }
    Form withoutSlits(const FormSheet& sheet) const;

    /// Of each piece whether it would lie over itself or be strained by more than `limit`; none when stopped.
    std::vector<bool> badOnes(const Form& form, FlattenOrder flattening, double limit) const;
    /// All of it, tried quickly.
    bool liesFlat(const Form& form) const;
    /// The sheet's form as it is, or with its slits sewn up: what is wrong with those is mended in the end.
    bool liesFlat(const FormSheet& sheet, const Form& form) const;
    /// Of a form of one piece: what 99 % of it do not exceed; infinite where it does not lie flat.
    double strainOf(const Form& form) const;

private:
    Form formOf(const FormSheet& sheet, const FormCuts& cuts) const;

    FormPatternOrder m_order;
    double m_limit, m_least; // 1, mm^2
    std::stop_token m_stop;
};

} // namespace bolster
