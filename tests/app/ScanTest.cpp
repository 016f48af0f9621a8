#include "WindowTest.h"

#include "CloudImport.h"
#include "Commands.h"
#include "CoverView.h"
#include "ElementEdits.h"
#include "ElidedLabel.h"
#include "Inspector.h"
#include "MapLegend.h"
#include "ScanLink.h"
#include "StatusLine.h"

#include <QTemporaryDir>

#include <cmath>

namespace bolster {
namespace {

class ScanTest : public WindowTest {
protected:
    ElementId scanId()
    {
        ElementId found{};
        window.document().design().each<Scan>([&](ElementId id, const Scan&) { found = id; });
        return found;
    }
    const Scan& scan() { return *window.document().design().find<Scan>(scanId()); }
    bool measured(const std::function<bool(const ScanFigures&)>& wanted)
    {
        return QTest::qWaitFor(
            [&] {
                const auto& figures = window.scans().figures();
                const auto found = figures.find(scanId());
                return found != figures.end() && wanted(found->second);
            },
            60000);
    }
    void wish(ScanWish what) { emit window.inspector().scanWish(scanId(), what); }
};

TEST_F(ScanTest, MeasuresShowsAndPlacesTheScanOfASample)
{
    ASSERT_TRUE(open(sample("armchair-scan")));
    ASSERT_TRUE(waitUntilSolved());
    ASSERT_TRUE(measured([](const ScanFigures& f) { return f.rms > 0 && f.rms < 3; }));

    window.command("map.deviation")->trigger();
    const ShownMapPtr map = window.scans().map();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->values.size(), window.solver().surface()->positions.size());
    EXPECT_EQ(window.scans().pairs().size(), static_cast<std::size_t>(std::ranges::count_if(
                                                 map->values, [](float v) { return std::isfinite(v); })));

    // Pointed at, the legend says the number there.
    CoverPoint place{map->topology->patches[0].patch, Vec2::Zero()};
    for (std::uint32_t v = 0; v < map->topology->patches[0].vertexCount; ++v)
        if (std::isfinite(map->values[v]))
            place.outline = map->topology->pattern[v];
    emit window.coverView().coverPointed(place);
    EXPECT_TRUE(window.coverView().findChild<MapLegend*>()->accessibleDescription().contains(QStringLiteral("mm")));
    EXPECT_TRUE(
        window.patternView().findChild<MapLegend*>()->accessibleDescription().contains(QStringLiteral("mm")));

    const Vec3 before = scan().position;
    wish(ScanWish::FitPlacement);
    EXPECT_TRUE(window.statusLine().findChild<ElidedLabel*>()->fullText().contains("where it lies now"));
    EXPECT_EQ(scan().position, before);
    window.document().commit(edits::replaceElement(window.document().design(), scanId(),
                                                   [&] {
                                                       Scan off = scan();
                                                       off.enabled = false;
                                                       off.position += Vec3(12, 0, 8);
                                                       return makeElement(off);
                                                   }(),
                                                   {}));
    ASSERT_TRUE(waitUntilSolved());
    wish(ScanWish::FitPlacement);
    EXPECT_TRUE(QTest::qWaitFor([&] { return (scan().position - before).norm() < 8; }, 60000))
        << (scan().position - before).norm();
}

TEST_F(ScanTest, ARectangleInTheViewCutsPartOfItAway)
{
    ASSERT_TRUE(open(sample("room-scan")));
    ASSERT_TRUE(waitUntilSolved());
    wish(ScanWish::ShowAll);
    EXPECT_TRUE(scan().cuts.empty());
    wish(ScanWish::KeepAroundCover);
    ASSERT_EQ(scan().cuts.size(), 1U);
    EXPECT_TRUE(scan().cuts[0].keep);

    CoverView& view = window.coverView();
    view.navigation().setCamera(view.navigation().camera()); // it may still be on its way to the cover
    wish(ScanWish::CutAway);
    const QPoint from(view.width() / 3, view.height() / 3), to(2 * view.width() / 3, 2 * view.height() / 3);
    press(view, from);
    move(view, to, Qt::LeftButton);
    release(view, to);
    ASSERT_EQ(scan().cuts.size(), 2U);
    EXPECT_EQ(scan().cuts[1].halfSpaces.size(), 4U);
    const Camera& camera = view.navigation().camera();
    const auto removed = [&](double x, double y, double away) {
        const Camera::Ray ray = camera.ray({x * view.width(), y * view.height()});
        return scan().cuts[1].removes(scan().filePoint(ray.origin + away * ray.direction));
    };
    EXPECT_TRUE(removed(0.5, 0.5, 500));
    EXPECT_TRUE(removed(0.4, 0.6, 4000));
    EXPECT_FALSE(removed(0.2, 0.5, 2000));
    EXPECT_FALSE(removed(0.5, 0.8, 2000));

    wish(ScanWish::KeepOnly); // and a change of mind
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(scan().cuts.size(), 2U);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(scan().cuts.size(), 1U);
}

/// Of the cover's vertices that are seen and were scanned, those that are far from each other: where each is in the
/// picture.
std::vector<std::pair<Vec3, QPointF>> farPlaces(const CoverView& view, const SurfaceMesh& surface,
                                                const PointCloud& cloud, const Placement& placement)
{
    const Camera& camera = view.navigation().camera();
    const auto scanned = [&](const Vec3& at) {
        return std::ranges::any_of(cloud.points, [&, file = placement.filePoint(at)](const Vec3& point) {
            return placement.scale * (point - file).norm() < 8;
        });
    };
    std::vector<std::pair<Vec3, QPointF>> seen;
    for (std::size_t v = 0; v < surface.positions.size(); v += 47) {
        const Vec3& at = surface.positions[v];
        const std::optional<Vec2> pixel = camera.pixel(at);
        if (!pixel || !QRectF(view.rect()).adjusted(90, 90, -90, -90).contains({pixel->x(), pixel->y()}))
            continue;
        const QPointF there(pixel->x(), pixel->y());
        const CoverHit hit = view.hit(there);
        if (hit && (hit.position - at).norm() < 5 && scanned(at))
            seen.emplace_back(at, there);
    }
    if (seen.size() < 3)
        return seen;
    std::vector<std::pair<Vec3, QPointF>> far = {seen.front()};
    while (far.size() < 3)
        far.push_back(*std::ranges::max_element(seen, {}, [&](const auto& one) {
            double nearest = 1e9;
            for (const auto& other : far)
                nearest = std::min(nearest, (one.first - other.first).norm());
            return nearest;
        }));
    return far;
}

TEST_F(ScanTest, ThreePlacesAlignItWithTheCover)
{
    ASSERT_TRUE(open(sample("armchair-scan")));
    ASSERT_TRUE(waitUntilSolved());
    const Placement right = scan();
    Scan off = scan();
    off.enabled = false;
    const Quat turn(Eigen::AngleAxisd(0.15, Vec3(1, 2, 3).normalized()));
    off.rotation = turn * off.rotation;
    off.position = turn * off.position + Vec3(60, -40, 90);
    window.document().commit(edits::replaceElement(window.document().design(), scanId(), makeElement(off), {}));
    ASSERT_TRUE(waitUntilSolved());
    const Placement before = scan();

    CoverView& view = window.coverView();
    const auto places =
        farPlaces(view, *window.solver().surface(), *window.session().files().clouds.at(scanId()), right);
    ASSERT_EQ(places.size(), 3U);
    wish(ScanWish::Align);
    EXPECT_EQ(view.tool(), CoverToolKind::AlignScan);
    for (const auto& [place, pixel] : places) {
        const auto onScan = view.navigation().camera().pixel(scan().placed(right.filePoint(place)));
        ASSERT_TRUE(onScan);
        QTest::mouseClick(&view, Qt::LeftButton, {}, QPointF(onScan->x(), onScan->y()).toPoint());
        EXPECT_TRUE(view.prompt().contains(QStringLiteral("belongs"))) << view.prompt().toStdString();
        QTest::mouseClick(&view, Qt::LeftButton, {}, pixel.toPoint());
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return !(static_cast<const Placement&>(scan()) == before); }, 60000));
    EXPECT_LT((scan().position - right.position).norm(), 8);
    EXPECT_LT(scan().rotation.angularDistance(right.rotation), 0.01);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
    const std::string verb =
        window.document().history().node(window.document().history().current()).edit.verb.english();
    EXPECT_NE(verb.find("mm rms"), verb.npos) << verb;
    window.command("edit.undo")->trigger();
    EXPECT_TRUE(static_cast<const Placement&>(scan()) == before) << "one step";

    wish(ScanWish::Align); // and a change of mind
    QTest::mouseClick(&view, Qt::LeftButton, {}, places[0].second.toPoint());
    QTest::keyClick(&view, Qt::Key_Backspace);
    QTest::keyClick(&view, Qt::Key_Escape);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
    EXPECT_TRUE(static_cast<const Placement&>(scan()) == before);
}

TEST_F(ScanTest, PlacesThatDoNotFitAreKept)
{
    ASSERT_TRUE(open(sample("armchair-scan")));
    ASSERT_TRUE(waitUntilSolved());
    const Placement before = scan();
    CoverView& view = window.coverView();
    const auto places =
        farPlaces(view, *window.solver().surface(), *window.session().files().clouds.at(scanId()), scan());
    ASSERT_EQ(places.size(), 3U);
    wish(ScanWish::Align);
    const auto click = [&](std::size_t place, QPoint beside = {}) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, places[place].second.toPoint() + beside);
    };
    for (const std::size_t place : {0U, 0U, 1U, 1U, 2U})
        click(place);
    click(0, {0, 12}); // nearly where the first one belongs
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.prompt().contains(QStringLiteral("place 3")); }))
        << view.prompt().toStdString();
    EXPECT_EQ(view.tool(), CoverToolKind::AlignScan);
    EXPECT_TRUE(static_cast<const Placement&>(scan()) == before);
    click(2);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !(static_cast<const Placement&>(scan()) == before); }, 60000))
        << "the right one is taken instead";
}

TEST_F(ScanTest, UndoTakesBackWhatTheToolHasBegunFirst)
{
    ASSERT_TRUE(open(sample("armchair-scan")));
    ASSERT_TRUE(waitUntilSolved());
    Scan moved = scan();
    moved.enabled = false;
    window.document().commit(edits::replaceElement(window.document().design(), scanId(), makeElement(moved), {}));
    ASSERT_TRUE(waitUntilSolved());
    CoverView& view = window.coverView();
    const auto places =
        farPlaces(view, *window.solver().surface(), *window.session().files().clouds.at(scanId()), scan());
    ASSERT_FALSE(places.empty());
    wish(ScanWish::Align);
    QTest::mouseClick(&view, Qt::LeftButton, {}, places[0].second.toPoint());
    ASSERT_TRUE(view.prompt().contains(QStringLiteral("belongs"))) << view.prompt().toStdString();
    window.command("edit.undo")->trigger();
    EXPECT_FALSE(view.prompt().contains(QStringLiteral("belongs"))) << view.prompt().toStdString();
    EXPECT_FALSE(scan().enabled) << "the step before stays";
    window.command("edit.undo")->trigger();
    EXPECT_TRUE(scan().enabled) << "then that";
}

TEST_F(ScanTest, ShowAllShowsAScanThatIsElsewhere)
{
    ASSERT_TRUE(open(sample("armchair-scan")));
    ASSERT_TRUE(waitUntilSolved());
    Scan away = scan();
    away.enabled = false;
    away.position.x() += 3000;
    window.document().commit(edits::replaceElement(window.document().design(), scanId(), makeElement(away), {}));
    CoverNavigation& navigation = window.coverView().navigation();
    const Box3 box = window.coverView().shown().boxWithScans();
    EXPECT_FALSE(navigation.inPicture(box));
    window.command("view.fit-all")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return navigation.inPicture(box); }));
    EXPECT_GT(box.sizes().x(), 3000);
}

TEST_F(ScanTest, ItsCommandsAreInAMenuAndHaveKeys)
{
    ASSERT_TRUE(open(sample("room-scan")));
    ASSERT_TRUE(waitUntilSolved());
    for (const QAction* action :
         window.commands().list({"scan.align", "scan.place", "scan.cut", "scan.keep", "scan.keep-around-cover"}))
        EXPECT_FALSE(action->shortcut().isEmpty()) << action->objectName().toStdString();
    window.patternView().setFocus();
    window.selection().clear();
    const std::size_t cuts = scan().cuts.size();
    CoverView& view = window.coverView();
    QTest::keyClick(&window.patternView(), Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(view.tool(), CoverToolKind::CutScan);
    EXPECT_TRUE(window.selection().contains(scanId())) << "the only one";
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("cut away"))) << view.prompt().toStdString();

    press(view, {40, 40});
    move(view, {view.width() - 40, view.height() - 40}, Qt::LeftButton);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
    release(view, {view.width() - 40, view.height() - 40});
    EXPECT_EQ(scan().cuts.size(), cuts);
    EXPECT_TRUE(window.selection().contains(scanId())) << "it was the rectangle that was given up";

    QTest::keyClick(&window.patternView(), Qt::Key_K, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(view.tool(), CoverToolKind::CutScan);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape); // nobody counts them
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.tool() == CoverToolKind::Select; }));
    EXPECT_TRUE(window.selection().contains(scanId()));
    window.command("scan.remove-cuts")->trigger();
    EXPECT_TRUE(scan().cuts.empty());
    EXPECT_FALSE(window.command("scan.remove-cuts")->isEnabled());
}

TEST_F(ScanTest, AnImportedScanComesBackWithItsDesign)
{
    QTemporaryDir folder;
    ASSERT_TRUE(open(sample("box-cushion")));
    QFile file(folder.filePath("points.xyz"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("0 0 0\n100 0 0\n0 100 0\n100 100 50\n");
    file.close();
    Scan added;
    added.name = "Points";
    EXPECT_TRUE(window.session()
                    .addWithFile(file.fileName(), {nullptr, importCloud(file.fileName()).cloud}, added)
                    .empty());
    EXPECT_EQ(window.session().files().clouds.count(scanId()), 1U);
    EXPECT_TRUE(window.selection().contains(scanId()));
    window.command("edit.undo")->trigger();
    EXPECT_TRUE(window.session().files().clouds.empty());
    window.command("edit.redo")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.session().files().clouds.size() == 1; }, 5000));
}

} // namespace
} // namespace bolster
