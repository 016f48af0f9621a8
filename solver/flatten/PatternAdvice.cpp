#include "PatternAdvice.h"

#include "DesignCheck.h"
#include "PatternSize.h"
#include "PieceRelations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

namespace bolster {

namespace {

constexpr double fewestEdges = 4;    // across a piece: with fewer a cover has no shape to speak of
constexpr std::size_t mostNamed = 3; // pieces in a sentence
constexpr double unbearable = 0.5;   // strain: not even knitted fabrics
constexpr double leastHeld = 0.2;    // mm of border for each mm that a square of its area is wide

class Adviser {
public:
    Adviser(const Form& form, const std::vector<FlatPiece>& flat, const FormPatternOrder& order,
            const FormPattern& pattern)
        : m_form(form)
        , m_flat(flat)
        , m_order(order)
        , m_pattern(pattern)
        , m_relations(form)
    {}

    std::vector<Message> advice()
    {
        adviseOnHolding();
        adviseOnEdges();
        adviseOnSize();
        adviseOnWidth();
        adviseOnStrain();
        return std::move(m_advice);
    }

private:
    const FormPiece& piece(std::size_t p) const { return m_form.pieces[p]; }
    const Vec3& formPoint(std::size_t p, std::size_t k) const
    {
        return m_form.points[piece(p).points[piece(p).border[k]]];
    }
    const Vec2& flatPoint(std::size_t p, std::size_t k) const { return m_flat[p].at[piece(p).border[k]]; }

    bool isThere(std::size_t p) const { return m_pattern.patches[p] != noElement; }

    /// mm of its border that are fixed.
    double heldLength(std::size_t p) const
    {
        double length = 0;
        for (std::size_t k = 0; k < piece(p).border.size(); ++k)
            if (const EdgeMate& mate = piece(p).mates[k]; mate.none() || !isThere(mate.piece))
                length += (formPoint(p, piece(p).after(k)) - formPoint(p, k)).norm();
        return length;
    }

    void adviseOnHolding()
    {
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (m_relations.isClosed(p) && isThere(p)) {
                m_advice.push_back(
                    {QT_TRANSLATE_NOOP("Message",
                                       "What is closed all around has no border to be held at: its cover is "
                                       "fixed along its seams. Delete the fixations of those that are to "
                                       "be free"),
                     {}});
                break;
            }
        adviseOnSmallHoles();
    }

    /// What hangs at one of them stands in no way as the form does.
    void adviseOnSmallHoles()
    {
        struct Group {
            std::string name;
            double area = 0, held = 0; // mm^2, mm
        };
        std::map<int, Group> groups;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p) {
            if (!isThere(p) || m_relations.isClosed(p))
                continue;
            Group& group = groups.try_emplace(m_relations.group(p), Group{piece(p).name}).first->second;
            group.area += areaOf(p);
            group.held += heldLength(p);
        }
        for (const auto& [number, group] : groups)
            if (group.held < leastHeld * std::sqrt(group.area))
                m_advice.push_back(
                    {QT_TRANSLATE_NOOP("Message", "%1, with what is sewn to it, is held only at a border of %2 mm: "
                                                  "fix it along other curves, too, or close that hole of the form"),
                     {group.name, numberText(group.held, 2)}});
    }

    /// mm, to a tenth: edges with which the smallest piece of these has a shape.
    double edgesFor(const std::vector<std::size_t>& pieces) const
    {
        double least = m_order.edgeLength;
        for (const std::size_t p : pieces)
            least = std::min(least, std::sqrt(areaOf(p)) / fewestEdges);
        return std::floor(10 * least) / 10;
    }

    double areaOf(std::size_t p) const
    {
        return std::abs(m_pattern.design.find<Patch>(m_pattern.patches[p])->outline.signedArea());
    }

    std::string namesOf(const std::vector<std::size_t>& pieces) const
    {
        std::string names;
        for (std::size_t k = 0; k < std::min(pieces.size(), mostNamed); ++k)
            names.append(k > 0 ? ", " : "").append(piece(pieces[k]).name);
        if (pieces.size() > mostNamed)
            names.append(" (+").append(std::to_string(pieces.size() - mostNamed)).append(")");
        return names;
    }

    /// Where shorter edges would make more of the cover than is convenient, they are no advice.
    void adviseOnEdges()
    {
        const double least = fewestEdges * m_order.edgeLength, all = patternArea(m_pattern.design);
        std::vector<std::size_t> small, specks;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && areaOf(p) < least * least)
                (vertexCount(all, edgesFor({p})) > FormPattern::manyVertices ? specks : small).push_back(p);
        if (!small.empty())
            m_advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Small for the triangles of the cover, whose edges are %1 mm long: %2. Their "
                                   "shape will be coarse; with mesh edges of %3 mm it is not"),
                 {numberText(m_order.edgeLength, 3), namesOf(small), numberText(edgesFor(small), 3)}});
        if (!specks.empty())
            m_advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join "
                                   "them to what lies beside them, or leave them out"),
                 {numberText(m_order.edgeLength, 3), namesOf(specks)}});
    }

    /// mm, across the grain.
    double breadthOf(std::size_t p) const
    {
        const double grain = m_pattern.design.find<Patch>(m_pattern.patches[p])->grain * std::numbers::pi / 180;
        const Vec2 across(-std::sin(grain), std::cos(grain));
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (std::size_t k = 0; k < piece(p).border.size(); ++k) {
            least = std::min(least, flatPoint(p, k).dot(across));
            most = std::max(most, flatPoint(p, k).dot(across));
        }
        return most - least;
    }

    void adviseOnWidth()
    {
        std::vector<std::size_t> broad;
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && breadthOf(p) > m_order.fabric.cutting.width)
                broad.push_back(p);
        if (!broad.empty())
            m_advice.push_back(
                {QT_TRANSLATE_NOOP("Message",
                                   "Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide "
                                   "them, or turn their grain"),
                 {numberText(m_order.fabric.cutting.width), namesOf(broad)}});
    }

    void adviseOnStrain()
    {
        for (std::size_t p = 0; p < m_form.pieces.size(); ++p)
            if (isThere(p) && m_flat[p].strainP99 > unbearable)
                m_advice.push_back(
                    {QT_TRANSLATE_NOOP("Message", "%1 is strained by %2 % when it lies on the form, more than any "
                                                  "fabric bears. Divide it, or cut it in where it bulges most"),
                     {piece(p).name, numberText(100 * m_flat[p].strainP99, 2)}});
    }

    /// Such as of a file whose numbers are millimetres and were taken for metres.
    void adviseOnSize()
    {
        const double least = smallestEdgeLength(m_pattern.design);
        if (m_order.edgeLength >= least)
            return;
        m_advice.push_back(
            {QT_TRANSLATE_NOOP("Message",
                               "The form is %1 mm large: with edges of %2 mm its cover has more triangles "
                               "than can be solved. See whether the unit is right; else make the mesh "
                               "edges at least %3 mm long"),
             {numberText(m_form.boundingBox().sizes().maxCoeff(), 3), numberText(m_order.edgeLength, 3),
              numberText(std::ceil(least), 6)}});
    }

    const Form& m_form;
    const std::vector<FlatPiece>& m_flat;
    const FormPatternOrder& m_order;
    const FormPattern& m_pattern;
    PieceRelations m_relations;
    std::vector<Message> m_advice;
};

} // namespace

std::vector<Message> patternAdvice(const Form& form, const std::vector<FlatPiece>& flat,
                                   const FormPatternOrder& order, const FormPattern& pattern)
{
    return Adviser(form, flat, order, pattern).advice();
}

} // namespace bolster
