// What of the scene is shown, and the same point in both views.
#include "CoverPlaces.h"
#include "CoverSetup.h"
#include "CoverView.h"
#include "Crosshair.h"
#include "Document.h"
#include "ElementEdits.h"
#include "Hiding.h"
#include "PatternView.h"
#include "ProblemSet.h"
#include "SceneMarks.h"
#include "SectionPanel.h"
#include "Selection.h"
#include "ShownMap.h"
#include "TwinEdits.h"
#include "Twins.h"
#include "Units.h"
#include "ViewColors.h"
#include "VisibleCover.h"

#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <optional>

namespace bolster::test {
namespace {

class CoverShown : public testing::Test {
protected:
    CoverShown()
    {
        document.reset(twoSquares());
        view.setSoftwareRenderer(std::make_unique<StubRenderer>(log));
        view.resize(800, 600);
        view.show();
        view.shown().setSurface(twoSquaresCover());
        Camera camera = view.navigation().camera();
        camera.azimuth = 0;
        camera.elevation = 1.2;
        camera.fit(Box3(Vec3(0, 0, 0), Vec3(400, 200, 50)));
        view.navigation().setCamera(camera);
    }

    QPointF pixel(const Vec3& point) const
    {
        const Vec2 at = *view.navigation().camera().pixel(point);
        return {at.x(), at.y()};
    }
    CoverHit::Kind kindAt(const Vec3& point) const { return view.hit(pixel(point)).kind; }

    std::shared_ptr<StubRenderer::Log> log = std::make_shared<StubRenderer::Log>();
    Document document;
    Selection selection;
    CoverView view{document, selection};
    Mouse mouse{view};
};

TEST_F(CoverShown, ThePictureOfTheCoverHasItsShapeAndIsAsLargeAsTheViewHasRoom)
{
    view.resize(800, 300);
    Camera camera = view.navigation().camera();
    camera.fit(Box3(Vec3(-600, -200, 0), Vec3(1000, 400, 50))); // far away
    view.navigation().setCamera(camera);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shownSurface() != nullptr; }));
    const QSize whole = view.grabPicture().size(), cover = view.grabCover().size();
    EXPECT_LT(cover.width(), whole.width());
    EXPECT_GT(cover.height(), whole.height() / 2);
    // Twice as long as wide, seen from above.
    EXPECT_GT(cover.width(), cover.height());
    EXPECT_EQ(view.navigation().camera().target, camera.target) << "where one looks from stays";
}

TEST_F(CoverShown, ThePictureOfTheCoverHasNothingMarked)
{
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.shownSurface() != nullptr; }));
    selection.set({rightPatch});
    EXPECT_FALSE(view.shown().scene().tints.empty()) << "it is marked";
    bool marked = false;
    QObject::connect(&selection, &Selection::changed, [&] { marked = !selection.elements().empty(); });
    view.grabCover();
    EXPECT_TRUE(marked) << "again, after the picture";
    EXPECT_EQ(selection.elements(), Selection::Elements{rightPatch}) << "it stays selected";
}

TEST_F(CoverShown, HiddenPatchesAreNeitherDrawnNorHit)
{
    QSignalSpy changes(&view.visibility(), &SceneVisibility::hiddenChanged);
    view.visibility().setHidden({rightPatch});
    EXPECT_EQ(kindAt({320, 50, 0}), CoverHit::Kind::Nothing);
    EXPECT_EQ(kindAt({80, 50, 0}), CoverHit::Kind::Cover);
    EXPECT_EQ(kindAt({300, 100, 50}), CoverHit::Kind::Curve) << "curves stay";
    EXPECT_TRUE(QTest::qWaitFor([&] {
        return log->count() > 0 && log->last().scene.surface &&
               log->last().scene.surface->topology->patches.size() == 1;
    }));
    EXPECT_EQ(view.shown().surface()->topology->patches.size(), 2u) << "the surface itself is whole";
    view.visibility().setHidden({curveId});
    EXPECT_EQ(kindAt({300, 100, 50}), CoverHit::Kind::Cover);
    view.visibility().setHidden({});
    EXPECT_EQ(kindAt({320, 50, 0}), CoverHit::Kind::Cover);
    EXPECT_EQ(changes.count(), 3);
}

TEST_F(CoverShown, TheVisibleCoverKeepsItsVertices)
{
    const SurfaceMeshPtr whole = twoSquaresCover();
    VisibleCover visible;
    EXPECT_EQ(visible.of(whole, {}), whole);
    EXPECT_EQ(visible.of(whole, {curveId}), whole);
    const SurfaceMeshPtr rest = visible.of(whole, {leftPatch});
    ASSERT_EQ(rest->topology->patches.size(), 1u);
    EXPECT_EQ(rest->topology->patches[0].firstTriangle, 0u);
    EXPECT_EQ(rest->topology->triangles.size(), rest->topology->patches[0].triangleCount);
    EXPECT_EQ(rest->positions, whole->positions);
    EXPECT_TRUE(rest->topology->seams.empty()) << "its other side is hidden";
    EXPECT_EQ(visible.of(whole, {leftPatch})->topology, rest->topology) << "made once";
}

TEST_F(CoverShown, TheRefinedCoverIsDrawnWhileItsSurfaceIsShown)
{
    const CoverMeshPtr cover = raisedCover(view.shown().surface(), 5);
    const auto drawn = [&](const CoverMeshPtr& wanted) {
        return QTest::qWaitFor([&] { return log->count() > 0 && log->last().scene.cover == wanted; });
    };
    view.shown().setCover(cover);
    EXPECT_TRUE(drawn(cover));
    view.visibility().setHidden({rightPatch});
    EXPECT_TRUE(QTest::qWaitFor([&] {
        return log->last().scene.cover == cover && log->last().scene.surface->topology->patches.size() == 1;
    })) << "its patches are those of the surface";
    view.visibility().setHidden({});
    EXPECT_NEAR(view.hit(pixel({80, 50, 0})).position.z(), 0, 0.01) << "hits are the solver's";
    auto moved = std::make_shared<SurfaceMesh>(*view.shown().surface());
    view.shown().setSurface(moved);
    EXPECT_TRUE(drawn(nullptr));
    view.shown().setCover(cover);
    EXPECT_TRUE(QTest::qWaitFor([&] { return log->last().scene.surface == moved; }));
    EXPECT_FALSE(log->last().scene.cover) << "too late: the surface has moved meanwhile";
    view.visibility().setLayerVisible(CoverView::Layer::Cover, false);
    view.shown().setCover(raisedCover(moved, 5));
    EXPECT_TRUE(drawn(nullptr));
}

TEST_F(CoverShown, StitchesOfHiddenPatchesAreHiddenWithThem)
{
    auto trims = std::make_shared<TrimMesh>();
    trims->points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    trims->normals.assign(3, Eigen::Vector3f::UnitZ());
    trims->cloth.assign(3, Eigen::Vector2f::Zero());
    for (const auto& [patch, other] : {std::pair(leftPatch, ElementId{}), std::pair(rightPatch, ElementId{}),
                                       std::pair(leftPatch, rightPatch)}) {
        TrimMesh::Part part;
        part.element = seamId;
        part.patch = patch;
        part.other = other;
        part.firstTriangle = static_cast<std::uint32_t>(trims->triangles.size());
        part.triangleCount = 1;
        trims->triangles.push_back({0, 1, 2});
        trims->parts.push_back(part);
    }
    view.shown().setCover(raisedCover(view.shown().surface(), 5), trims);
    const auto drawn = [&](std::size_t parts) {
        return QTest::qWaitFor([&] {
            if (log->count() == 0)
                return false;
            const auto last = log->last().scene.trims;
            return last && last->parts.size() == parts && last->triangles.size() == parts;
        });
    };
    EXPECT_TRUE(drawn(3));
    view.visibility().setHidden({rightPatch});
    EXPECT_TRUE(drawn(1)) << "piping between both is gone, too, as their seam is";
    EXPECT_EQ(log->last().scene.trims->parts[0].patch, leftPatch);
    view.visibility().setHidden({});
    EXPECT_TRUE(drawn(3));
}

TEST_F(CoverShown, SeamsLieOnTheCoverThatIsDrawn)
{
    ViewScene scene;
    scene.surface = view.shown().surface();
    CoverCurves curves;
    const auto seam = [&] {
        SceneMarks(document.design(), curves, selection, {}).fill(scene, std::nullopt);
        return scene.lines.front().points;
    };
    const auto coarse = seam();
    scene.cover = raisedCover(view.shown().surface(), 5);
    const auto fine = seam();
    ASSERT_EQ(fine.size(), 2 * coarse.size() - 1);
    for (std::size_t k = 0; k < coarse.size(); ++k)
        EXPECT_LT((fine[2 * k] - coarse[k] - Eigen::Vector3f(0, 0, 5)).norm(), 1e-4F);
    EXPECT_LT((fine[1] - 0.5F * (fine[0] + fine[2])).norm(), 1e-4F);
}

TEST_F(CoverShown, IsolatingKeepsWhatBelongsToThePatch)
{
    const Design design = document.design();
    HandleCurve handle{{"Handle", leftPatch, BSpline2(1, false, {{20, 20}, {90, 90}})},
                       BSpline3(1, false, {{20, 20, 0}, {90, 90, 0}})};
    FixationSeam seam;
    seam.stretch = {leftPatch, 2, 3};
    seam.curve = curveId;
    const Design more = design.with({{},
                                     {{ElementId{60}, nullptr, makeElement(handle)},
                                      {ElementId{61}, nullptr, makeElement(seam)},
                                      {ElementId{62}, nullptr, makeElement(Frame{})}}});
    EXPECT_EQ(allBut(more, {leftPatch}), (std::set<ElementId>{rightPatch, ElementId{62}}));
    EXPECT_EQ(allBut(more, {rightPatch}), (std::set<ElementId>{leftPatch, curveId, ElementId{60}, ElementId{62}}));
    EXPECT_EQ(hideable(more, {leftPatch, seamId, fabricId}), std::set<ElementId>{leftPatch});
    EXPECT_TRUE(isHidden(more, {leftPatch}, ElementId{60}));
}

TEST_F(CoverShown, TheSectionCutsPicturesLinesAndHits)
{
    view.shown().setSection(SectionPlane{Vec3::UnitX(), 150});
    EXPECT_EQ(kindAt({320, 50, 0}), CoverHit::Kind::Nothing);
    EXPECT_EQ(kindAt({80, 50, 0}), CoverHit::Kind::Cover);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return log->count() > 0 && log->last().scene.section == view.shown().scene().section; }));
    view.shown().setSection(SectionPlane{-Vec3::UnitX(), -150});
    EXPECT_EQ(kindAt({320, 50, 0}), CoverHit::Kind::Cover);
    EXPECT_EQ(kindAt({80, 50, 0}), CoverHit::Kind::Nothing);
    view.shown().setSection(std::nullopt);
    EXPECT_EQ(kindAt({80, 50, 0}), CoverHit::Kind::Cover);
}

TEST(SectionPlaneTest, LinesAreCutWhereTheyCrossThePlane)
{
    const SectionPlane section{Vec3::UnitX(), 10};
    const std::vector<Eigen::Vector3f> line = {{0, 0, 0}, {20, 0, 0}, {20, 5, 0}, {0, 5, 0}, {5, 5, 0}};
    const auto parts = keptParts(line, section);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0], (std::vector<Eigen::Vector3f>{{0, 0, 0}, {10, 0, 0}}));
    EXPECT_EQ(parts[1], (std::vector<Eigen::Vector3f>{{10, 5, 0}, {0, 5, 0}, {5, 5, 0}}));
    EXPECT_EQ(keptPoints(line, section).size(), 3u);
    EXPECT_EQ(sectionRange(Box3(Vec3(1, 2, 3), Vec3(5, 6, 7)), -Vec3::UnitY()), std::pair(-6.0, -2.0));
}

TEST_F(CoverShown, ThePanelMovesTheSection)
{
    view.setSectionShown(true);
    ASSERT_TRUE(view.shown().scene().section);
    EXPECT_NEAR(view.shown().scene().section->normal.x(), 1, 1e-12);
    EXPECT_NEAR(view.shown().scene().section->offset, 200, 1);
    auto* slider = view.findChild<SectionPanel*>()->findChild<QSlider*>();
    slider->setValue(slider->maximum() / 4);
    EXPECT_NEAR(view.shown().scene().section->offset, 100, 1);
    view.setSectionShown(false);
    EXPECT_FALSE(view.shown().scene().section);
}

TEST_F(CoverShown, TheArrowsMoveAndTurnTheSection)
{
    view.setSectionShown(true);
    const auto* panel = view.findChild<SectionPanel*>();
    const auto shows = [&](const QString& text) {
        const auto labels = panel->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
    };
    const std::vector<Vec3> frame = planeFrame(Box3(Vec3(0, 0, 0), Vec3(400, 200, 50)), Vec3::UnitX(), 200);
    const Vec3 anchor = (frame[2] + frame[3]) / 2;
    const double mm = view.navigation().camera().pixelSize(anchor);
    const QPointF arrow = pixel(anchor + 30 * mm * Vec3::UnitX());
    mouse.move(arrow);
    EXPECT_EQ(view.cursor().shape(), Qt::SizeAllCursor);
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("section")));

    mouse.drag(arrow, pixel(anchor + 30 * mm * Vec3::UnitX() + Vec3(-60, 0, 0)));
    EXPECT_NEAR(view.shown().scene().section->offset, 140, 2);
    EXPECT_TRUE(shows(lengthText(view.shown().scene().section->offset)));
    EXPECT_NEAR(panel->findChild<QSlider*>()->value(), 350, 5);
    EXPECT_TRUE(selection.elements().empty()) << "the tool has nothing to do with it";

    const SectionPlane before = *view.shown().scene().section;
    const QPointF there = pixel(Vec3(before.offset, anchor.y(), anchor.z()) + 30 * mm * Vec3::UnitX());
    mouse.move(there);
    mouse.press(there);
    mouse.move(there + QPointF(31, 2), Qt::ControlModifier);
    EXPECT_NEAR(view.shown().scene().section->normal.dot(before.normal), std::cos(15 * M_PI / 180), 1e-9);
    EXPECT_NEAR(view.shown().scene().section->normal.z(), 0, 1e-9);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_NEAR(view.shown().scene().section->offset, before.offset, 1e-9);
    EXPECT_NEAR((view.shown().scene().section->normal - before.normal).norm(), 0, 1e-9);
    mouse.move(there + QPointF(90, 0));
    EXPECT_NEAR(view.shown().scene().section->offset, before.offset, 1e-9) << "the drag is over";
    mouse.release(there);
}

TEST_F(CoverShown, ASectionSeenFromTheFrontIsMovedUpwards)
{
    Camera camera = view.navigation().camera();
    camera.look(Camera::StandardView::Front);
    view.navigation().setCamera(camera);
    view.setSectionShown(true);
    const auto buttons = view.findChild<SectionPanel*>()->findChildren<QToolButton*>();
    buttons[1]->click(); // y
    ASSERT_NEAR(view.shown().scene().section->normal.y(), -1, 1e-12);
    const std::vector<Vec3> frame = planeFrame(Box3(Vec3(0, 0, 0), Vec3(400, 200, 50)), -Vec3::UnitY(), -100);
    const QPointF arrow = pixel((frame[2] + frame[3]) / 2) - QPointF(0, 30);
    mouse.drag(arrow, arrow - QPointF(0, 20));
    EXPECT_GT(view.shown().scene().section->offset, -99) << "towards the eye: more is seen";
}

TEST_F(CoverShown, TheMirrorImageOfTheSelectionIsMarked)
{
    const auto colored = [&](const QColor& color) {
        const QImage picture = view.grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixelColor(x, y).rgb() == color.rgb();
        return count;
    };
    const ViewColors colors = ViewColors::of(view.palette());
    FixationCurve other{"Other", BSpline3(1, false, {{0, 150, 50}, {400, 150, 50}})};
    document.commit(edits::addElement(document.design(), makeElement(other)));
    const ElementId otherId{number(document.design().nextId()) - 1};
    Settings settings = document.design().settings();
    settings.symmetry = Symmetry{};
    settings.symmetry->planePoint = Vec3(0, 125, 0);
    settings.symmetry->planeNormal = Vec3::UnitY();
    document.commit(edits::changeSettings(document.design(), settings));
    const QImage withPlane = view.grab().toImage();
    view.visibility().setLayerVisible(CoverView::Layer::Symmetry, false);
    EXPECT_NE(view.grab().toImage(), withPlane);

    document.commit(edits::linkTwins(document.design(), curveId, otherId));
    ASSERT_EQ(twinOf(document.design(), curveId), otherId);
    EXPECT_EQ(colored(mirroredColor(colors)), 0);
    selection.set({curveId});
    EXPECT_GT(colored(mirroredColor(colors)), 30);
    view.visibility().setLayerVisible(CoverView::Layer::Twins, false);
    EXPECT_EQ(colored(mirroredColor(colors)), 0);
}

TEST_F(CoverShown, HandlesAndFancySeamsHaveLayers)
{
    const HandleCurve handle{{"Handle", leftPatch, BSpline2(1, false, {{20, 20}, {90, 20}})},
                             BSpline3(1, false, {{20, 20, 0}, {90, 20, 0}})};
    document.reset(document.design().with({{}, {{ElementId{60}, nullptr, makeElement(handle)}}}));
    EXPECT_EQ(kindAt({50, 20, 0}), CoverHit::Kind::Curve);
    view.visibility().setLayerVisible(CoverView::Layer::FixationCurves, false);
    EXPECT_EQ(kindAt({50, 20, 0}), CoverHit::Kind::Curve);
    view.visibility().setLayerVisible(CoverView::Layer::HandleCurves, false);
    EXPECT_EQ(kindAt({50, 20, 0}), CoverHit::Kind::Cover);
}

TEST_F(CoverShown, PiecesOfAFrameAreMarkedAtOnce)
{
    const ElementId id = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(Frame{})));
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, 0, 0}, {90, 0, 0}, {0, 50, 30}, {200, 0, 0}, {250, 0, 0}, {200, 50, 30}};
    mesh->triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh->parts = {{"Frame", 0, 2}};
    view.shown().setFiles({{{id, mesh}}, {}});
    const auto marks = [&](const std::vector<int>& pieces) {
        view.shown().showFramePieces(id, pieces);
        const QImage picture = view.grab().toImage();
        const QRgb accent = ViewColors::of(view.palette()).accent.rgb();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixel(x, y) == accent;
        return count;
    };
    const int none = marks({});
    const int one = marks({0});
    EXPECT_GT(one, none);
    EXPECT_GT(marks({0, 1}), one) << "a box around both";
    EXPECT_EQ(marks({}), none);
}

TEST_F(CoverShown, TheFloorIsUnderTheFrame)
{
    TriangleMesh mesh;
    mesh.points = {{0, 0, 400}, {2000, 0, 400}, {0, 900, 1200}};
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{"Seat", 0, 1}};
    const ElementId id{60};
    view.shown().setFiles({{{id, std::make_shared<const TriangleMesh>(mesh)}}, {}});
    document.reset(document.design().with({{}, {{id, nullptr, makeElement(Frame{})}}}));
    EXPECT_NEAR(view.shown().scene().floor, 399, 1e-9) << "the patches hang far below it";
    view.visibility().setHidden({id});
    EXPECT_NEAR(view.shown().scene().floor, 399, 1e-9) << "while the frame is hidden, too";

    Box3 seen(Vec3(100, 50, 0), Vec3(200, 100, 20));
    EXPECT_TRUE(view.navigation().inPicture(seen));
    seen.extend(Vec3(5000, 0, 0));
    EXPECT_FALSE(view.navigation().inPicture(seen));
}

TEST_F(CoverShown, AFrameThatIsShownAgainIsUnderTheCoverAtOnce)
{
    TriangleMesh mesh;
    mesh.points = {{10, 10, 3}, {390, 10, 3}, {200, 190, 3}};
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{"Seat", 0, 1}};
    const ElementId id{60};
    view.shown().setFiles({{{id, std::make_shared<const TriangleMesh>(mesh)}}, {}});
    document.reset(document.design().with({{}, {{id, nullptr, makeElement(Frame{})}}}));
    /// The first picture after so many of that many patches and frames.
    const auto picture = [&](int after, std::size_t patches, std::size_t frames) {
        std::optional<SoftwareRenderer::Request> found;
        (void)QTest::qWaitFor([&] {
            const std::lock_guard lock(log->mutex);
            for (auto i = static_cast<std::size_t>(after); i < log->requests.size() && !found; ++i)
                if (const auto& request = log->requests[i];
                    request.scene.surface && request.scene.surface->topology->patches.size() == patches &&
                    request.scene.frames.size() == frames)
                    found = request;
            return found.has_value();
        });
        return found;
    };
    const auto skinned = [&](const FrameSkinPtr& other) {
        return QTest::qWaitFor([&] {
            return log->count() > 0 && !log->last().scene.frames.empty() && log->last().scene.frames[0].skin &&
                   log->last().scene.frames[0].skin != other;
        });
    };
    ASSERT_TRUE(skinned(nullptr));
    const FrameSkinPtr whole = log->last().scene.frames[0].skin;
    view.visibility().setHidden({id});
    ASSERT_TRUE(picture(0, 2, 0));
    int before = log->count();
    view.visibility().setHidden({});
    auto again = picture(before, 2, 1);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->scene.frames[0].skin, whole);

    view.visibility().setHidden({leftPatch});
    ASSERT_TRUE(skinned(whole)) << "what lies under the other one comes out";
    before = log->count();
    view.visibility().setHidden({});
    again = picture(before, 2, 1);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->scene.frames[0].skin, whole);
}

TEST_F(CoverShown, SeamsAreDarkerOnAMapAtOnce)
{
    view.visibility().setLayerVisible(SceneVisibility::Layer::Checker, false);
    const auto darkest = [&] {
        int alpha = 0;
        for (const SceneLine& line : view.shown().scene().lines)
            alpha = std::max(alpha, line.color.rgb() == qRgb(18, 14, 12) ? line.color.alpha() : 0);
        return alpha;
    };
    const int onCloth = darkest();
    ASSERT_GT(onCloth, 0);
    auto map = std::make_shared<ShownMap>();
    map->topology = view.shown().surface()->topology;
    map->values.assign(view.shown().surface()->positions.size(), 0);
    view.setMap(map);
    EXPECT_GT(darkest(), onCloth);
    view.setMap(nullptr);
    EXPECT_EQ(darkest(), onCloth);
}

TEST_F(CoverShown, OpacityOfFramesReachesThePicture)
{
    view.shown().setFrameOpacity(0.9);
    EXPECT_TRUE(QTest::qWaitFor([&] { return log->count() > 0 && log->last().scene.frameOpacity == 0.9; }));
}

TEST_F(CoverShown, ThePointUnderThePointerIsKnownInBothViews)
{
    ProblemSet problems;
    PatternView pattern(document, selection, problems);
    pattern.resize(600, 500);
    pattern.show();
    pattern.navigation().fitAll();
    QObject::connect(&view, &CoverView::coverPointed, &pattern, &PatternView::showPlace);
    QObject::connect(&pattern, &PatternView::patchPointed, &view, &CoverView::showPlace);
    auto* onPattern = pattern.findChild<Crosshair*>();
    auto* onCover = view.findChild<Crosshair*>();

    mouse.move(pixel({250, 60, 0}));
    EXPECT_TRUE(onPattern->isVisible());
    const QPointF there = pattern.navigation().transform().toPixels({50, 60});
    EXPECT_LT((QPointF(onPattern->geometry().center()) - there).manhattanLength(), 3);
    mouse.move({2, 2});
    EXPECT_FALSE(onPattern->isVisible());

    Mouse(pattern).move(pattern.navigation().transform().toPixels({30, 160}));
    EXPECT_TRUE(onCover->isVisible());
    // Both patches lie at the same place of the layout: the upper one is under the pointer.
    EXPECT_LT((QPointF(onCover->geometry().center()) - pixel({230, 160, 0})).manhattanLength(), 4);
}

TEST_F(CoverShown, AClickIsToldOnce)
{
    QSignalSpy clicks(&view, &CoverView::coverClicked);
    mouse.click(pixel({250, 60, 0}));
    ASSERT_EQ(clicks.count(), 1);
    const auto point = clicks[0][0].value<CoverPoint>();
    EXPECT_EQ(point.patch, rightPatch);
    EXPECT_LT((point.outline - Vec2(50, 60)).norm(), 2);
    mouse.drag(pixel({250, 60, 0}), pixel({150, 60, 0}));
    EXPECT_EQ(clicks.count(), 1) << "a drag turns the view";
}

TEST_F(CoverShown, TheCrossHairIsNotWhereTheCoverIsCutAway)
{
    const auto* crosshair = view.findChild<Crosshair*>();
    const CoverPoint point{leftPatch, Vec2(50, 50)};
    view.showPlace(point);
    ASSERT_TRUE(crosshair->isVisible());
    view.shown().setSection(SectionPlane{-Vec3::UnitX(), -150});
    EXPECT_FALSE(crosshair->isVisible());
    view.shown().setSection(SectionPlane{Vec3::UnitX(), 150});
    EXPECT_TRUE(crosshair->isVisible());
}

} // namespace
} // namespace bolster::test
