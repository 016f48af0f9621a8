// The list of seams.
#include "Document.h"
#include "PatchEdits.h"
#include "PatternMarks.h"
#include "Picture.h"
#include "SeamColors.h"
#include "SeamEdits.h"
#include "SeamsModel.h"
#include "SeamsView.h"
#include "Selection.h"
#include "SewingOrder.h"
#include "TestDesigns.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QHeaderView>
#include <QImage>
#include <QPainter>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

#include <array>

namespace bolster {
namespace {

using Column = SeamsModel::Column;
constexpr ElementId added{7};

class SeamsTest : public testing::Test {
protected:
    SeamsTest()
    {
        const Design design = twoSquares();
        document.reset(design.with(edits::addSeam(design, {firstSquare, 2, 3}, {secondSquare, 0, 0.9}, true)));
    }

    static QString text(const QAbstractItemModel& model, int row, Column column)
    {
        return model.index(row, column).data().toString();
    }

    Document document;
    Selection selection;
};

TEST_F(SeamsTest, ShowsLengthsAndEaseWithTheirSign)
{
    SeamsModel model(document);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_EQ(text(model, 0, Column::Label), "A");
    EXPECT_EQ(text(model, 1, Column::Label), "B");
    EXPECT_EQ(text(model, 1, Column::Name), QString::fromUtf8("First\u00b73 \u2013 Second\u00b71"));
    EXPECT_EQ(text(model, 0, Column::Difference), "0 mm");
    EXPECT_EQ(text(model, 1, Column::LengthA), "100 mm");
    EXPECT_EQ(text(model, 1, Column::LengthB), "90 mm");
    EXPECT_EQ(text(model, 1, Column::Difference), "-10 mm") << "the second side is shorter";
    EXPECT_EQ(text(model, 1, Column::Ratio), "-11.1 %");
    EXPECT_FALSE(model.index(0, 0).data(SeamsModel::PuckersRole).toBool());
    EXPECT_TRUE(model.index(1, 0).data(SeamsModel::PuckersRole).toBool());
    document.commit(edits::swapSeamSides(document.design(), std::array{added}));
    EXPECT_EQ(text(model, 1, Column::Difference), "+10 mm");
}

TEST_F(SeamsTest, FollowsADragRowByRow)
{
    SeamsModel model(document);
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    document.commit(edits::movePatchPoints(document.design(), firstSquare, std::array{3}, Vec2(-20, 0)));
    EXPECT_EQ(text(model, 1, Column::LengthA), "120 mm");
    EXPECT_EQ(changes.count(), 2) << "both seams are at that patch";
    document.commit(edits::setContinuity(document.design(), std::array{squareSeam}, Continuity::G1));
    EXPECT_EQ(changes.count(), 3);
    EXPECT_EQ(changes.last()[0].toModelIndex().row(), 0);
    document.commit({{}, {{squareSeam, document.design().element(squareSeam), nullptr}}});
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_EQ(text(model, 0, Column::Label), "A");
    document.undo();
    EXPECT_EQ(model.rowCount(), 2);
    EXPECT_EQ(model.indexOf(added).row(), 1);
}

TEST_F(SeamsTest, SelectsAndIsSelected)
{
    SeamsView view(document, selection);
    view.resize(520, 240);
    view.show();
    selection.set({added});
    ASSERT_EQ(view.table().selectionModel()->selectedRows().size(), 1);
    EXPECT_EQ(view.table().selectionModel()->selectedRows()[0].data().toString(), "B");
    const QModelIndex first = view.table().model()->index(0, Column::Name);
    QTest::mouseClick(view.table().viewport(), Qt::LeftButton, {}, view.table().visualRect(first).center());
    EXPECT_EQ(selection.elements(), Selection::Elements{squareSeam});
    keepPicture(view, "seams");
}

TEST_F(SeamsTest, SelectAllMeansItsSeams)
{
    SeamsView view(document, selection);
    view.resize(600, 300);
    view.show();
    QTreeView& table = view.table();
    QShortcut allPatches(QKeySequence::SelectAll, &view); // as the window's
    QSignalSpy others(&allPatches, &QShortcut::activated);
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_A, Qt::ControlModifier);
    EXPECT_EQ(others.count(), 0);
    EXPECT_EQ(selection.elements(), (Selection::Elements{squareSeam, added}));
}

TEST_F(SeamsTest, SortsTheWorstEaseFirst)
{
    SeamsView view(document, selection);
    view.resize(520, 240);
    view.show();
    QHeaderView& header = *view.table().header();
    const QPoint title(header.sectionViewportPosition(Column::Difference) + 12, header.height() / 2);
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, title);
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, title);
    EXPECT_EQ(text(*view.table().model(), 0, Column::Label), "B");
}

TEST_F(SeamsTest, ContinuityIsChangedInPlaceForAllSelected)
{
    SeamsView view(document, selection);
    view.resize(520, 240);
    view.show();
    selection.set({squareSeam, added});
    const QModelIndex cell = view.table().model()->index(0, Column::ContinuityColumn);
    view.table().edit(cell);
    auto* box = view.table().findChild<QComboBox*>();
    ASSERT_TRUE(box);
    EXPECT_EQ(box->currentText(), "C0");
    box->setCurrentIndex(2);
    emit box->activated(2);
    EXPECT_EQ(document.history().count(), 2) << "one edit";
    for (const ElementId id : {squareSeam, added})
        EXPECT_EQ(document.design().find<Seam>(id)->continuity, Continuity::G1);
    EXPECT_EQ(cell.data().toString(), "G1");
}

TEST_F(SeamsTest, ShowsTheOrderOfSewing)
{
    SeamsModel model(document);
    const auto steps = [&] { return text(model, 0, Column::Step) + text(model, 1, Column::Step); };
    const QString before = steps();
    EXPECT_TRUE(before == "12" || before == "21") << before.toStdString();
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    const std::vector<ElementId> last{before == "12" ? added : squareSeam};
    document.commit(edits::moveInSewingOrder(document.design(), last, edits::SewingMove::Earlier));
    EXPECT_EQ(steps(), before == "12" ? "21" : "12");
    EXPECT_FALSE(changed.isEmpty());
    document.commit(edits::proposeSewingOrder(document.design()));
    EXPECT_EQ(steps(), before);
}

TEST(SeamLabels, DoNotOverlapInANarrowPatch)
{
    QImage image(500, 80, QImage::Format_ARGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    const auto edge = [](const QPointF& from, const QPointF& to) {
        QPainterPath path(from);
        path.lineTo(to);
        return path;
    };
    for (const double narrow : {8.0, 16.0, 24.0})
        for (const double longs : {50.0, 90.0, 400.0}) {
            std::vector<QRectF> taken{{30 + longs / 2, 30, 10, 10}};
            const QRectF written = taken.front();
            // Both run the same way, so their letters would lie beside each other.
            paintSeamArrow(painter, {edge({20, 30}, {20 + longs, 30}), false, false, QStringLiteral("A")}, Qt::blue,
                           taken);
            EXPECT_GE(taken.size(), 2u) << narrow << ' ' << longs;
            paintSeamArrow(painter, {edge({20, 30 + narrow}, {20 + longs, 30 + narrow}), true, true, "WW"}, Qt::red,
                           taken);
            for (std::size_t i = 0; i < taken.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(taken[i].intersects(taken[j])) << narrow << ' ' << longs << ' ' << i << ' ' << j;
            EXPECT_EQ(taken.front(), written);
            EXPECT_TRUE(longs < 400 || taken.size() == 5) << "both have their letters where there is room";
        }
}

TEST(SeamLabels, CountLikeColumnsOfATable)
{
    EXPECT_EQ(seamLabel(0), "A");
    EXPECT_EQ(seamLabel(25), "Z");
    EXPECT_EQ(seamLabel(26), "AA");
    EXPECT_EQ(seamLabel(26 * 27), "AAA");
    const Design none;
    const Design two = none.with({{},
                                  {{ElementId{3}, nullptr, makeElement(Seam{})},
                                   {ElementId{5}, nullptr, makeElement(Fabric{})},
                                   {ElementId{8}, nullptr, makeElement(Seam{})}}});
    EXPECT_EQ(seamLetter(two, ElementId{3}), "A");
    EXPECT_EQ(seamLetter(two, ElementId{8}), "B");
    EXPECT_EQ(seamLetter(two, ElementId{5}), "");
}

} // namespace
} // namespace bolster
