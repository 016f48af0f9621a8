#include "PatternDesign.h"

#include "BoxLevels.h"
#include "DesignCheck.h"
#include "DesignJson.h"
#include "ElementEdits.h"
#include "FreeNames.h"
#include "LayoutEdits.h"
#include "PieceElements.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace bolster {

namespace {

constexpr double besideOthers = 80;   // mm: from what is in the layout
constexpr double farthestApart = 1e6; // mm: pieces that lie farther from each other were never laid out
constexpr double largestPlace = 9e6;  // mm: what the rules take, and some room

class PatternBuilder {
public:
    PatternBuilder(const Design& design, const PatternChoice& choice)
        : m_start(design)
        , m_now(design)
        , m_choice(choice)
        , m_fresh(design)
    {
        design.each<Patch>([&](ElementId, const Patch& patch) { m_names.take(patch.name); });
        design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
            m_fabrics.try_emplace(fabric.name, Change{id, nullptr, design.element(id)});
            m_anyFabric = m_anyFabric.id == noElement ? Change{id, nullptr, design.element(id)} : m_anyFabric;
        });
    }

    ImportedPattern build(const FoundPattern& pattern)
    {
        for (std::size_t i = 0; i < pattern.pieces.size(); ++i)
            if (!m_choice.only || m_choice.only->contains(i))
                addPiece(pattern.pieces[i], i);
        m_now = m_start.with(m_added);
        layOut();
        setStyle(pattern);
        fitEdgeLength();
        m_result.edit = editBetween(m_start, m_now, verb());
        if (m_result.edit.empty())
            m_result.edit = {};
        return std::move(m_result);
    }

private:
    /// A piece that came alone is called by its name.
    Message verb() const
    {
        if (m_result.patches.size() == 1)
            return {QT_TRANSLATE_NOOP("Message", "Import the pattern of %1"),
                    {m_now.find<Patch>(m_result.patches.front())->name}};
        return {QT_TRANSLATE_NOOP("Message", "Import a pattern of %1 pieces"),
                {std::to_string(m_result.patches.size())}};
    }

    void addPiece(const FoundPiece& piece, std::size_t place)
    {
        const Change fabric = fabricOf(piece);
        PieceElements made = pieceElements(piece, m_choice.lines, fabric, m_fresh);
        m_result.notes.insert(m_result.notes.end(), made.notes.begin(), made.notes.end());
        if (made.patch == noElement || !hasRoomFor(piece.name, made.changes.size() + 1))
            return;
        if (!m_start.element(fabric.id) && m_fabrics.try_emplace(nameOf(fabric), fabric).second) {
            m_added.changes.push_back(fabric);
            m_anyFabric = m_anyFabric.id == noElement ? fabric : m_anyFabric;
        }
        Patch patch = std::get<Patch>(*made.changes.front().after);
        patch.name = m_names.free(patch.name);
        made.changes.front().after = makeElement(std::move(patch));
        m_added.changes.insert(m_added.changes.end(), made.changes.begin(), made.changes.end());
        m_result.patches.push_back(made.patch);
        m_result.taken.push_back(place);
    }

    /// A design with more could not be opened again.
    bool hasRoomFor(const std::string& name, std::size_t more)
    {
        if (m_start.elements().size() + m_added.changes.size() + more <= mostElements)
            return true;
        m_result.notes.push_back(
            {QT_TRANSLATE_NOOP("Message", "%1 is left out: with its holes, notches and lines the "
                                          "design would have more than %2 elements"),
             {name, std::to_string(mostElements)}});
        return false;
    }

    static const std::string& nameOf(const Change& fabric) { return std::get<Fabric>(*fabric.after).name; }

    /// One that there is, or a new one.
    Change fabricOf(const FoundPiece& piece)
    {
        if (const auto found = m_fabrics.find(piece.fabric); found != m_fabrics.end())
            return found->second;
        if (piece.fabric.empty() && m_anyFabric.id != noElement)
            return m_anyFabric;
        Fabric fabric;
        fabric.name = piece.fabric.empty() ? "Fabric" : piece.fabric;
        return {m_fresh(), nullptr, makeElement(std::move(fabric))};
    }

    /// Whether pieces lie on each other in the file, or where nobody looks.
    bool needsLayout() const
    {
        std::vector<Box2> boxes;
        Box2 whole;
        for (const ElementId id : m_result.patches) {
            boxes.push_back(edits::layoutBox(*m_now.find<Patch>(id)));
            whole.extend(boxes.back());
            if (boxes.back().isEmpty())
                return true;
        }
        if (!whole.isEmpty() && whole.sizes().maxCoeff() > farthestApart)
            return true;
        std::ranges::sort(boxes, std::greater(), [](const Box2& box) { return box.sizes().maxCoeff(); });
        BoxLevels placed;
        for (const Box2& box : boxes) {
            if (placed.anyMeets(box, 1))
                return true;
            placed.add(box, 0);
        }
        return false;
    }

    /// Where they are in the file, unless they lie on each other or on what there is.
    void layOut()
    {
        if (needsLayout()) {
            moveAll([](Patch& patch) { patch.position = Vec2::Zero(); });
            m_now = m_now.with(edits::arrangePatches(m_now, m_result.patches));
        }
        const Box2 mine = edits::layoutBox(m_now, m_result.patches);
        Box2 others;
        m_start.each<Patch>([&](ElementId, const Patch& patch) {
            if (const Box2 box = edits::layoutBox(patch); !box.isEmpty())
                others.extend(box);
        });
        if (mine.isEmpty())
            return;
        Vec2 place = others.isEmpty() ? Vec2(0, 0) : Vec2(others.max().x() + besideOthers, others.min().y());
        if ((place + mine.sizes()).cwiseAbs().maxCoeff() > largestPlace)
            place = -mine.sizes() / 2;
        const Vec2 by = place - mine.min();
        moveAll([&](Patch& patch) {
            patch.position = (patch.position + by).cwiseMax(-largestPlace).cwiseMin(largestPlace);
        });
    }

    template <class Move>
    void moveAll(const Move& move)
    {
        Edit edit;
        for (const ElementId id : m_result.patches) {
            Patch patch = *m_now.find<Patch>(id);
            move(patch);
            edit.changes.push_back({id, m_now.element(id), makeElement(std::move(patch))});
        }
        m_now = m_now.with(edit);
    }

    /// Of an empty design: the article is this one.
    void setStyle(const FoundPattern& pattern)
    {
        if (m_result.patches.empty() || !m_start.elements().empty())
            return;
        Settings settings = m_now.settings();
        settings.cutting.style = pattern.style;
        settings.cutting.version = pattern.version;
        if (!(settings == m_now.settings()))
            m_now = m_now.with(edits::changeSettings(m_now, settings));
    }

    /// So much fabric in so fine a mesh would be too many triangles.
    void fitEdgeLength()
    {
        const double least = smallestEdgeLength(m_now);
        Settings settings = m_now.settings();
        if (m_result.patches.empty() || settings.edgeLength >= least || !std::isfinite(least))
            return;
        settings.edgeLength = std::ceil(10 * least + 0.1) / 10;
        m_now = m_now.with(edits::changeSettings(m_now, settings));
        m_result.notes.push_back(
            {QT_TRANSLATE_NOOP("Message", "the pattern is so large that the edge length of its "
                                          "triangles becomes %1 mm; is the unit right?"),
             {numberText(settings.edgeLength)}});
    }

    const Design& m_start;
    Design m_now;
    const PatternChoice& m_choice;
    FreshIds m_fresh;
    FreeNames m_names;
    std::map<std::string, Change> m_fabrics;
    Change m_anyFabric;
    Edit m_added;
    ImportedPattern m_result;
};

} // namespace

ImportedPattern patternEdit(const Design& design, const FoundPattern& pattern, const PatternChoice& choice)
{
    return PatternBuilder(design, choice).build(pattern);
}

} // namespace bolster
