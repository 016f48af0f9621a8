// The list of the worst spots, through the window.
#include "WindowTest.h"

#include "CoverPlaces.h"
#include "Crosshair.h"
#include "MapLegend.h"
#include "MapLink.h"
#include "SpotsPanel.h"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>

namespace bolster {
namespace {

class SpotsTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        ASSERT_TRUE(waitUntilAtRest()); // it does not move any more unless somebody edits
    }

    const std::vector<MapLink::Spot>& spots() { return window.maps().spots(); }
    bool listStrain()
    {
        Docks::reveal(window.docks().spots);
        map(CoverMap::Kind::Strain)->setChecked(true);
        return QTest::qWaitFor([&] { return table().isVisible() && !spots().empty(); }, 30000);
    }
    QTreeWidget& table() { return window.spotsPanel().table(); }
    QWidget* hint() { return window.spotsPanel().findChild<QLabel*>(QStringLiteral("spots-hint")); }
    QPushButton* offer() { return window.spotsPanel().findChild<QPushButton*>(QStringLiteral("show-strain")); }
    QTreeWidgetItem* row(std::size_t i) { return table().topLevelItem(static_cast<int>(i)); }
    std::vector<int> selectedRows()
    {
        std::vector<int> rows;
        for (QTreeWidgetItem* item : table().selectedItems())
            rows.push_back(table().indexOfTopLevelItem(item));
        return rows;
    }

    /// The rows are what was measured, and none is marked without reason.
    void expectListed()
    {
        ASSERT_EQ(table().topLevelItemCount(), static_cast<int>(spots().size()));
        for (std::size_t i = 0; i < spots().size(); ++i) {
            const MapLink::Spot& spot = spots()[i];
            EXPECT_EQ(row(i)->text(SpotsPanel::Where), spot.patch);
            EXPECT_EQ(row(i)->text(SpotsPanel::Value), window.maps().figure(spot.value));
            EXPECT_EQ(row(i)->text(SpotsPanel::Limit), window.maps().figure(spot.allowed));
            EXPECT_EQ(row(i)->toolTip(SpotsPanel::Where), spot.text);
            EXPECT_EQ(!row(i)->icon(SpotsPanel::Limit).isNull(), spot.over());
            EXPECT_EQ(row(i)->font(SpotsPanel::Value).bold(), spot.over());
        }
    }

    bool marksThe(const CoverPoint& place)
    {
        CoverPlaces places;
        places.setSurface(window.solver().surface());
        const Patch& patch = *window.document().design().find<Patch>(place.patch);
        const auto on = [](const QWidget& view, QPointF pixel) {
            const auto* mark = view.findChild<Crosshair*>();
            return mark->isVisible() && (QPointF(mark->geometry().center()) - pixel).manhattanLength() < 4;
        };
        const Vec2 cover = *window.coverView().navigation().camera().pixel(*places.onCover(place));
        return on(window.patternView(), patternPixel(toLayout(patch, place.outline))) &&
               on(window.coverView(), {cover.x(), cover.y()});
    }

    void limit(ElementId patch, double percent)
    {
        const Design& design = window.document().design();
        const Patch& before = *design.find<Patch>(patch);
        Fabric fabric = *design.find<Fabric>(before.fabric);
        fabric.limits = {percent, percent, percent};
        Patch after = before;
        after.fabric = design.nextId();
        window.document().commit(
            {{},
             {{after.fabric, nullptr, makeElement(fabric)}, {patch, design.element(patch), makeElement(after)}}});
        const float allowed = static_cast<float>(percent);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                if (!waitUntilAtRest())
                    return false;
                const std::vector<float>& now = window.maps().map()->allowed; // replaced with every measurement
                return std::ranges::find(now, allowed) != now.end();
            },
            60000));
    }
};

TEST_F(SpotsTest, AMapHasOneLegend)
{
    const auto* onCover = window.coverView().findChild<MapLegend*>();
    const auto* onPattern = window.patternView().findChild<MapLegend*>();
    map(CoverMap::Kind::Strain)->setChecked(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return onCover->isVisible(); }, 30000));
    EXPECT_FALSE(onPattern->isVisible()) << "both views are seen";
    window.docks().cover->close();
    EXPECT_TRUE(onPattern->isVisible());
    window.docks().cover->toggleViewAction()->trigger();
    EXPECT_TRUE(onCover->isVisible());
    EXPECT_FALSE(onPattern->isVisible());
    window.command("window.reset-layout")->trigger();
}

TEST_F(SpotsTest, TheNumberUnderARestingPointerFollowsTheCover)
{
    ASSERT_TRUE(listStrain());
    const MapLink::Spot worst = spots().front();
    const Patch before = *window.document().design().find<Patch>(worst.place.patch);
    const auto* legend = window.coverView().findChild<MapLegend*>();
    window.patternView().patchPointed(worst.place);
    const QString first = legend->reading();
    ASSERT_TRUE(first.contains(window.maps().figure(worst.value))) << qPrintable(first);
    Patch pressed = before;
    pressed.pressure += 0.4;
    window.document().commit({{}, {{worst.place.patch, nullptr, makeElement(pressed)}}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return legend->reading() != first; }, 60000)) << qPrintable(first);
    window.command("edit.undo")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return legend->reading() == first; }, 60000))
        << qPrintable(legend->reading());
}

TEST_F(SpotsTest, WithoutAMapItIsSaidHowToGetOne)
{
    EXPECT_FALSE(window.docks().spots->isVisible()) << "not before somebody asks for it";
    window.command("map.spot-list")->trigger();
    ASSERT_TRUE(window.docks().spots->isVisible());
    EXPECT_FALSE(table().isVisible());
    EXPECT_TRUE(hint()->isVisible());
    ASSERT_TRUE(offer()->isVisible());
    EXPECT_TRUE(offer()->hasFocus());
    QTest::keyClick(offer(), Qt::Key_Space);
    EXPECT_TRUE(map(CoverMap::Kind::Strain)->isChecked());
    ASSERT_TRUE(QTest::qWaitFor([&] { return table().isVisible(); }, 30000));
    EXPECT_FALSE(hint()->isVisible());
    EXPECT_TRUE(table().hasFocus()) << "the keyboard stays in the panel";
    expectListed();

    map(CoverMap::Kind::Curvature)->trigger(); // has no worst spots
    ASSERT_TRUE(QTest::qWaitFor([&] { return offer()->isVisible(); }, 30000));
    EXPECT_FALSE(table().isVisible());
    map(CoverMap::Kind::Shear)->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return table().isVisible(); }, 30000));
    expectListed();
    map(CoverMap::Kind::Shear)->trigger();
    EXPECT_TRUE(offer()->isVisible()) << "no map again";
}

TEST_F(SpotsTest, TheCrossIsTakenAwayWithItsMap)
{
    ASSERT_TRUE(listStrain());
    table().setFocus();
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualItemRect(row(0)).center());
    ASSERT_TRUE(marksThe(spots()[0].place));
    const auto crossShown = [&] {
        return window.patternView().findChild<Crosshair*>()->isVisible() ||
               window.coverView().findChild<Crosshair*>()->isVisible();
    };
    map(CoverMap::Kind::Shear)->trigger();
    EXPECT_FALSE(crossShown());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !spots().empty(); }, 30000));
    QCoreApplication::processEvents(); // the list is filled
    EXPECT_TRUE(selectedRows().empty()) << "nothing of this map was chosen";
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualItemRect(row(0)).center());
    ASSERT_TRUE(crossShown());
    map(CoverMap::Kind::Shear)->trigger();
    EXPECT_FALSE(crossShown()) << "no map, no place";
}

TEST_F(SpotsTest, ADesignWithoutACoverHasNone)
{
    ASSERT_TRUE(listStrain());
    window.session().startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return hint()->isVisible(); }, 30000));
    EXPECT_TRUE(spots().empty()) << "those of the last design are gone";
    EXPECT_FALSE(table().isVisible());
    EXPECT_FALSE(offer()->isVisible()) << "the map is on";
}

TEST_F(SpotsTest, WalkingThroughTheListShowsThePlacesInBothWindows)
{
    ASSERT_TRUE(listStrain());
    expectListed();
    ASSERT_GE(spots().size(), 3u);
    table().setFocus();
    EXPECT_TRUE(selectedRows().empty()) << "to come by is not to choose";
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualItemRect(row(0)).center());
    EXPECT_TRUE(marksThe(spots()[0].place));
    QTest::keyClick(&table(), Qt::Key_Down);
    EXPECT_EQ(selectedRows(), std::vector{1});
    EXPECT_TRUE(marksThe(spots()[1].place));

    window.patternView().showPlace({});
    window.coverView().showPlace({});
    EXPECT_FALSE(marksThe(spots()[1].place));
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_TRUE(marksThe(spots()[1].place)) << "once more";

    auto* menu = window.menuBar()->findChild<QMenu*>(QStringLiteral("map.worst"));
    emit menu->aboutToShow();
    menu->actions()[2]->trigger();
    EXPECT_TRUE(marksThe(spots()[2].place)) << "the menu does the same";
}

TEST_F(SpotsTest, TheChosenSpotStaysChosenWhileTheListChanges)
{
    ASSERT_TRUE(listStrain());
    const ElementId worst = spots()[0].place.patch;
    std::size_t at = spots().size() - 1; // the last one elsewhere
    while (at > 0 && spots()[at].place.patch == worst)
        --at;
    ASSERT_GT(at, 0u);
    const MapLink::Spot chosen = spots()[at];
    table().setCurrentItem(row(at));
    ASSERT_TRUE(marksThe(chosen.place));
    const QTreeWidgetItem* first = row(0);

    limit(worst, 90); // nothing there is bad any more
    expectListed();
    EXPECT_EQ(row(0), first) << "rows are not made anew";
    ASSERT_EQ(selectedRows().size(), 1u);
    const auto now = static_cast<std::size_t>(selectedRows()[0]);
    EXPECT_LT(now, at) << "those above it are gone";
    EXPECT_EQ(spots()[now].place.patch, chosen.place.patch);
    EXPECT_LT((spots()[now].place.outline - chosen.place.outline).norm(), MapLink::apart);

    limit(chosen.place.patch, 100);
    limit(worst, 0.01);
    expectListed();
    EXPECT_TRUE(spots()[0].over());
    EXPECT_EQ(spots()[0].place.patch, worst);
    for (const int i : selectedRows())
        EXPECT_EQ(spots()[static_cast<std::size_t>(i)].place.patch, chosen.place.patch) << "or it is not listed";
}

TEST_F(SpotsTest, TheMarkStaysOnTheCoverThatMoves)
{
    ASSERT_TRUE(listStrain());
    table().setCurrentItem(row(0));
    const CoverPoint place = spots()[0].place;
    ASSERT_TRUE(marksThe(place));
    const Design& design = window.document().design();
    std::vector<Change> changes;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        Patch after = patch;
        after.pressure = 2 * patch.pressure + 0.05;
        changes.push_back({id, design.element(id), makeElement(after)});
    });
    const std::uint64_t before = meshRevision();
    window.document().commit({{}, changes});
    ASSERT_TRUE(QTest::qWaitFor([&] { return meshRevision() != before && waitUntilAtRest(); }, 60000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return marksThe(place); }, 10000));
}

} // namespace
} // namespace bolster
