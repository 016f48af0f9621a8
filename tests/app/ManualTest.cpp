// F1 opens the manual at what one is doing; its links and headings are found.
#include "WindowTest.h"

#include "CoverView.h"
#include "ElementEdits.h"
#include "ManualWindow.h"
#include "NumberBox.h"
#include "PatternView.h"
#include "ProblemsView.h"
#include "Samples.h"

#include <QDir>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QScreen>
#include <QTextBlock>
#include <QTextBrowser>

namespace bolster {
namespace {

class ManualTest : public WindowTest {
protected:
    ManualWindow* manual()
    {
        const auto found = window.findChildren<ManualWindow*>();
        for (ManualWindow* one : found)
            if (one->isVisible())
                return one;
        return nullptr;
    }
};

TEST_F(ManualTest, OpensAtTheToolOfTheView)
{
    takeKeyboard();
    window.patternView().setFocus();
    window.command("tool.sew")->trigger();
    QTest::keyClick(&window.patternView(), Qt::Key_F1);
    ASSERT_TRUE(manual());
    EXPECT_TRUE(manual()->place().startsWith("sewing.md")) << manual()->place().toStdString();
    // The same window goes on to another place, and back.
    takeKeyboard();
    window.patternView().setFocus();
    window.command("tool.select")->trigger();
    QTest::keyClick(&window.patternView(), Qt::Key_F1);
    EXPECT_FALSE(manual()->place().startsWith("sewing.md"));
    takeKeyboard(*manual());
    QTest::keyClick(manual(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return manual()->place().startsWith("sewing.md"); })) << "as if clicked";
}

TEST_F(ManualTest, OpensOverADialog)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.command("file.export-pattern")->trigger();
    QWidget* dialog = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        dialog = QApplication::activeWindow();
        return dialog && dialog != &window;
    }));
    QTest::keyClick(dialog->focusWidget() ? dialog->focusWidget() : dialog, Qt::Key_F1);
    ASSERT_TRUE(manual());
    EXPECT_TRUE(manual()->place().startsWith("to-the-cutter.md")) << manual()->place().toStdString();
    manual()->close();
    dialog->close();
}

TEST_F(ManualTest, OpensAtAQuestion)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.document().commit(edits::addElement(window.document().design(), makeElement(Fabric{})));
    takeKeyboard();
    window.close();
    QMessageBox* box = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        box = qobject_cast<QMessageBox*>(QApplication::activeWindow());
        return box != nullptr;
    }));
    QTest::keyClick(box->focusWidget() ? box->focusWidget() : box, Qt::Key_F1);
    const auto shown = box->findChildren<ManualWindow*>();
    ASSERT_EQ(shown.size(), 1);
    EXPECT_EQ(shown.front()->place(), "saving.md#unsaved-work");
    shown.front()->close();
    box->reject();
}

TEST_F(ManualTest, OpensAtAField)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ElementId patch{};
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    window.selection().set({patch});
    auto* field = window.findChild<QWidget*>("field.pressure");
    ASSERT_TRUE(QTest::qWaitFor([&] { return (field = window.findChild<QWidget*>("field.pressure")) != nullptr; }));
    takeKeyboard();
    QWidget* box = field->findChild<NumberBox*>();
    ASSERT_TRUE(box);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_F1);
    ASSERT_TRUE(manual());
    EXPECT_EQ(manual()->place(), "physics.md#pressure");
    EXPECT_LE(manual()->height(), manual()->screen()->availableSize().height());
    manual()->close();
}

TEST_F(ManualTest, OpensAtTheEntryThatIsLitInAMenu)
{
    takeKeyboard();
    QMenu* menu = window.commands().menu("seam");
    ASSERT_TRUE(menu);
    menu->popup(window.mapToGlobal(QPoint(100, 60)));
    ASSERT_TRUE(QTest::qWaitForWindowExposed(menu));
    menu->setActiveAction(window.command("tool.sew"));
    QTest::keyClick(menu, Qt::Key_F1);
    ASSERT_TRUE(manual());
    EXPECT_TRUE(manual()->place().startsWith("sewing.md")) << manual()->place().toStdString();
    EXPECT_FALSE(menu->isVisible()) << "it would lie over the page";
    manual()->close();
}

TEST_F(ManualTest, EveryPlaceIsAHeading)
{
    const QString folder = shippedFolder("manual");
    ASSERT_FALSE(folder.isEmpty());
    ManualWindow shown(folder);
    const auto* text = shown.findChild<QTextBrowser*>();
    int count = 0;
    for (const char* const table : {"places.tsv", "warnings.tsv"}) {
        QFile file(QDir(folder).filePath(table));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        QStringList seen;
        for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n')) {
            const QString place = line.section(u'\t', -1);
            if (line.startsWith(u'#') || !line.contains(u'\t') || seen.contains(place))
                continue;
            seen << place;
            ++count;
            shown.openAt(place);
            EXPECT_TRUE(!place.contains(u'#') || text->textCursor().block().blockFormat().headingLevel() > 0)
                << place.toStdString();
        }
    }
    EXPECT_GT(count, 100);
}

} // namespace
} // namespace bolster
