// A range of a curve, addressed by the fractions that a match means (paper, sections 3.1 and 3.2).
#pragma once

#include "ArcLength.h"
#include "Stretch.h"

namespace bolster {

/// Fractions run from 0 at `from` to 1 at `to`; equal fractions of two ranges belong together, or f and 1 - f where
/// one of them is walked backwards.
template <int Dim>
class MatchedRange {
public:
    MatchedRange(const BSpline<Dim>& curve, double from, double to, Match match)
        : m_length(curve)
        , m_from(from)
        , m_to(unwrappedEnd(from, to, curve.domainStart(), curve.domainEnd()))
        , m_match(match)
    {}

    double from() const { return m_from; }
    double to() const { return m_to; }
    double total() const { return m_length.between(m_from, m_to); }

    double parameter(double fraction) const
    {
        if (fraction <= 0)
            return m_from;
        if (fraction >= 1)
            return m_to;
        return m_match == Match::Length ? m_length.parameterAt(m_length.at(m_from) + fraction * total())
                                        : m_from + fraction * (m_to - m_from);
    }
    double fraction(double parameter) const
    {
        return m_match == Match::Length ? lengthFraction(parameter) : (parameter - m_from) / (m_to - m_from);
    }
    double lengthFraction(double parameter) const
    {
        const double whole = total();
        return whole > 0 ? m_length.between(m_from, parameter) / whole : 0;
    }
    double lengthTo(double parameter) const { return m_length.between(m_from, parameter); }

private:
    ArcLength<Dim> m_length;
    double m_from, m_to;
    Match m_match;
};

} // namespace bolster
