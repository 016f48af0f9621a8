// Keys that the user chooses.
#include "WindowTest.h"

#include "CommandList.h"
#include "ShortcutsDialog.h"

#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTreeWidget>

namespace bolster {
namespace {

class ShortcutsTest : public WindowTest {
protected:
    void TearDown() override
    {
        QSettings().remove(QStringLiteral("shortcuts"));
        WindowTest::TearDown();
    }

    ShortcutsDialog* dialog()
    {
        window.command("help.edit-shortcuts")->trigger();
        auto* found = window.findChild<ShortcutsDialog*>();
        EXPECT_TRUE(found && QTest::qWaitForWindowExposed(found));
        return found;
    }

    /// Chooses the command and presses keys in the field.
    static void choose(ShortcutsDialog& dialog, const QString& command)
    {
        auto& tree = *dialog.findChild<QTreeWidget*>();
        const auto found = tree.findItems(command, Qt::MatchExactly | Qt::MatchRecursive, 0);
        ASSERT_EQ(found.size(), 1) << command.toStdString();
        tree.setCurrentItem(found.front());
    }
    static void pressKeys(ShortcutsDialog& dialog, Qt::Key key, Qt::KeyboardModifiers modifiers)
    {
        auto* field = dialog.findChild<QKeySequenceEdit*>();
        QSignalSpy done(field, &QKeySequenceEdit::editingFinished);
        QTest::keyClick(field, key, modifiers);
        EXPECT_TRUE(done.wait()); // the field waits for more keys
    }
    static QPushButton* button(ShortcutsDialog& dialog, const QString& text)
    {
        for (QPushButton* button : dialog.findChildren<QPushButton*>())
            if (button->text() == text)
                return button;
        return nullptr;
    }
};

TEST_F(ShortcutsTest, AreTakenAtOnceKeptAndReset)
{
    ShortcutsDialog& keys = *dialog();
    choose(keys, "Isolate selected");
    pressKeys(keys, Qt::Key_Y, Qt::AltModifier);
    EXPECT_EQ(window.command("view.isolate")->shortcut(), QKeySequence("Alt+Y"));
    EXPECT_EQ(window.command("view.isolate")->toolTip(), "Isolate selected (Alt+Y)");
    EXPECT_EQ(QSettings().value("shortcuts/view.isolate").toString(), "Alt+Y");
    {
        MainWindow again;
        EXPECT_EQ(again.command("view.isolate")->shortcut(), QKeySequence("Alt+Y")) << "at the next start";
        EXPECT_EQ(again.command("view.isolate")->toolTip(), "Isolate selected (Alt+Y)");
    }
    button(keys, "&Reset")->click();
    EXPECT_EQ(window.command("view.isolate")->shortcut(), QKeySequence("Shift+I"));
    EXPECT_FALSE(QSettings().contains("shortcuts/view.isolate")) << "only differences are kept";
    keys.close();
}

TEST_F(ShortcutsTest, OfAnotherCommandAreTakenOverOnlyOnWish)
{
    ShortcutsDialog& keys = *dialog();
    choose(keys, "Isolate selected");
    pressKeys(keys, Qt::Key_Y, Qt::ControlModifier); // the second one of redo
    EXPECT_EQ(window.command("view.isolate")->shortcut(), QKeySequence("Shift+I"));
    ASSERT_TRUE(button(keys, "&Take them over")->isVisible());
    button(keys, "&Take them over")->click();
    EXPECT_EQ(window.command("view.isolate")->shortcut(), QKeySequence("Ctrl+Y"));
    EXPECT_EQ(window.command("edit.redo")->shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+Shift+Z")});
    pressKeys(keys, Qt::Key_Left, Qt::NoModifier);
    EXPECT_EQ(window.command("view.isolate")->shortcut(), QKeySequence("Ctrl+Y")) << "the arrows move things";
    button(keys, "Reset &all")->click();
    EXPECT_EQ(window.command("edit.redo")->shortcuts().size(), 2);
    EXPECT_TRUE(QSettings().allKeys().filter("shortcuts/").isEmpty());
    keys.close();
}

TEST_F(ShortcutsTest, AreFoundByNameAndByKey)
{
    ShortcutsDialog& keys = *dialog();
    auto& tree = *keys.findChild<QTreeWidget*>();
    const auto shown = [&] {
        QStringList names;
        for (QTreeWidgetItemIterator at(&tree, QTreeWidgetItemIterator::NotHidden); *at; ++at)
            if ((*at)->parent() && !(*at)->parent()->isHidden())
                names << (*at)->text(0);
        return names;
    };
    EXPECT_GT(shown().size(), 40);
    QTest::keyClicks(keys.findChild<QLineEdit*>(), "Ctrl+Shift+S");
    EXPECT_EQ(shown(), QStringList{"Save as"});
    keys.findChild<QLineEdit*>()->setText("pattern left");
    EXPECT_EQ(shown().front(), QStringLiteral("Turn 90\u00b0 to the left"));
    keys.close();
}

} // namespace
} // namespace bolster
