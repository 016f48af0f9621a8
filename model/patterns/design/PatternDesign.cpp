#include "PatternDesign.h"

#include "AllowanceFound.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "ElementEdits.h"
#include "LayoutEdits.h"
#include "OutlineFit.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr double besideOthers = 80;   // mm: from what is in the layout
constexpr double farFromOutline = 60; // mm: notches that belong to nothing
constexpr double usualHole = 3;       // mm

Contour moved(Contour line, const Vec2& by)
{
    for (DrawnPoint& point : line.points)
        point.at += by;
    return line;
}

class PatternBuilder {
public:
    PatternBuilder(const Design& design, const PatternChoice& choice)
        : m_start(design)
        , m_builder(design)
        , m_choice(choice)
    {}

    ImportedPattern build(const FoundPattern& pattern)
    {
        for (std::size_t i = 0; i < pattern.pieces.size(); ++i)
            if (!m_choice.only || m_choice.only->contains(i))
                addPiece(pattern.pieces[i]);
        layOut();
        setStyle(pattern);
        m_result.edit = m_builder.result({QT_TRANSLATE_NOOP("Message", "Import a pattern of %1 pieces"),
                                          {std::to_string(m_result.patches.size())}});
        return std::move(m_result);
    }

private:
    void note(const char* sentence, const FoundPiece& piece) { m_result.notes.push_back({sentence, {piece.name}}); }

    void addPiece(const FoundPiece& piece)
    {
        const bool bySewing = m_choice.lines == PatternLines::Sew && piece.sew.has_value();
        const Contour& line = bySewing ? *piece.sew : piece.cut;
        const Vec2 origin = line.box().isEmpty() ? Vec2(0, 0) : Vec2(line.box().center());
        const auto outline = fittedCurve(moved(line, -origin));
        if (!outline) {
            note(QT_TRANSLATE_NOOP("Message", "%1 is left out: its outline has too few or too many points"), piece);
            return;
        }
        if (outlineProblem(*outline)) {
            note(QT_TRANSLATE_NOOP("Message", "%1 is left out: its outline crosses itself or encloses nothing"),
                 piece);
            return;
        }
        Patch patch;
        patch.name = edits::freeName<Patch>(m_builder.now(), piece.name);
        patch.fabric = fabricOf(piece);
        patch.position = origin;
        patch.outline = *outline;
        if (piece.grain)
            patch.grain = *piece.grain;
        patch.cutting.quantity = piece.quantity;
        patch.cutting.pair = piece.pair;
        patch.cutting.note = piece.note;
        FoundAllowance allowance;
        allowance.usual.width = 0;
        if (bySewing)
            allowance = foundAllowance(*outline, moved(piece.cut, -origin));
        if (bySewing || piece.isCutLine || m_choice.lines == PatternLines::Cut)
            patch.allowance = allowance.usual;
        const ElementId id = m_builder.add(std::move(patch));
        m_result.patches.push_back(id);
        for (const EdgeWidth& edge : allowance.edges)
            m_builder.add(EdgeAllowance{{id, edge.from, edge.to}, edge.width});
        addMarks(id, piece, *outline, origin);
    }

    ElementId fabricOf(const FoundPiece& piece)
    {
        ElementId found = noElement, first = noElement;
        m_builder.now().each<Fabric>([&](ElementId id, const Fabric& fabric) {
            if (first == noElement)
                first = id;
            if (fabric.name == piece.fabric && found == noElement)
                found = id;
        });
        if (found != noElement || (piece.fabric.empty() && first != noElement))
            return found != noElement ? found : first;
        Fabric fabric;
        fabric.name = piece.fabric.empty() ? "Leather" : piece.fabric;
        return m_builder.add(std::move(fabric));
    }

    /// Inwards from the cut line, or whatever is nearest.
    static BSpline2::Closest sewnPlace(const BSpline2& outline, const FoundNotch& notch, const Vec2& origin)
    {
        const Vec2 at = notch.at - origin;
        BSpline2::Closest place = outline.closest(at);
        if (!notch.inwards || place.distance < 0.05)
            return place;
        // Along the ray, as far as the nearest point is and a little more.
        for (int k = 0; k < 3; ++k) {
            const Vec2 onRay = at + notch.inwards->dot(place.point - at) * *notch.inwards;
            const BSpline2::Closest next = outline.closest(onRay);
            if (next.distance > place.distance)
                break;
            place = next;
        }
        place.distance = (place.point - at).norm();
        return place;
    }

    void addMarks(ElementId id, const FoundPiece& piece, const BSpline2& outline, const Vec2& origin)
    {
        int lost = 0;
        for (const FoundNotch& notch : piece.notches) {
            const BSpline2::Closest place = sewnPlace(outline, notch, origin);
            if (place.distance > farFromOutline)
                ++lost;
            else
                m_builder.add(Notch{{id, place.parameter}, notch.shape, notch.twice});
        }
        for (const FoundHole& hole : piece.holes)
            m_builder.add(DrillHole{
                "", {id, hole.at - origin}, hole.diameter > 0 ? std::clamp(hole.diameter, 0.1, 100.0) : usualHole});
        for (const FoundLine& line : piece.inner) {
            const auto curve = fittedCurve(moved(line.line, -origin));
            if (!curve) {
                ++lost;
                continue;
            }
            InternalLine inner;
            inner.patch = id;
            inner.curve = *curve;
            inner.use = line.cut ? LineUse::Cut : LineUse::Drawn;
            m_builder.add(std::move(inner));
        }
        if (lost > 0)
            m_result.notes.push_back(
                {QT_TRANSLATE_NOOP("Message", "%1: %2 notches or lines belong to nothing and are left out"),
                 {piece.name, std::to_string(lost)}});
    }

    /// Where they are in the file, unless they lie on each other or on what there is.
    void layOut()
    {
        std::vector<Box2> boxes;
        bool overlap = false;
        for (const ElementId id : m_result.patches) {
            const Box2 box = edits::layoutBox(*m_builder.now().find<Patch>(id));
            overlap = overlap || std::ranges::any_of(boxes, [&](const Box2& other) {
                          Box2 common = box.intersection(other);
                          return !common.isEmpty() && common.sizes().minCoeff() > 1;
                      });
            boxes.push_back(box);
        }
        if (overlap)
            m_builder.apply(edits::arrangePatches(m_builder.now(), m_result.patches));
        const Box2 mine = edits::layoutBox(m_builder.now(), m_result.patches);
        Box2 others;
        m_start.each<Patch>([&](ElementId, const Patch& patch) {
            if (const Box2 box = edits::layoutBox(patch); !box.isEmpty())
                others.extend(box);
        });
        if (mine.isEmpty())
            return;
        const Vec2 place = others.isEmpty() ? Vec2(0, 0) : Vec2(others.max().x() + besideOthers, others.min().y());
        const Vec2 by = place - mine.min();
        for (const ElementId id : m_result.patches) {
            Patch patch = *m_builder.now().find<Patch>(id);
            patch.position += by;
            m_builder.replace(id, std::move(patch));
        }
    }

    /// Of an empty design: the article is this one.
    void setStyle(const FoundPattern& pattern)
    {
        if (m_result.patches.empty() || !m_start.elements().empty())
            return;
        Settings settings = m_builder.now().settings();
        settings.cutting.style = pattern.style;
        settings.cutting.version = pattern.version;
        if (!(settings == m_builder.now().settings()))
            m_builder.apply(edits::changeSettings(m_builder.now(), settings));
    }

    const Design& m_start;
    edits::EditBuilder m_builder;
    const PatternChoice& m_choice;
    ImportedPattern m_result;
};

} // namespace

ImportedPattern patternEdit(const Design& design, const FoundPattern& pattern, const PatternChoice& choice)
{
    return PatternBuilder(design, choice).build(pattern);
}

} // namespace bolster
