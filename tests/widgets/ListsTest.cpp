#include "Document.h"
#include "ElementEdits.h"
#include "ElementsModel.h"
#include "ElementsView.h"
#include "FieldText.h"
#include "HistoryModel.h"
#include "HistoryView.h"
#include "Inspector.h"
#include "NumberBox.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "TestDesigns.h"

#include <QAbstractItemModelTester>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

#include <array>

namespace bolster {
namespace {

class ListsTest : public testing::Test {
protected:
    ListsTest() { document.reset(twoSquares()); }

    void rename(const char* name) { document.commit(edits::renameElement(document.design(), firstSquare, name)); }

    QStringList lines(const HistoryModel& model) const
    {
        QStringList result;
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex index = model.index(row);
            result << QString(index.data(HistoryModel::DepthRole).toInt() * 2, ' ') +
                          QString::number(index.data(HistoryModel::NodeRole).toInt()) +
                          (index.data(HistoryModel::CurrentRole).toBool() ? "*"
                           : index.data(HistoryModel::DoneRole).toBool()  ? ""
                                                                          : "-");
        }
        return result;
    }

    Document document;
    Selection selection;
    ProblemSet problems;
};

TEST_F(ListsTest, HistoryShowsBranchesWhereTheyBegan)
{
    HistoryModel model(document);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    rename("A"); // 1
    rename("B"); // 2
    rename("C"); // 3
    document.undo();
    document.undo();
    rename("D"); // 4, beside 2
    EXPECT_EQ(lines(model), (QStringList{"0", "1", "  2-", "  3-", "4*"}));
    document.jumpTo(3);
    EXPECT_EQ(lines(model), (QStringList{"0", "1", "  2", "  3*", "4-"})) << "nothing changes its place";
    EXPECT_TRUE(model.index(2).data(HistoryModel::FirstOfBranchRole).toBool());
    EXPECT_FALSE(model.index(3).data(HistoryModel::FirstOfBranchRole).toBool());
}

TEST_F(ListsTest, AClickInTheHistoryJumps)
{
    HistoryView view(document);
    view.resize(260, 300);
    view.show();
    rename("A");
    rename("B");
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.visualRect(view.model()->index(1, 0)).center());
    EXPECT_EQ(document.history().current(), 1);
    EXPECT_EQ(document.design().find<Patch>(firstSquare)->name, "A");
    keepPicture(view, "history");
}

/// What a screen reader's user does with a row.
TEST_F(ListsTest, TheActionOfARowSelectsItsElement)
{
    ElementsView view(document, selection, problems);
    view.resize(260, 400);
    view.show();
    QAccessibleInterface* tree = QAccessible::queryAccessibleInterface(view.findChild<QTreeView*>());
    ASSERT_TRUE(tree && tree->tableInterface());
    const QString name = QString::fromStdString(document.design().find<Patch>(secondSquare)->name);
    QAccessibleInterface* row = nullptr;
    for (int at = 0; at < tree->tableInterface()->rowCount(); ++at)
        if (QAccessibleInterface* one = tree->tableInterface()->cellAt(at, 0); one->text(QAccessible::Name) == name)
            row = one;
    ASSERT_TRUE(row && row->actionInterface());
    row->actionInterface()->doAction(row->actionInterface()->actionNames().front());
    EXPECT_EQ(selection.elements(), Selection::Elements{secondSquare});
}

TEST_F(ListsTest, ElementsAreListedByKind)
{
    ElementsModel model(document, problems);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_EQ(model.rowCount(), 5);
    EXPECT_EQ(model.rowCount(model.index(0, 0)), 2);
    EXPECT_EQ(model.indexOf(squareSeam).data().toString(), QString::fromUtf8("First \u2013 Second"));
    document.commit(edits::renameElement(document.design(), secondSquare, "Back"));
    EXPECT_EQ(model.indexOf(squareSeam).data().toString(), QString::fromUtf8("First \u2013 Back"));
    document.commit(edits::removeElements(document.design(), std::array{firstSquare}));
    EXPECT_FALSE(model.indexOf(squareSeam).isValid());
    EXPECT_TRUE(model.setData(model.indexOf(secondSquare), "Rest", Qt::EditRole));
    EXPECT_EQ(document.design().find<Patch>(secondSquare)->name, "Rest");
    EXPECT_FALSE(model.setData(model.indexOf(secondSquare), "  ", Qt::EditRole));
}

TEST_F(ListsTest, WhatJoinsTheSamePatchesIsToldApart)
{
    Edit edit;
    edit.changes = {{ElementId{10}, nullptr, makeElement(Seam{{firstSquare, 0, 1}, {secondSquare, 0, 1}})},
                    {ElementId{11}, nullptr, makeElement(Notch{{firstSquare, 0.3}, {}})},
                    {ElementId{12}, nullptr, makeElement(Notch{{firstSquare, 2.3}, {}})},
                    {ElementId{13}, nullptr, makeElement(CutCorner{{firstSquare, 0}, CornerJoin::Folded})},
                    {ElementId{14}, nullptr, makeElement(CutCorner{{firstSquare, 2}, CornerJoin::Folded})}};
    document.commit(edit);
    ElementsModel model(document, problems);
    const auto text = [&](int id) { return model.indexOf(ElementId{id}).data().toString(); };
    EXPECT_EQ(model.indexOf(squareSeam).data().toString(), QString::fromUtf8("First \u2013 Second, A, 100 mm"));
    EXPECT_EQ(text(10), QString::fromUtf8("First \u2013 Second, B, 100 mm")) << "as the pattern has them";
    EXPECT_EQ(text(11), QStringLiteral("Notch of First, edge 1, 30 mm from the corner"));
    EXPECT_EQ(text(12), QStringLiteral("Notch of First, edge 3, 30 mm from the corner"));
    EXPECT_EQ(text(13), QStringLiteral("Corner of First, edge 1"));
    EXPECT_EQ(text(14), QStringLiteral("Corner of First, edge 3"));
}

TEST_F(ListsTest, TheRightButtonAsksForTheMenuOfItsRow)
{
    ElementsView view(document, selection, problems);
    view.resize(260, 400);
    view.show();
    QSignalSpy asked(&view, &ElementsView::contextMenuWanted);
    QTreeView& tree = view.tree();
    const auto ask = [&](const QModelIndex& index) {
        const QPoint at = tree.visualRect(index).center();
        QTest::mouseClick(tree.viewport(), Qt::RightButton, {}, at);
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, tree.viewport()->mapToGlobal(at));
        QApplication::sendEvent(tree.viewport(), &event);
    };
    const QModelIndex group = tree.model()->index(0, 0);
    ask(group);
    EXPECT_EQ(asked.count(), 0) << "a heading is no element";
    ask(tree.model()->index(1, 0, group));
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(selection.elements(), Selection::Elements{secondSquare});
}

TEST_F(ListsTest, WhatTheCoverViewHidesIsMarked)
{
    ElementsModel model(document, problems);
    const auto marked = [&](ElementId id) {
        const QModelIndex index = model.indexOf(id);
        const bool slanted = index.data(Qt::FontRole).value<QFont>().italic();
        EXPECT_EQ(slanted, index.data(ElementsModel::HiddenRole).toBool());
        EXPECT_EQ(slanted,
                  index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("Hidden in the 3D view")));
        return slanted;
    };
    EXPECT_FALSE(marked(firstSquare));
    model.setHidden({firstSquare});
    EXPECT_TRUE(marked(firstSquare));
    EXPECT_FALSE(marked(secondSquare));
    model.setHidden({});
    EXPECT_FALSE(marked(firstSquare));
}

TEST_F(ListsTest, ElementsSelectAndAreSelected)
{
    ElementsView view(document, selection, problems);
    view.resize(260, 400);
    view.show();
    selection.set({secondSquare});
    ASSERT_EQ(view.tree().selectionModel()->selectedIndexes().size(), 1);
    EXPECT_EQ(view.tree().selectionModel()->selectedIndexes()[0].data().toString(), "Second");
    const QModelIndex group = view.tree().model()->index(0, 0);
    const QModelIndex first = view.tree().model()->index(0, 0, group);
    QTest::mouseClick(view.tree().viewport(), Qt::LeftButton, {}, view.tree().visualRect(first).center());
    EXPECT_EQ(selection.elements(), Selection::Elements{firstSquare});
}

TEST_F(ListsTest, ElementsThatFollowOneAnotherAreSelectedAsOneRange)
{
    ElementsView view(document, selection, problems);
    selection.set({firstSquare, secondSquare, squareSeam});
    EXPECT_EQ(view.tree().selectionModel()->selectedIndexes().size(), 3);
    EXPECT_EQ(view.tree().selectionModel()->selection().size(), 2) << "both patches are one, the seam another one";
}

TEST_F(ListsTest, AProblemIsMarked)
{
    ElementsModel model(document, problems);
    problems.set({{firstSquare, "", "", {"too thin", {}}, Severity::Warning},
                  {firstSquare, "", "", {"crosses itself", {}}, Severity::Error}});
    EXPECT_EQ(model.indexOf(firstSquare).data(ElementsModel::ProblemRole).toInt(), 2);
    EXPECT_TRUE(model.indexOf(firstSquare).data(Qt::ToolTipRole).toString().contains("Crosses itself"));
    EXPECT_EQ(model.indexOf(secondSquare).data(ElementsModel::ProblemRole).toInt(), 0);
}

TEST_F(ListsTest, NotesAreSignedFoundAndToldByTheirTip)
{
    ElementsView view(document, selection, problems);
    view.resize(260, 400);
    view.show();
    document.commit(edits::changeNote(document.design(), firstSquare, "ask Anna\nabout this allowance"));
    auto* tree = view.findChild<QTreeView*>();
    const auto row = [&](ElementId id) {
        for (int group = 0; group < tree->model()->rowCount(); ++group) {
            const QModelIndex parent = tree->model()->index(group, 0);
            for (int i = 0; i < tree->model()->rowCount(parent); ++i)
                if (const QModelIndex found = tree->model()->index(i, 0, parent);
                    found.data(ElementsModel::ElementRole).toInt() == static_cast<int>(id))
                    return found;
        }
        return QModelIndex();
    };
    ASSERT_TRUE(row(firstSquare).isValid());
    EXPECT_EQ(row(firstSquare).data(ElementsModel::NoteRole).toString(), "ask Anna\nabout this allowance");
    EXPECT_TRUE(row(firstSquare).data(Qt::ToolTipRole).toString().endsWith("ask Anna\nabout this allowance"));
    keepPicture(view, QStringLiteral("elements-note"));
    view.findChild<QLineEdit*>()->setText("ALLOWANCE");
    EXPECT_TRUE(row(firstSquare).isValid()) << "found by a word of its note";
    int shown = 0;
    for (int group = 0; group < tree->model()->rowCount(); ++group)
        shown += tree->model()->rowCount(tree->model()->index(group, 0));
    EXPECT_EQ(shown, 1) << "and nothing else";
    document.undo();
    view.findChild<QLineEdit*>()->clear();
    EXPECT_TRUE(row(firstSquare).data(ElementsModel::NoteRole).toString().isEmpty());
}

TEST_F(ListsTest, EachChangeInTheInspectorIsOneEdit)
{
    Inspector inspector(document, selection, problems);
    inspector.resize(280, 400);
    inspector.show();
    selection.set({firstSquare});
    auto* name = inspector.findChild<QLineEdit*>(QString(), Qt::FindChildrenRecursively);
    ASSERT_TRUE(name);
    name->selectAll();
    QTest::keyClicks(name, "Seat");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(document.design().find<Patch>(firstSquare)->name, "Seat");
    EXPECT_EQ(document.history().count(), 2);

    auto* check = inspector.findChild<QCheckBox*>();
    ASSERT_TRUE(check);
    check->click();
    EXPECT_TRUE(document.design().find<Patch>(firstSquare)->wrongSideOut);
    EXPECT_EQ(document.history().count(), 3);
    document.undo();
    EXPECT_FALSE(inspector.findChild<QCheckBox*>()->isChecked());
    keepPicture(inspector, "inspector");
}

TEST_F(ListsTest, TrimmedEdgesAndColourwaysAreListedAndHaveTheirForms)
{
    const ElementId edge = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(OutlineTrim{{firstSquare, 2, 3}})));
    const ElementId blue = document.design().nextId();
    document.commit(
        edits::addElement(document.design(), makeElement(Colourway{"Blue", {{firstSquare, testFabric}}})));
    ElementsModel model(document, problems);
    const QAbstractItemModelTester tester(&model);
    EXPECT_EQ(model.indexOf(edge).data().toString(), "Edge of First");
    EXPECT_EQ(model.indexOf(edge).parent().data().toString(), "Trimmed edges");
    EXPECT_EQ(model.indexOf(blue).data().toString(), "Blue");
    EXPECT_EQ(model.indexOf(blue).parent().data().toString(), "Colourways");
    EXPECT_TRUE(model.setData(model.indexOf(blue), "Navy", Qt::EditRole));
    EXPECT_FALSE(model.flags(model.indexOf(edge)) & Qt::ItemIsEditable);

    Inspector inspector(document, selection, problems);
    inspector.resize(280, 700);
    inspector.show();
    selection.set({blue});
    EXPECT_EQ(inspector.findChild<QLineEdit*>()->text(), "Navy");
    for (const ElementId id : {squareSeam, squareFixation, edge}) {
        selection.set({id});
        QComboBox* stitches = nullptr;
        for (QComboBox* box : inspector.findChildren<QComboBox*>())
            stitches = box->findText("Twin rows") >= 0 ? box : stitches;
        ASSERT_TRUE(stitches);
        const int before = document.history().count();
        stitches->setCurrentIndex(stitches->findText("Twin rows"));
        emit stitches->activated(stitches->currentIndex());
        EXPECT_EQ(seamTrim(*document.design().element(id))->stitch, SeamTrim::Stitch::Twin);
        EXPECT_EQ(document.history().count(), before + 1);
    }
    keepPicture(inspector, "inspector-trim");
}

TEST(FieldText, SaysAPartOfAnElementInWords)
{
    const Design design = twoSquares();
    const Element seam = Seam{};
    EXPECT_EQ(fieldText(seam, "trim"), "Trim");
    EXPECT_EQ(fieldValueText(design, seam, "trim", R"({"stitch": "twin", "valley": false})"),
              "Stitching: Twin rows, Valley: no");
    EXPECT_EQ(fieldText(Element(Cushion{}), "enabled"), "Pushes the cover");
    EXPECT_EQ(fieldText(Element(Scan{}), "enabled"), "Fit the cover to it");
}

TEST(FieldText, SaysValuesInTheWordsOfTheDesign)
{
    const Design design = twoSquares();
    const auto text = [&](const Element& element, const char* key, const char* json) {
        return fieldValueText(design, element, key, json);
    };
    const QString first = displayName(design, firstSquare);
    EXPECT_EQ(text(FixationSeam{}, "patch", "1"), displayName(design, ElementId{1}));
    EXPECT_EQ(text(Cushion{}, "patches", ("[" + std::to_string(number(firstSquare)) + "]").c_str()), first);
    EXPECT_EQ(text(Seam{}, "a",
                   (R"({"patch": )" + std::to_string(number(firstSquare)) + R"(, "from": 0, "to": 1})").c_str()),
              first + ", from 0 to 1");
    EXPECT_EQ(text(Settings{}, "edge_length", "12.123456"), "12.12 mm");
    EXPECT_EQ(text(Patch{}, "position", "[1.5, 0.333333]"), "1.5, 0.33 mm");
    EXPECT_EQ(text(Patch{}, "grain", "45"), "45\u00b0");
    EXPECT_EQ(text(Frame{}, "rotation", "[0.7071067811865476, 0.7071067811865476, 0, 0]"), "turned by 90\u00b0");
    EXPECT_EQ(text(Patch{}, "outline", R"({"degree": 1, "points": [[0, 0], [100, 0], [100, 50]]})"),
              "3 points, 100 \u00d7 50 mm");
    EXPECT_EQ(text(Patch{}, "outline",
                   R"({"degree": 3, "closed": true, "points": [[0, 0], [80, 0], [80, 80], [0, 80]]})"),
              "4 points, 73.3 \u00d7 73.3 mm")
        << "the size of the curve, not of its control points";
    EXPECT_EQ(text(Settings{}, "colourway", ""), "as made");
    EXPECT_EQ(text(Seam{}, "trim", R"({"stitch": "twin", "stitch_length_mm": 4})"),
              "Stitching: Twin rows, Stitch length: 4 mm");
    EXPECT_EQ(displayName(design, settingsId), "Design");
}

TEST_F(ListsTest, ASliderChangesTheDesignWhileItIsDraggedAsOneEdit)
{
    const ElementId id{9};
    document.reset(twoSquares().with(
        {{},
         {{id, nullptr,
           makeElement(FancySeam{{"Pipe", firstSquare, BSpline2(1, false, {{20, 20}, {80, 20}})}})}}}));
    Inspector inspector(document, selection, problems);
    inspector.resize(280, 400);
    inspector.show();
    selection.set({id});
    const auto sliders = inspector.findChildren<QSlider*>();
    ASSERT_EQ(sliders.size(), 2);
    QSlider& depth = *sliders[1];
    const auto depthNow = [&] { return document.design().find<FancySeam>(id)->depth; };
    const double before = depthNow();
    depth.setSliderDown(true);
    for (int step = 0; step <= 4; ++step)
        depth.setValue(depth.minimum() + step * (depth.maximum() - depth.minimum()) / 8);
    EXPECT_TRUE(document.gestureRunning());
    EXPECT_DOUBLE_EQ(depthNow(), 0);
    EXPECT_EQ(document.history().count(), 1);
    depth.setSliderDown(false);
    EXPECT_FALSE(document.gestureRunning());
    EXPECT_DOUBLE_EQ(depthNow(), 0);
    EXPECT_EQ(document.history().count(), 2);
    document.undo();
    EXPECT_EQ(depthNow(), before);
    QTest::keyClick(inspector.widget()->findChildren<QSlider*>()[1], Qt::Key_Right); // of the form as it is now
    EXPECT_GT(depthNow(), before) << "by key, too";
    EXPECT_FALSE(document.gestureRunning());
    keepPicture(inspector, "inspector-fancy-seam");
}

TEST(NumberBox, TakesPointAndCommaInAnyLanguage)
{
    for (const char* language : {"de", "en"}) {
        NumberBox box({QStringLiteral(" mm")});
        box.setLocale(QLocale(language));
        for (const char* text : {"12.5", "12,5"}) {
            box.display(0);
            box.selectAll();
            QTest::keyClicks(&box, text);
            QTest::keyClick(&box, Qt::Key_Return);
            EXPECT_DOUBLE_EQ(box.value(), 12.5) << language << ' ' << text;
        }
    }
}

TEST(NumberBox, TakesItsUnitAsItIsTyped)
{
    NumberBox angle({QStringLiteral("\u00b0"), 1, -360, 360, 5});
    NumberBox share({QStringLiteral(" %"), 1, 0, 100, 1});
    for (NumberBox* box : {&angle, &share})
        for (const QString& text : {QStringLiteral("30"), "30" + box->suffix(), "30 " + box->suffix().trimmed()}) {
            box->display(0);
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Return);
            EXPECT_DOUBLE_EQ(box->value(), 30) << text.toStdString();
        }
    angle.selectAll();
    QTest::keyClicks(&angle, "45 deg");
    QTest::keyClick(&angle, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(angle.value(), 45);
}

TEST(NumberBox, ReadsGroupedDigitsAsTheLanguageWritesThem)
{
    const auto typed = [](const char* language, const char* text) {
        NumberBox box({QStringLiteral(" mm")});
        box.setLocale(QLocale(language));
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
        return box.value();
    };
    EXPECT_DOUBLE_EQ(typed("en", "1,500"), 1500);
    EXPECT_DOUBLE_EQ(typed("en", "-12,345.5"), -12345.5);
    EXPECT_DOUBLE_EQ(typed("en", "1.500"), 1.5);
    EXPECT_DOUBLE_EQ(typed("en", "0,125"), 0.125);
    EXPECT_DOUBLE_EQ(typed("en", "1,5"), 1.5);
    EXPECT_DOUBLE_EQ(typed("de", "1.500"), 1500);
    EXPECT_DOUBLE_EQ(typed("de", "1.234.567"), 1234567);
    EXPECT_DOUBLE_EQ(typed("de", "1,500"), 1.5);
    EXPECT_DOUBLE_EQ(typed("de", "0.125"), 0.125);
}

TEST(NumberBox, RefusesAsAWholeWhatIsNoNumberOfItsRange)
{
    for (const char* text : {"2 m", "1,500", "1e9", "3*", "-5", "", "mm", "2 cm*3 cm"}) {
        NumberBox box({QStringLiteral(" mm"), 2, 0.1, 1000, 1});
        box.setLocale(QLocale("en"));
        box.display(12);
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
        EXPECT_DOUBLE_EQ(box.value(), 12) << text;
    }
}

TEST(NumberBox, ShowsABadValueAndTakesItsRemedy)
{
    NumberBox box({{}, 3, -0.5, 0.5, 0.05});
    double reported = 0;
    QObject::connect(&box, &QDoubleSpinBox::valueChanged, &box, [&](double value) { reported = value; });
    box.display(0.9);
    EXPECT_DOUBLE_EQ(box.value(), 0.9);
    box.selectAll();
    QTest::keyClicks(&box, "0.5");
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(reported, 0.5);
    box.display(0.5);
    EXPECT_DOUBLE_EQ(box.maximum(), 0.5);
}

TEST(NumberBox, ReportsOnlyWhatTheUserIsDoneWith)
{
    NumberBox box({QStringLiteral(" mm")});
    int reports = 0;
    QObject::connect(&box, &QDoubleSpinBox::valueChanged, &box, [&] { ++reports; });
    box.selectAll();
    QTest::keyClicks(&box, "123");
    EXPECT_EQ(reports, 0);
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(reports, 1);
    box.display(7);
    EXPECT_EQ(reports, 1);
}

} // namespace
} // namespace bolster
