// Everything can be reached by keys, and no two things by the same.
#include "Ask.h"
#include "WindowTest.h"

#include "CommandList.h"
#include "CoverView.h"
#include "ElementsView.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Inspector.h"
#include "PaneSizes.h"

#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QProgressDialog>
#include <QTemporaryDir>
#include <QTreeView>

#include <set>

namespace bolster {
namespace {

class KeyboardTest : public WindowTest {
protected:
    static QChar mnemonic(const QString& text)
    {
        const QKeySequence keys = QKeySequence::mnemonic(text);
        return keys.isEmpty() ? QChar() : QChar(static_cast<char16_t>(keys[0].key()));
    }

    /// Every menu for itself.
    static void checkMnemonics(const QList<QAction*>& actions, const QString& where)
    {
        QMap<QChar, QString> taken;
        for (const QAction* action : actions) {
            if (action->menu())
                checkMnemonics(action->menu()->actions(), where + '/' + action->text());
            const QChar key = mnemonic(action->text());
            if (key.isNull())
                continue;
            EXPECT_FALSE(taken.contains(key)) << where.toStdString() << ": " << action->text().toStdString()
                                              << " and " << taken[key].toStdString();
            taken[key] = action->text();
        }
    }

    /// The part of the window that has the keyboard.
    QDockWidget* part()
    {
        for (QDockWidget* dock : window.docks().all())
            if (QApplication::focusWidget() && dock->isAncestorOf(QApplication::focusWidget()))
                return dock;
        return nullptr;
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window, key, modifiers);
    }
};

TEST_F(KeyboardTest, MenusHaveEachMnemonicOnce)
{
    checkMnemonics(window.menuBar()->actions(), {});
}

TEST_F(KeyboardTest, CommandsHaveTooltipsAndShortcutsOfTheirOwn)
{
    QMap<QString, QString> taken;
    for (const MenuEntry& command : commandsOf(*window.menuBar())) {
        EXPECT_FALSE(command.action->toolTip().isEmpty()) << command.text.toStdString();
        for (const QKeySequence& keys : command.action->shortcuts()) {
            const QString name = keys.toString();
            EXPECT_FALSE(taken.contains(name))
                << name.toStdString() << ": " << command.text.toStdString() << " and " << taken[name].toStdString();
            taken[name] = command.text;
        }
    }
    EXPECT_GT(taken.size(), 30);
}

TEST_F(KeyboardTest, EveryActionIsInAMenu)
{
    QSet<const QAction*> offered; // submenus, too
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>())
        for (const QAction* action : menu->actions())
            offered.insert(action);
    for (const QAction* action : window.commands().findChildren<QAction*>(Qt::FindDirectChildrenOnly))
        EXPECT_TRUE(offered.contains(action)) << action->objectName().toStdString();
}

TEST_F(KeyboardTest, F6LeadsThroughTheParts)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.patternView().setFocus();
    const Docks& docks = window.docks();
    key(Qt::Key_F6);
    EXPECT_EQ(part(), docks.cover);
    key(Qt::Key_F6);
    EXPECT_EQ(part(), docks.elements);
    key(Qt::Key_F6); // the history lies behind the elements
    EXPECT_EQ(part(), docks.inspector);
    key(Qt::Key_F6);
    EXPECT_EQ(part(), docks.pattern);
    key(Qt::Key_F6, Qt::ShiftModifier);
    EXPECT_EQ(part(), docks.inspector);
}

TEST_F(KeyboardTest, TabAndF6KeepToWhatIsSeen)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    Docks& docks = window.docks();
    Docks::reveal(docks.cutting);
    Docks::reveal(docks.problems); // before the other one
    docks.elements->raise();       // before History, Seams and Fabrics
    takeKeyboard();
    ASSERT_TRUE(QTest::qWaitFor([&] { return isInFront(*docks.problems) && !isInFront(*docks.cutting); }));
    docks.problems->widget()->setFocus();
    std::set<QDockWidget*> tabbed, walked;
    for (int k = 0; k < 150; ++k) {
        const bool keepsTab = part() == docks.pattern || part() == docks.cover;
        key(keepsTab ? Qt::Key_F6 : k < 75 ? Qt::Key_Tab : Qt::Key_Backtab);
        if (QDockWidget* dock = part()) {
            EXPECT_TRUE(isInFront(*dock)) << dock->objectName().toStdString();
            tabbed.insert(dock);
        }
    }
    EXPECT_GE(tabbed.size(), 3u);
    for (int k = 0; k < 8; ++k) {
        key(Qt::Key_F6);
        walked.insert(part());
    }
    EXPECT_TRUE(walked.contains(docks.problems));
    EXPECT_FALSE(walked.contains(docks.cutting) || walked.contains(docks.history));
}

TEST_F(KeyboardTest, TabWalksThroughThePattern)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    PatternView& view = window.patternView();
    view.setFocus();
    QList<ElementId> patches;
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { patches << id; });
    key(Qt::Key_Tab);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{patches[0]});
    key(Qt::Key_Tab);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{patches[1]});
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(window.selection().elements(), Selection::Elements{patches.back()}) << "round again";

    window.selection().set({}, {{patches[0], 3}}); // the last of four
    key(Qt::Key_Tab);
    EXPECT_EQ(window.selection().points(), (Selection::Points{{patches[0], 0}}));
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(window.selection().points(), (Selection::Points{{patches[0], 3}}));
    EXPECT_TRUE(view.hasFocus());
}

TEST_F(KeyboardTest, EnterInTheListLeadsToTheProperties)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    auto& elements = *window.findChild<ElementsView*>();
    window.selection().set({ElementId{2}});
    elements.tree().setFocus();
    QTest::keyClick(&elements.tree(), Qt::Key_Return);
    EXPECT_EQ(part(), window.docks().inspector);
    EXPECT_TRUE(qobject_cast<QLineEdit*>(QApplication::focusWidget())) << "its name";
}

TEST_F(KeyboardTest, TheWindowHasItAgainAfterAProgressThatWasShown)
{
    window.activateWindow();
    QProgressDialog* progress = openProgress(&window, QStringLiteral("Reading ...")).dialog;
    progress->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(progress));
    QTest::qWait(30); // the window manager is about to give it the keyboard
    closeProgress(progress);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.isActiveWindow(); }, 10000));
}

TEST_F(KeyboardTest, EnterAfterANameStaysInTheList)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    auto& elements = *window.findChild<ElementsView*>();
    window.selection().set({ElementId{2}});
    key(Qt::Key_F2);
    const auto editing = [&] { return elements.tree().findChild<QLineEdit*>() != nullptr; };
    ASSERT_TRUE(editing());
    QTest::keyClicks(QApplication::focusWidget(), "Seat");
    key(Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !editing(); }));
    EXPECT_EQ(part(), window.docks().elements) << "what is typed next must not get into the name";
    EXPECT_EQ(window.document().design().find<Patch>(ElementId{2})->name, "Seat");
}

TEST_F(KeyboardTest, EscapeEndsATool)
{
    for (QWidget* place : {static_cast<QWidget*>(&window.patternView()),
                           static_cast<QWidget*>(window.docks().history->findChild<HistoryView*>())}) {
        window.patternView().setTool(PatternToolKind::FancySeam);
        Docks::reveal(window.docks().history);
        place->setFocus();
        ASSERT_TRUE(QTest::qWaitFor([&] { return place->hasFocus(); }));
        QTest::keyClick(place, Qt::Key_Escape);
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    }
}

TEST_F(KeyboardTest, F2NamesAVersionInTheHistory)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.selection().set({ElementId{2}});
    window.command("layout.turn-left")->trigger();
    Docks::reveal(window.docks().history);
    HistoryView& history = window.findChild<HistoryPanel*>()->view();
    history.setFocus();
    QTest::keyClick(&history, Qt::Key_F2);
    auto* editor = history.findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, "Belt notch");
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.document().history().node(1).name == "Belt notch"; }));
    EXPECT_EQ(window.document().history().current(), 1);
}

TEST_F(KeyboardTest, ShiftF2NamesTheBranchOfTheHistory)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.selection().set({ElementId{2}});
    EXPECT_FALSE(window.command("edit.name-branch")->isEnabled());
    window.command("layout.turn-left")->trigger();
    window.command("edit.undo")->trigger();
    window.command("layout.turn-right")->trigger();
    window.command("layout.turn-right")->trigger();
    ASSERT_TRUE(window.command("edit.name-branch")->isEnabled());
    key(Qt::Key_F2, Qt::ShiftModifier);
    EXPECT_EQ(part(), window.docks().history);
    HistoryView& history = window.findChild<HistoryPanel*>()->view();
    auto* editor = history.findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, "Turned right");
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.document().history().node(2).branch == "Turned right"; }));
    EXPECT_EQ(window.document().history().current(), 3);

    // It is in the journal already.
    const QTemporaryDir folder;
    ASSERT_TRUE(window.session().journal().journal());
    ASSERT_EQ(window.session().journal().journal()->save(folder.filePath("a.bolster")).english(), "");
    EXPECT_EQ(openProject(folder.filePath("a.bolster")).history.node(2).branch, "Turned right");
}

} // namespace
} // namespace bolster
