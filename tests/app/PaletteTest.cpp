// The command palette: everything that the menus offer, by typing.
#include "WindowTest.h"

#include "CommandPalette.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

namespace bolster {
namespace {

class PaletteTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        QSettings().remove(QStringLiteral("palette"));
        window.patternView().setFocus();
    }

    CommandPalette& palette() { return window.commandPalette(); }

    void openPalette()
    {
        QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(palette().isVisible());
        ASSERT_TRUE(palette().field().hasFocus());
    }

    void type(const QString& text) { QTest::keyClicks(&palette().field(), text); }
    void key(Qt::Key key) { QTest::keyClick(&palette().field(), key); }
    QString row(int i)
    {
        const QListWidgetItem* item = palette().list().item(i);
        return item ? item->text() : QString();
    }
    QString first() { return row(0); }
};

TEST_F(PaletteTest, FindsByPartsOfWordsAndDoesWithEnter)
{
    openPalette();
    EXPECT_GT(palette().list().count(), 40);
    type("tri");
    EXPECT_EQ(first(), "Triangulation");
    const bool before = window.command("layer.mesh")->isChecked();
    key(Qt::Key_Return);
    EXPECT_NE(window.command("layer.mesh")->isChecked(), before);
    EXPECT_FALSE(palette().isVisible());
    EXPECT_TRUE(window.patternView().hasFocus());

    openPalette();
    type("view top"); // a menu and a text
    EXPECT_EQ(first(), "Top");
    palette().field().clear();
    type("grph"); // letters that follow each other
    EXPECT_EQ(palette().list().item(0)->flags(), Qt::NoItemFlags) << "nothing of the kind";
    palette().field().clear();
    type("exsrf");
    EXPECT_EQ(first(), "Export surface");
    key(Qt::Key_Escape);
    EXPECT_FALSE(palette().isVisible());
}

TEST_F(PaletteTest, LettersAreNotPickedFromAnywhereInTheNamesOfFiles)
{
    QMenu* menu = window.menuBar()->addMenu("Upholstery");
    menu->addAction("&1  armchair, mirrored later.json\t/work/samples");
    menu->addAction("&2  my odd mirror.json\t/work/samples");
    openPalette();
    type("samples");
    EXPECT_NE(first(), "armchair, mirrored later.json");
    palette().field().clear();
    type("arirored");
    EXPECT_NE(first(), "armchair, mirrored later.json") << "not from the middle of a word";
    palette().field().clear();
    type("armmir");
    EXPECT_EQ(first(), "armchair, mirrored later.json") << "without its number and its folder";
}

TEST_F(PaletteTest, OffersFirstWhatWasDoneLast)
{
    openPalette();
    type("ground");
    key(Qt::Key_Return);
    openPalette();
    type("grid");
    key(Qt::Key_Return);
    openPalette();
    EXPECT_EQ(first(), "Grid");
    EXPECT_EQ(row(1), "Ground");
    key(Qt::Key_Down);
    const bool before = window.command("layer.ground")->isChecked();
    key(Qt::Key_Return);
    EXPECT_NE(window.command("layer.ground")->isChecked(), before);
    window.command("layer.ground")->setChecked(true);
    window.command("layer.grid")->setChecked(true);
}

TEST_F(PaletteTest, ShowsWhatCannotBeDoneAndDoesNotDoIt)
{
    ASSERT_FALSE(window.command("edit.delete")->isEnabled());
    openPalette();
    type("delete");
    ASSERT_EQ(first(), "Delete");
    key(Qt::Key_Return);
    EXPECT_TRUE(palette().isVisible()) << "nothing happened";
    press(window.patternView(), {5, 5});
    release(window.patternView(), {5, 5});
    EXPECT_FALSE(palette().isVisible()) << "a click elsewhere closes it";
}

TEST_F(PaletteTest, FindsWhatIsAddedToAMenuLater)
{
    QMenu* menu = window.menuBar()->addMenu("Upholstery")->addMenu("Extras");
    int done = 0;
    QObject::connect(menu->addAction("Stuff with horsehair"), &QAction::triggered, menu, [&] { ++done; });
    openPalette();
    type("horse extra");
    EXPECT_EQ(first(), "Stuff with horsehair");
    key(Qt::Key_Return);
    EXPECT_EQ(done, 1);
}

TEST_F(PaletteTest, ActionsHaveIdsOfTheirOwn)
{
    QSet<QString> ids;
    for (const QAction* action : window.commands().findChildren<QAction*>(Qt::FindDirectChildrenOnly)) {
        EXPECT_FALSE(action->objectName().isEmpty());
        EXPECT_FALSE(ids.contains(action->objectName())) << action->objectName().toStdString();
        ids.insert(action->objectName());
    }
    EXPECT_EQ(window.command("file.import-frame")->objectName(), "file.import-frame");
    EXPECT_EQ(window.command("view.from-front")->objectName(), "view.from-front");
}

} // namespace
} // namespace bolster
