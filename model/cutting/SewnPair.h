// Both sides of a seam, and which of their places meet.
#pragma once

#include "Design.h"
#include "MatchedRange.h"

#include <memory>
#include <optional>

namespace bolster {

class SewnPair {
public:
    SewnPair(const Design& design, const Seam& seam);

    /// Whether both stretches are there and have a length.
    bool usable() const { return m_a && m_b; }
    const Seam& seam() const { return m_seam; }
    const BSpline2& outlineA() const { return *m_outlineA; }
    const BSpline2& outlineB() const { return *m_outlineB; }
    /// The parameters that meet at a fraction of the first side.
    double onA(double fraction) const { return m_a->parameter(fraction); }
    double onB(double fraction) const { return m_b->parameter(m_seam.reversed ? 1 - fraction : fraction); }
    double lengthA() const { return m_a->total(); }
    double lengthB() const { return m_b->total(); }
    double length() const { return (lengthA() + lengthB()) / 2; }
    /// The fraction of a place on either side; nothing for other places.
    std::optional<double> fractionAt(const OutlinePlace& place) const;
    /// Whether a side of one could be sewn to a side of the other by mistake: they share a patch and are as long
    /// but for a share.
    bool couldBe(const SewnPair& other, double share) const;
    /// Whether one of the patches looks, from this side, as it does turned round.
    bool couldBeTurned(double share) const;

private:
    Seam m_seam;
    const BSpline2* m_outlineA = nullptr; // of the design
    const BSpline2* m_outlineB = nullptr;
    std::shared_ptr<const MatchedRange<2>> m_a, m_b;
};

} // namespace bolster
