// A pattern from elsewhere becomes patches and seams, in the real window.
#include "WindowTest.h"

#include "CutPattern.h"
#include "DxfWriter.h"
#include "ImportPatternDialog.h"
#include "SeamProposalsWindow.h"
#include "Selection.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>

namespace bolster {
namespace {

class ImportPatternTest : public WindowTest {
protected:
    template <class T>
    int count()
    {
        int found = 0;
        window.document().design().each<T>([&](ElementId, const T&) { ++found; });
        return found;
    }

    /// The car seat's pattern as a cutter gets it.
    QString carSeatDxf()
    {
        EXPECT_TRUE(open(sample("car-seat")));
        m_seams = count<Seam>();
        m_patches = count<Patch>();
        const QString path = folder.filePath(QStringLiteral("seat.dxf"));
        write(path, dxfText(cutPattern(window.document().design(), {}), {}));
        window.command("file.new")->trigger();
        EXPECT_TRUE(QTest::qWaitFor([this] { return count<Patch>() == 0; }));
        return path;
    }

    static void write(const QString& path, const std::string& text)
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text.data(), static_cast<qint64>(text.size()));
    }

    /// Through the menu, the file dialog, and the reading; null when no pieces are shown.
    ImportPatternDialog* import(const QString& path)
    {
        window.command("file.import-pattern")->trigger();
        QFileDialog* files = nullptr;
        EXPECT_TRUE(QTest::qWaitFor([&] {
            files = window.findChild<QFileDialog*>();
            return files && files->isVisible();
        }));
        files->findChild<QLineEdit*>()->setText(path);
        QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
        ImportPatternDialog* dialog = nullptr;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                dialog = window.findChild<ImportPatternDialog*>();
                return dialog && dialog->pattern();
            },
            30000));
        return dialog;
    }

    /// So many squares beside each other.
    QString squaresSvg(int count)
    {
        std::string text =
            R"(<svg xmlns="http://www.w3.org/2000/svg" width="9000mm" height="9000mm" viewBox="0 0 9000 9000">)";
        for (int i = 0; i < count; ++i)
            text += "<rect x='" + std::to_string(150 * (i % 50)) + "' y='" + std::to_string(150 * (i / 50)) +
                    "' width='120' height='120'/>";
        const QString path = folder.filePath(QStringLiteral("squares.svg"));
        write(path, text + "</svg>");
        return path;
    }

    const QTemporaryDir folder;
    int m_seams = 0;
    int m_patches = 0;
};

TEST_F(ImportPatternTest, PiecesAreShownTakenAndSewn)
{
    ImportPatternDialog* dialog = import(carSeatDxf());
    ASSERT_TRUE(dialog);
    auto* pieces = dialog->findChild<QListWidget*>(QStringLiteral("pieces"));
    EXPECT_EQ(pieces->count(), m_patches);
    auto* unit = dialog->findChild<QComboBox*>(QStringLiteral("unit"));
    EXPECT_TRUE(unit->itemText(1).contains(QStringLiteral("\u00d7"))) << "each unit with its measures";
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count<Patch>() == m_patches; }, 30000));
    EXPECT_EQ(window.selection().elements().size(), static_cast<std::size_t>(m_patches)) << "one sees what came";

    window.command("seam.propose")->trigger();
    SeamProposalsWindow* proposals = nullptr;
    QTreeWidget* list = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            proposals = window.findChild<SeamProposalsWindow*>();
            list = proposals ? proposals->findChild<QTreeWidget*>() : nullptr;
            return list && list->topLevelItemCount() > 0;
        },
        60000));
    const int proposed = list->topLevelItemCount();
    EXPECT_GE(proposed, m_seams * 7 / 10);
    EXPECT_EQ(count<Seam>(), 0) << "none is made silently";
    EXPECT_EQ(window.selection().edges().size(), 2u) << "the edges of the first one are shown";
    auto& navigation = window.patternView().navigation();
    navigation.setTransform(navigation.transform().panned({1e5, 0})); // nothing is in the picture
    QTest::keyClick(list, Qt::Key_Down);
    for (const Selection::Edge& edge : window.selection().edges()) {
        const Patch& patch = *window.document().design().find<Patch>(edge.stretch.patch);
        EXPECT_TRUE(window.patternView().rect().contains(
            patternPixel(toLayout(patch, patch.outline.at(edge.stretch.from)))))
            << "both edges are seen";
    }
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_EQ(count<Seam>(), 1) << "accepted by a key";
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return list->topLevelItemCount() < proposed && list->currentItem(); }, 60000));
    EXPECT_EQ(list->indexOfTopLevelItem(list->currentItem()), 2) << "rows that were skipped stay skipped";
    for (QPushButton* button : proposals->findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("Sew &all")) {
            ASSERT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, 60000));
            QTest::mouseClick(button, Qt::LeftButton);
        }
    EXPECT_GE(count<Seam>(), m_seams * 7 / 10);
    window.command("edit.undo")->trigger();
    window.command("edit.undo")->trigger();
    window.command("edit.undo")->trigger();
    EXPECT_EQ(count<Patch>(), 0) << "three steps back";
}

TEST_F(ImportPatternTest, SomePiecesInAnotherUnit)
{
    ImportPatternDialog* dialog = import(carSeatDxf());
    ASSERT_TRUE(dialog);
    auto* pieces = dialog->findChild<QListWidget*>(QStringLiteral("pieces"));
    const double width = dialog->pattern()->pieces.front().cut.box().sizes().x();
    for (int row = 1; row < pieces->count(); ++row)
        pieces->item(row)->setCheckState(Qt::Unchecked);
    auto* unit = dialog->findChild<QComboBox*>(QStringLiteral("unit"));
    unit->setCurrentIndex(1);
    emit unit->activated(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->pattern()->pieces.front().cut.box().sizes().x() > 5 * width; },
                                30000));
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count<Patch>() == 1; }, 30000));
}

TEST_F(ImportPatternTest, OpenOutlinesAreToldAndClosed)
{
    const QString path = folder.filePath(QStringLiteral("open.svg"));
    write(path, R"(<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="400mm" viewBox="0 0 400 400">
        <path d="M10 10 H300 V200 H10 V13"/><image/></svg>)");
    ImportPatternDialog* dialog = import(path);
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(dialog->pattern()->pieces.empty());
    const QString told = dialog->findChild<QLabel*>(QStringLiteral("odd"))->text();
    EXPECT_TRUE(told.contains(QStringLiteral("3.00 mm"))) << told.toStdString();
    EXPECT_TRUE(told.contains(QStringLiteral("image"))) << "nothing is left out silently: " << told.toStdString();
    auto* gap = dialog->findChild<QAbstractSpinBox*>(QStringLiteral("gap"));
    takeKeyboard(*dialog);
    gap->setFocus();
    gap->selectAll();
    QTest::keyClicks(gap, QStringLiteral("5"));
    QTest::keyClick(gap, Qt::Key_Tab);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->pattern()->pieces.size() == 1; }, 30000));
    dialog->reject();
    EXPECT_EQ(count<Patch>(), 0);
}

TEST_F(ImportPatternTest, OfManyPiecesNoneIsSelected)
{
    ImportPatternDialog* dialog = import(squaresSvg(501));
    ASSERT_TRUE(dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count<Patch>() == 501; }, 60000));
    EXPECT_TRUE(window.selection().elements().empty());
}

TEST_F(ImportPatternTest, NotMorePiecesAreTakenThanTheWindowCanShow)
{
    ImportPatternDialog* dialog = import(squaresSvg(2002));
    ASSERT_TRUE(dialog);
    auto* pieces = dialog->findChild<QListWidget*>(QStringLiteral("pieces"));
    ASSERT_EQ(pieces->count(), 2002);
    EXPECT_EQ(dialog->choice().only->size(), 2000u) << "the first ones";
    const QString told = dialog->findChild<QLabel*>(QStringLiteral("odd"))->text();
    EXPECT_TRUE(told.contains(QStringLiteral("squares.svg has"))) << told.toStdString();
    QPushButton* take = nullptr;
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
        take = button->text() == QStringLiteral("&Import") ? button : take;
    ASSERT_TRUE(take);
    EXPECT_TRUE(take->isEnabled());
    pieces->item(2001)->setCheckState(Qt::Checked);
    EXPECT_FALSE(take->isEnabled());
    pieces->item(0)->setCheckState(Qt::Unchecked);
    EXPECT_TRUE(take->isEnabled());
    dialog->reject();
}

} // namespace
} // namespace bolster
