// The editing rules on a real design: whatever the user does, and undoes, the design equals its replay.
#include "ColourwayEdits.h"
#include "CurveEdits.h"
#include "CuttingEdits.h"
#include "DesignFile.h"
#include "DesignJson.h"
#include "Document.h"
#include "EditCheck.h"
#include "ElementEdits.h"
#include "Gesture.h"
#include "HandleEdits.h"
#include "MeasurementEdits.h"
#include "PatchEdits.h"
#include "SeamEdits.h"
#include "SeamStretches.h"
#include "TestPaths.h"
#include "TrimEdits.h"
#include "TwinEdits.h"
#include "Twins.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace bolster {
namespace {

/// As a drag keeps it: not what breaks something.
Edit unbroken(const Design& design, const Edit& edit)
{
    return edits::brokenBy(design, edit) ? Edit{} : edit;
}

class Designer {
public:
    explicit Designer(unsigned seed)
        : m_random(seed)
    {}

    int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    double somewhere(double size) { return std::uniform_real_distribution<double>(-size, size)(m_random); }

    /// One of everything that can be done; empty when it does not apply to the element that was chosen.
    Edit edit(const Design& design)
    {
        const ElementId id = anyElement(design);
        if (const Patch* patch = design.find<Patch>(id))
            return patchEdit(design, id, *patch);
        if (const FixationCurve* curve = design.find<FixationCurve>(id))
            return curveEdit(design, id, *curve);
        if (const Seam* seam = design.find<Seam>(id))
            return seamEdit(design, id, *seam);
        const ElementPtr element = design.element(id);
        if (element && patchCurve(*element))
            return drawnEdit(design, id, *element);
        if (design.find<Colourway>(id))
            return colourEdit(design, id);
        if (design.find<OutlineTrim>(id))
            return trimEdit(design, id);
        switch (pick(7)) {
        case 3:
            return edits::addColourway(design, "Blue");
        case 4:
            return trimEdit(design, id);
        case 5:
            return edits::assignFabric(design, std::vector{anyElement(design)}, id);
        case 0:
            return edits::changeSettings(design, {10.0 + pick(5)});
        case 1:
            return edits::renameElement(design, id, "Name " + std::to_string(pick(3)));
        case 2:
            return edits::addElement(design, design.element(id));
        default:
            return pick(20) == 0 ? edits::removeElements(design, std::vector{id}) : Edit{};
        }
    }

private:
    ElementId anyElement(const Design& design)
    {
        auto element = design.elements().begin();
        if (element == design.elements().end())
            return noElement;
        std::advance(element, pick(static_cast<int>(design.elements().size())));
        return element->first;
    }

    Edit patchEdit(const Design& design, ElementId id, const Patch& patch)
    {
        const std::vector point = {pick(patch.outline.pointCount())};
        const std::vector ids = {id};
        switch (pick(21)) {
        case 15:
        case 16:
        case 17:
            return cuttingEdit(design, id);
        case 13:
            return edits::addOutlineTrim(design, {id, 0.5 * pick(8), 0.5 * pick(8)}, anyTrim(design));
        case 14:
            return edits::assignFabric(design, ids, anyElement(design));
        case 9:
            return edits::makeTwins(design, ids, [](const std::string& name) { return name + "'"; });
        case 10:
            return edits::releasePoints(design, id, point);
        case 11:
            return edits::relinkPoints(design, id, releasedPoints(design, id));
        case 12:
            return pick(4) == 0 ? edits::unlinkTwins(design, ids) : edits::addElement(design, design.element(id));
        case 7:
            return edits::addFancySeam(design, id, BSpline2(1, false, {{10, 10}, {somewhere(90), 60}}), "Fancy");
        case 8:
            return edits::addElement(
                design, makeElement(HandleCurve{{"Handle", id, BSpline2(1, false, {{20, 10}, {somewhere(90), 70}})},
                                                BSpline3(1, false, {{0, 0, 0}, {9, 9, somewhere(9)}}),
                                                Match::Parameter}));
        case 0:
        case 1:
            return edits::movePatchPoints(design, id, point, {somewhere(20), somewhere(20)});
        case 2:
            return edits::insertPatchPoint(design, id, somewhere(10));
        case 3:
            return edits::removePatchPoint(design, id, point[0]);
        case 4:
            return edits::movePatches(design, ids, {somewhere(100), 0});
        case 5:
            return edits::turnPatches(design, ids, {0, 0}, somewhere(180));
        default:
            return pick(20) == 0 ? edits::removeElements(design, ids) : Edit{};
        }
    }

    Edit seamEdit(const Design& design, ElementId id, const Seam& seam)
    {
        const std::vector ids = {id};
        const auto side = static_cast<edits::SeamSide>(pick(2));
        const auto end = static_cast<edits::StretchEnd>(pick(2));
        const std::optional<Stretch> whole = edits::freeStretchAt(design, seam.a.patch, somewhere(10));
        const std::optional<Stretch> other = edits::freeStretchAt(design, seam.b.patch, somewhere(10));
        switch (pick(9)) {
        case 8:
            return trimEdit(design, id);
        case 0:
            return edits::flipSeams(design, ids);
        case 1:
            return edits::swapSeamSides(design, ids);
        case 2:
            return edits::setContinuity(design, ids, static_cast<Continuity>(pick(3)));
        case 3:
            return edits::setMatch(design, ids, static_cast<Match>(pick(2)));
        case 4:
        case 5:
            return unbroken(design, edits::dragStretchEnd(design, id, side, end, somewhere(10)));
        case 6:
            return whole && other ? edits::sewInRow(design, *whole, std::vector{*other}, pick(2) == 0) : Edit{};
        default:
            return pick(5) == 0 ? edits::removeElements(design, ids) : Edit{};
        }
    }

    Edit cuttingEdit(const Design& design, ElementId id)
    {
        const OutlinePlace place{id, 0.25 * pick(16)};
        const ElementId mark = anyElement(design);
        switch (pick(10)) {
        case 0:
            return edits::addNotch(design, place, {static_cast<NotchShape::Kind>(pick(5))});
        case 1:
            return edits::setEdgeAllowance(design, {id, 0.5 * pick(8), 0.5 * pick(8)}, pick(30));
        case 2:
            return edits::setCutCorner(design, place, static_cast<CornerJoin>(pick(5)));
        case 3:
            return edits::addDrillHole(design, {id, {somewhere(100), somewhere(100)}}, "Hole");
        case 9:
            return edits::addMeasurement(design, {id, {somewhere(100), somewhere(100)}},
                                         {anyElement(design), {somewhere(100), 0}}, "Depth");
        case 4:
            return edits::addInternalLine(design, id, BSpline2(1, false, {{30, 10}, {somewhere(90), 50}}),
                                          static_cast<InternalLine::Purpose>(pick(4)), "Line");
        case 5:
            return edits::setAllowance(design, std::vector{id},
                                       pick(2) == 0 ? std::nullopt : std::optional(CutAllowance{somewhere(20)}));
        case 6:
            return edits::setLabel(design, id, PieceLabelPlace{{somewhere(50), somewhere(50)}, somewhere(90)});
        case 7:
            return edits::movePlace(design, mark, place.at);
        default:
            return edits::moveDrillHoles(design, std::vector{mark}, {somewhere(9), somewhere(9)});
        }
    }

    SeamTrim anyTrim(const Design& design)
    {
        SeamTrim trim;
        trim.stitch = static_cast<SeamTrim::Stitch>(pick(3));
        trim.pipingRadius = pick(4);
        if (const ElementId fabric = anyElement(design); design.find<Fabric>(fabric))
            trim.pipingFabric = fabric;
        return trim;
    }

    Edit trimEdit(const Design& design, ElementId id)
    {
        switch (pick(3)) {
        case 0:
            return edits::dragStretchEnd(design, id, edits::SeamSide::A, static_cast<edits::StretchEnd>(pick(2)),
                                         0.25 * pick(16));
        case 1:
            return edits::setTrim(design, std::vector{id}, anyTrim(design));
        default:
            return pick(5) == 0 ? edits::removeElements(design, std::vector{id}) : Edit{};
        }
    }

    Edit colourEdit(const Design& design, ElementId id)
    {
        const std::vector patches = {anyElement(design), anyElement(design)};
        switch (pick(4)) {
        case 0:
            return edits::showColourway(design, pick(3) == 0 ? noElement : id);
        case 1:
        case 2:
            return edits::setColourwayFabric(design, id, patches, pick(4) == 0 ? noElement : anyElement(design));
        default:
            return pick(5) == 0 ? edits::removeElements(design, std::vector{id}) : Edit{};
        }
    }

    Edit curveEdit(const Design& design, ElementId id, const FixationCurve& curve)
    {
        const std::vector point = {pick(curve.curve.pointCount())};
        switch (pick(4)) {
        case 0:
        case 1:
            return edits::moveCurvePoints(design, id, point, {somewhere(20), 0, somewhere(20)});
        case 2:
            return edits::insertCurvePoint(design, id, curve.curve.domainEnd() * 0.1 * pick(11));
        default:
            return edits::removeCurvePoint(design, id, point[0]);
        }
    }

    Edit drawnEdit(const Design& design, ElementId id, const Element& element)
    {
        const std::vector point = {pick(planeCurve(element)->pointCount())};
        switch (pick(7)) {
        case 6:
            return trimEdit(design, id);
        case 0:
            return edits::movePatchPoints(design, id, point, {somewhere(20), somewhere(20)});
        case 1:
            return edits::insertPatchPoint(design, id, 0.1 * pick(11));
        case 2:
            return edits::removePatchPoint(design, id, point[0]);
        case 3:
            return edits::moveCurvePoints(design, id, std::vector{0}, {somewhere(20), 0, somewhere(20)});
        case 4:
            return edits::insertCurvePoint(design, id, 0.1 * pick(11));
        default:
            return pick(5) == 0 ? edits::removeElements(design, std::vector{id}) : Edit{};
        }
    }

    std::mt19937 m_random;
};

void step(Document& document, Designer& designer)
{
    switch (designer.pick(8)) {
    case 0:
        document.undo();
        break;
    case 1:
        document.redo();
        break;
    case 2:
        document.jumpTo(static_cast<NodeId>(designer.pick(document.history().count())));
        break;
    case 3: {
        Gesture gesture(document);
        for (int move = designer.pick(4); move > 0; --move)
            gesture.update(designer.edit(gesture.start()));
        if (designer.pick(3) > 0)
            gesture.commit();
        break;
    }
    default:
        document.commit(designer.edit(document.design()));
    }
}

TEST(RandomEdits, TheDesignEqualsItsReplayAtEveryStep)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(test::samplesFolder() + "/box-cushion/box-cushion.json"));
    ASSERT_TRUE(opened.readable && !hasErrors(opened.problems));
    int refused = 0;
    for (unsigned seed = 0; seed < 10; ++seed) {
        SCOPED_TRACE(seed);
        Document document;
        document.reset(opened.design);
        Designer designer(seed);
        Design seen = document.design();
        QObject::connect(&document, &Document::changed, [&](const ChangeSet& ids) {
            EXPECT_EQ(ids, differences(seen, document.design()));
            seen = document.design();
        });
        QObject::connect(&document, &Document::refused, [&](const Message& why) {
            EXPECT_FALSE(why.empty());
            ++refused;
        });
        for (int i = 0; i < 100; ++i) {
            step(document, designer);
            ASSERT_FALSE(document.breakage()) << i;
            Design replay = opened.design;
            for (const NodeId node : document.history().pathTo(document.history().current()))
                replay = replay.with(document.history().node(node).edit);
            ASSERT_EQ(writeDesign(document.design()), writeDesign(replay)) << i;
            ASSERT_TRUE(seen == document.design()) << i;
            for (const auto& [follower, original] : twinPairs(document.design()))
                ASSERT_EQ(unlikePoints(*document.design().element(original), *document.design().element(follower),
                                       symmetryOf(document.design())),
                          0)
                    << i;
        }
        EXPECT_GT(document.history().count(), 20);

        // What is on screen can be saved and comes back to the last bit.
        const ReadDesign again = readDesign(writeDesign(document.design()));
        EXPECT_TRUE(again.readable);
        EXPECT_TRUE(again.design == document.design());
        document.jumpTo(0);
        EXPECT_EQ(writeDesign(document.design()), writeDesign(opened.design));
    }
    EXPECT_GT(refused, 0) << "gestures that would break something are among them";
}

} // namespace
} // namespace bolster
