// Edges, sizes and what lies on outlines, in the real window: by pointer, keys, fields and the menus of the right
// button.
#include "ContextMenus.h"
#include "Designer.h"
#include "ElementsView.h"
#include "ElidedLabel.h"
#include "Inspector.h"
#include "LayoutEdits.h"
#include "LengthEdits.h"
#include "OutlineEdits.h"
#include "SeamEdits.h"
#include "StatusLine.h"
#include "WindowTest.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QStatusBar>
#include <QTreeView>

#include <algorithm>

namespace bolster {
namespace {

class EdgesTest : public WindowTest {
protected:
    const Design& design() { return window.document().design(); }
    ElementId named(const std::string& name)
    {
        ElementId found{};
        for (const auto& [id, element] : design().elements())
            if (elementName(*element) == name)
                found = id;
        return found;
    }
    const BSpline2& outline(const std::string& name) { return design().find<Patch>(named(name))->outline; }
    Vec2 size(const std::string& name) { return outline(name).boundingBox().sizes(); }
    Box2 place(const std::string& name) { return edits::layoutBox(*design().find<Patch>(named(name))); }
    QString said() { return window.statusBar()->findChild<ElidedLabel*>()->fullText(); }

    /// Two rectangles beside each other, nothing sewn.
    void drawTwo()
    {
        add("Seat", {0, 0}, {500, 400});
        add("Side", {560, 0}, {300, 200});
        designer.choose({QStringLiteral("View"), QStringLiteral("Show all")});
        designer.zoom(-3);
    }
    void add(const std::string& name, const Vec2& at, const Vec2& size)
    {
        const BSpline2 outline(1, true, {at, at + Vec2(size.x(), 0), at + size, at + Vec2(0, size.y())});
        window.document().commit(edits::addPatch(design(), outline, name));
    }

    QMenu* contextMenu()
    {
        QMenu* shown = nullptr;
        (void)QTest::qWaitFor([&] {
            shown = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            return shown != nullptr;
        });
        return shown;
    }
    static QStringList entries(const QMenu& menu)
    {
        QStringList texts;
        for (const QAction* action : menu.actions())
            if (!action->isSeparator())
                texts << action->text().remove(u'&');
        return texts;
    }
    /// As the window system does: the press, then the wish for a menu.
    QMenu* rightClick(const Vec2& at)
    {
        PatternView& view = window.patternView();
        const QPoint pixel = patternPixel(at);
        QTest::mouseClick(&view, Qt::RightButton, {}, pixel);
        QContextMenuEvent wish(QContextMenuEvent::Mouse, pixel, view.mapToGlobal(pixel));
        QApplication::sendEvent(&view, &wish);
        return contextMenu();
    }

    Designer designer{window};
};

TEST_F(EdgesTest, AFancySeamStaysOnTheEdgeThatIsDragged)
{
    drawTwo();
    designer.key(Qt::Key_N);
    designer.click({100, 0});
    designer.click({100, 400});
    designer.key(Qt::Key_Return);
    ElementId seam{};
    design().each<FancySeam>([&](ElementId id, const FancySeam&) { seam = id; });
    ASSERT_NE(seam, ElementId{});
    const auto ends = [&] {
        const std::vector<Vec2>& points = design().find<FancySeam>(seam)->curve.points();
        return std::pair(points.front(), points.back());
    };
    ASSERT_LT(outline("Seat").closest(ends().second).distance, 1e-6) << "snapped";

    window.command("draw.snapping")->setChecked(false);
    designer.click({300, 400}); // the edge
    designer.drag({300, 400}, {300, 460});
    EXPECT_GT(size("Seat").y(), 450);
    EXPECT_LT(outline("Seat").closest(ends().second).distance, 1e-6);
    EXPECT_NEAR(ends().second.x(), 100, 1e-6);
    EXPECT_NEAR(ends().first.y(), 0, 1e-6);
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NEAR(ends().second.y(), 400, 1e-6);
    window.command("draw.snapping")->setChecked(true);
}

TEST_F(EdgesTest, TheSizeOfAPatchIsTyped)
{
    drawTwo();
    designer.click({700, 100});
    const Vec2 corner = place("Side").min();
    designer.setField(QStringLiteral("Size, mm"), QStringLiteral("350"), 0);
    designer.setField(QStringLiteral("Size, mm"), QStringLiteral("25 cm"), 1);
    EXPECT_NEAR(size("Side").x(), 350, 1e-6);
    EXPECT_NEAR(size("Side").y(), 250, 1e-6);
    EXPECT_LT((place("Side").min() - corner).norm(), 1e-6) << "its corner stays";
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NEAR(size("Side").y(), 200, 1e-6) << "one step each";

    // As it lies: what is wide before is high when it is turned.
    window.command("layout.turn-left")->trigger();
    designer.setField(QStringLiteral("Size, mm"), QStringLiteral("340"), 1);
    EXPECT_NEAR(place("Side").sizes().y(), 340, 1e-6);
    EXPECT_NEAR(place("Side").sizes().x(), 200, 1e-6);
    EXPECT_NEAR(size("Side").x(), 340, 1e-6) << "of its own outline";
}

TEST_F(EdgesTest, AClickSelectsAnEdgeAndItsLengthIsTyped)
{
    drawTwo();
    designer.click({250, 0});
    ASSERT_EQ(window.selection().edges().size(), 1u);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{named("Seat")});
    designer.setField(QStringLiteral("Edge length"), QStringLiteral("600"));
    EXPECT_NEAR(edits::edgeLength(design(), {named("Seat"), 0, 1}), 600, 1e-6);
    EXPECT_NEAR(edits::edgeLength(design(), {named("Seat"), 2, 3}), 500, 1e-6) << "only this one";
    EXPECT_NEAR(outline("Seat").points()[0].x() + outline("Seat").points()[1].x(), 500, 1e-6) << "about its middle";
    EXPECT_EQ(window.selection().edges().size(), 1u) << "it stays selected";

    window.patternView().setFocus();
    designer.key(Qt::Key_L);
    designer.enter(QStringLiteral("500"));
    EXPECT_NEAR(edits::edgeLength(design(), {named("Seat"), 0, 1}), 500, 1e-6) << "the key leads to the field";
    window.patternView().setFocus();
    designer.key(Qt::Key_Delete);
    EXPECT_NE(named("Seat"), ElementId{}) << "an edge is no patch";
    designer.key(Qt::Key_Escape);
    EXPECT_TRUE(window.selection().edges().empty());
    EXPECT_EQ(window.selection().elements(), Selection::Elements{named("Seat")});
}

TEST_F(EdgesTest, SelectedEdgesBecomeEquallyLong)
{
    drawTwo();
    EXPECT_FALSE(window.command("shape.equal-lengths")->isEnabled());
    designer.click({0, 200});                      // 400
    designer.click({560, 100}, Qt::ShiftModifier); // 200
    designer.click({700, 200}, Qt::ShiftModifier); // 300, shares a corner
    ASSERT_EQ(window.selection().edges().size(), 3u);
    ASSERT_TRUE(window.command("shape.equal-lengths")->isEnabled());
    designer.key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    for (const Selection::Edge& edge : window.selection().edges())
        EXPECT_NEAR(edits::edgeLength(design(), edge.stretch), 400, 1e-4);
    EXPECT_LT((size("Seat") - Vec2(500, 400)).norm(), 1e-6) << "the first one stays";
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT((size("Side") - Vec2(300, 200)).norm(), 1e-6) << "one step";
}

TEST_F(EdgesTest, TheSidesOfASeamBecomeEquallyLong)
{
    drawTwo();
    designer.key(Qt::Key_W);
    designer.sew({500, 200}, {560, 100});
    designer.key(Qt::Key_Escape);
    designer.click({500, 200});
    ASSERT_EQ(window.selection().edges().size(), 1u);
    designer.key(Qt::Key_Escape); // the seam alone
    ASSERT_TRUE(window.command("shape.equal-lengths")->isEnabled());
    designer.choose(
        {QStringLiteral("Pattern"), QStringLiteral("Points and edges"), QStringLiteral("Make equally long")});
    EXPECT_NEAR(edits::edgeLength(design(), {named("Side"), 3, 0}), 400, 1e-6);
    EXPECT_NEAR(edits::edgeLength(design(), {named("Seat"), 1, 2}), 400, 1e-6);
}

TEST_F(EdgesTest, NumbersAreTypedWhileScaling)
{
    drawTwo();
    designer.click({250, 200});
    PatternView& view = window.patternView();
    view.setFocus();
    // The handle is a little outside the corner.
    const QPoint handle = patternPixel({500, 400}) + QPoint(12, -12), to = handle + QPoint(20, -15);
    const auto begin = [&] {
        move(view, handle, Qt::NoButton);
        press(view, handle);
        move(view, to, Qt::LeftButton);
        ASSERT_TRUE(window.document().gestureRunning());
    };
    begin();
    designer.enter(QStringLiteral("620 x 450"));
    EXPECT_FALSE(window.document().gestureRunning()) << "Enter lets go";
    EXPECT_LT((size("Seat") - Vec2(620, 450)).norm(), 1e-6);
    release(view, to);
    EXPECT_LT((size("Seat") - Vec2(620, 450)).norm(), 1e-6) << "letting go of the button changes nothing";
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT((size("Seat") - Vec2(500, 400)).norm(), 1e-6);

    begin();
    designer.type(QStringLiteral("250"));
    release(view, to);
    EXPECT_LT((size("Seat") - Vec2(250, 200)).norm(), 1e-6) << "in proportion, and the button lets go, too";
}

TEST_F(EdgesTest, ATypedRectangleLiesOnNoOtherPatch)
{
    drawTwo();
    designer.drawRectangle({530, 440}, QStringLiteral("300 x 200"));
    designer.rename(QStringLiteral("Above"));
    EXPECT_LT((place("Above").min() - Vec2(530, 440)).norm(), 3) << "there is room to the upper right";
    designer.drawRectangle({530, -40}, QStringLiteral("90 x 100"));
    designer.rename(QStringLiteral("Below"));
    EXPECT_LT((place("Below").max() - Vec2(620, -40)).norm(), 3) << "to the lower right";
    // In the middle of a patch there is no room at all.
    designer.drawRectangle({250, 200}, QStringLiteral("120 x 80"));
    const QString text = said();
    designer.rename(QStringLiteral("Inner"));
    for (const char* other : {"Seat", "Side", "Above", "Below"})
        EXPECT_TRUE(place("Inner").intersection(place(other)).isEmpty()) << other;
    EXPECT_TRUE(text.contains(QStringLiteral("no room"))) << text.toStdString();

    // Where the pointer shows the way, that is meant; and that it lies on another one is said.
    designer.key(Qt::Key_R, Qt::ShiftModifier);
    designer.click({520, 200});
    designer.point({440, 150});
    designer.enter(QStringLiteral("100 x 50"));
    EXPECT_TRUE(said().contains(QStringLiteral("lies on Seat"))) << said().toStdString();
}

TEST_F(EdgesTest, TheRightButtonOffersWhatIsDoneWithWhatLiesThere)
{
    drawTwo();
    QMenu* menu = rightClick({250, 200});
    ASSERT_TRUE(menu);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{named("Seat")});
    EXPECT_TRUE(menu->actions().contains(window.command("edit.duplicate"))) << "the same action as in the menu bar";
    EXPECT_TRUE(menu->actions().contains(window.command("edit.delete")));
    EXPECT_FALSE(menu->actions().contains(window.command("seam.flip")));
    for (const QAction* action : menu->actions())
        EXPECT_TRUE(action->isEnabled()) << action->text().toStdString();
    menu->close();

    menu = rightClick({250, 0});
    ASSERT_TRUE(menu);
    EXPECT_EQ(window.selection().edges().size(), 1u);
    EXPECT_EQ(menu->actions().value(1), window.command("shape.edge-length"))
        << entries(*menu).join(u'|').toStdString();
    menu->close();

    designer.click({250, 200});
    menu = rightClick({0, 0}); // a corner
    ASSERT_TRUE(menu);
    EXPECT_EQ(window.selection().points().size(), 1u);
    EXPECT_TRUE(menu->actions().contains(window.command("shape.make-smooth")));
    menu->close();

    menu = rightClick({530, 300}); // nothing
    ASSERT_TRUE(menu);
    EXPECT_EQ(window.selection().points().size(), 1u) << "the selection is left alone";
    EXPECT_TRUE(menu->actions().contains(window.command("edit.select-all")));
    menu->close();
}

TEST_F(EdgesTest, TheRightButtonEndsWhatIsDrawn)
{
    drawTwo();
    const auto offered = [](const QMenu& menu, const QString& text) {
        const QList<QAction*> actions = menu.actions();
        const auto found = std::ranges::find_if(
            actions, [&](const QAction* action) { return action->text().remove(u'&').startsWith(text); });
        return found == actions.end() ? nullptr : *found;
    };
    designer.key(Qt::Key_O);
    QMenu* menu = rightClick({250, 200}); // nothing is begun
    ASSERT_TRUE(menu);
    EXPECT_TRUE(window.selection().elements().empty()) << "a tool that draws selects nothing";
    EXPECT_FALSE(offered(*menu, QStringLiteral("Finish")));
    menu->close();

    for (const Vec2& corner : {Vec2(0, -300), Vec2(200, -300), Vec2(200, -100), Vec2(0, -150)})
        designer.click(corner);
    menu = rightClick({250, 200});
    ASSERT_TRUE(menu);
    QAction* takeBack = offered(*menu, QStringLiteral("Take back"));
    ASSERT_TRUE(takeBack);
    EXPECT_TRUE(takeBack->text().contains(u'\t')) << "with its key";
    menu->close();
    takeBack->trigger();
    menu = rightClick({250, 200});
    ASSERT_TRUE(menu);
    QAction* end = offered(*menu, QStringLiteral("Finish"));
    ASSERT_TRUE(end);
    menu->close();
    end->trigger();
    ASSERT_EQ(window.selection().elements().size(), 1u) << "the new patch";
    EXPECT_EQ(design().find<Patch>(*window.selection().elements().begin())->outline.points().size(), 3u);
}

TEST_F(EdgesTest, TheMenusOfBothViewsHaveTheSameOrder)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    const auto offered = [&](QWidget& view) {
        const QPoint middle = view.rect().center();
        QContextMenuEvent wish(QContextMenuEvent::Keyboard, middle, view.mapToGlobal(middle));
        QApplication::sendEvent(&view, &wish);
        QMenu* menu = contextMenu();
        QStringList texts = menu ? entries(*menu) : QStringList();
        if (menu)
            menu->close();
        return texts;
    };
    const auto common = [](const QStringList& of, const QStringList& with) {
        QStringList found;
        std::ranges::copy_if(of, std::back_inserter(found),
                             [&](const QString& text) { return with.contains(text); });
        return found;
    };
    ElementId patch{}, seam{};
    design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    design().each<Seam>([&](ElementId id, const Seam&) { seam = id; });
    for (const Selection::Elements& selected : {Selection::Elements{}, {patch}, {seam}, {patch, seam}}) {
        window.selection().set(selected);
        const QStringList pattern = offered(window.patternView()), cover = offered(window.coverView());
        ASSERT_FALSE(common(pattern, cover).isEmpty());
        EXPECT_EQ(common(pattern, cover).join(u'|').toStdString(), common(cover, pattern).join(u'|').toStdString());
    }
}

TEST_F(EdgesTest, TheListOfElementsOffersWhatTheViewsOffer)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ElementId patch{}, seam{};
    design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    design().each<Seam>([&](ElementId id, const Seam&) { seam = id; });
    auto& list = *window.findChild<ElementsView*>();
    const auto menuOf = [&](ElementId id) {
        list.reveal(id);
        QTreeView& tree = list.tree();
        tree.scrollTo(tree.currentIndex());
        const QPoint at = tree.visualRect(tree.currentIndex()).center();
        QTest::mouseClick(tree.viewport(), Qt::RightButton, {}, at);
        QContextMenuEvent wish(QContextMenuEvent::Mouse, at, tree.viewport()->mapToGlobal(at));
        QApplication::sendEvent(tree.viewport(), &wish);
        return contextMenu();
    };
    QMenu* menu = menuOf(seam);
    ASSERT_TRUE(menu);
    for (const char* id : {"seam.flip", "shape.equal-lengths", "view.fit-selection", "edit.delete"})
        EXPECT_TRUE(menu->actions().contains(window.command(id))) << id;
    EXPECT_FALSE(menu->actions().contains(window.command("edit.duplicate")));
    menu->close();
    menu = menuOf(patch);
    ASSERT_TRUE(menu);
    for (const char* id : {"edit.duplicate", "view.hide", "edit.rename", "edit.delete"})
        EXPECT_TRUE(menu->actions().contains(window.command(id))) << id;
    menu->close();
}

TEST_F(EdgesTest, TheRightButtonTurnsTheCoverOrOpensItsMenu)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilSolved());
    CoverView& view = window.coverView();
    const Vec2 at = *view.navigation().camera().pixel(window.solver().surface()->boundingBox().center());
    const QPoint pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    QTest::mouseClick(&view, Qt::RightButton, {}, pixel);
    QMenu* menu = contextMenu();
    ASSERT_TRUE(menu);
    ASSERT_EQ(window.selection().elements().size(), 1u);
    EXPECT_TRUE(design().find<Patch>(*window.selection().elements().begin()));
    EXPECT_TRUE(menu->actions().contains(window.command("view.hide")));
    menu->close();

    QTest::mouseClick(&view, Qt::RightButton, {}, QPoint(5, 5));
    menu = contextMenu();
    ASSERT_TRUE(menu);
    EXPECT_TRUE(menu->actions().contains(window.command("view.fit-all")));
    menu->close();

    const double before = view.navigation().camera().azimuth;
    QTest::mousePress(&view, Qt::RightButton, {}, pixel);
    move(view, pixel + QPoint(60, 0), Qt::RightButton);
    QTest::mouseRelease(&view, Qt::RightButton, {}, pixel + QPoint(60, 0));
    EXPECT_NE(view.navigation().camera().azimuth, before);
    EXPECT_FALSE(QApplication::activePopupWidget()) << "it was a turn";
}

} // namespace
} // namespace bolster
