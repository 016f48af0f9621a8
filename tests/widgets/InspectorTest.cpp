// The inspector with several elements or points at once, and what its fields take.
#include "Inspector.h"
#include "CurveEdits.h"
#include "Document.h"
#include "ElementEdits.h"
#include "NumberBox.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "TestDesigns.h"
#include "Translated.h"

#include <QAccessible>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace bolster {
namespace {

class InspectorTest : public testing::Test {
protected:
    InspectorTest()
    {
        document.reset(twoSquares());
        inspector.resize(300, 700);
        inspector.show();
    }

    /// The boxes of the row whose label begins so.
    QList<NumberBox*> boxes(const QString& label)
    {
        for (QLabel* found : inspector.widget()->findChildren<QLabel*>())
            if (found->text().startsWith(label) && found->buddy())
                return boxesOf(found->buddy());
        auto* form = qobject_cast<QFormLayout*>(inspector.widget()->layout());
        for (int row = 0; row < form->rowCount(); ++row) {
            const QLayoutItem* item = form->itemAt(row, QFormLayout::LabelRole);
            const auto* text = item ? qobject_cast<QLabel*>(item->widget()) : nullptr;
            if (text && text->text().startsWith(label))
                return boxesOf(form->itemAt(row, QFormLayout::FieldRole)->widget());
        }
        return {};
    }

    static QList<NumberBox*> boxesOf(QWidget* field)
    {
        if (auto* box = qobject_cast<NumberBox*>(field))
            return {box};
        return field->findChildren<NumberBox*>();
    }

    static void type(NumberBox* box, const QString& text)
    {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }

    const Patch& patch(ElementId id) { return *document.design().find<Patch>(id); }
    void set(ElementId id, double pressure)
    {
        Patch changed = patch(id);
        changed.pressure = pressure;
        document.commit(edits::replaceElement(document.design(), id, makeElement(changed), {"Press"}));
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    Inspector inspector{document, selection, problems};
};

TEST(Translated, NumbersAreWrittenAsTheLocaleHasThem)
{
    const Message message{"%1 mm of \"%2\" and %3", {"5.25", "Seat 1.5", "-0.5"}};
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_EQ(translated(message), "5,25 mm of \"Seat 1.5\" and -0,5");
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(translated(message), "5.25 mm of \"Seat 1.5\" and -0.5");
    QLocale::setDefault(before);
}

TEST_F(InspectorTest, ANoteHasSeveralLinesAndIsOneEdit)
{
    const auto note = [&] { return elementNote(*document.design().element(firstSquare)); };
    selection.set({firstSquare});
    auto* box = inspector.widget()->findChild<QPlainTextEdit*>();
    ASSERT_TRUE(box);
    inspector.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&inspector));
    box->setFocus();
    const int before = document.history().count();
    QTest::keyClicks(box, "ask Anna");
    QTest::keyClick(box, Qt::Key_Return);
    QTest::keyClicks(box, "about this");
    EXPECT_EQ(note(), "");
    EXPECT_EQ(document.history().count(), before);
    box->clearFocus();
    EXPECT_EQ(note(), "ask Anna\nabout this");
    EXPECT_EQ(document.history().count(), before + 1);
    document.undo();
    EXPECT_EQ(note(), "");
    document.redo();

    box = inspector.widget()->findChild<QPlainTextEdit*>();
    EXPECT_EQ(box->toPlainText(), "ask Anna\nabout this");
    box->setFocus();
    QTest::keyClicks(box, "nonsense");
    QTest::keyClick(box, Qt::Key_Escape);
    EXPECT_EQ(box->toPlainText(), "ask Anna\nabout this") << "given up";
    box->moveCursor(QTextCursor::End);
    QTest::keyClicks(box, "!");
    selection.set({secondSquare});
    EXPECT_EQ(note(), "ask Anna\nabout this!") << "what was typed is not lost";
    EXPECT_EQ(inspector.widget()->findChild<QPlainTextEdit*>()->toPlainText(), "") << "it is another one's";
    box = inspector.widget()->findChild<QPlainTextEdit*>();
    box->setFocus();
    QTest::keyClicks(box, "kept ");
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return elementNote(*document.design().element(secondSquare)) == "kept"; }, 10000))
        << "without leaving it";
    QTest::keyClicks(box, "by itself");
    EXPECT_EQ(box->toPlainText(), "kept by itself") << "typing goes on where it was";
    document.commit(edits::changeNote(document.design(), firstSquare, std::string(60'000, 'x')));
    selection.set({firstSquare});
    box = inspector.widget()->findChild<QPlainTextEdit*>();
    EXPECT_TRUE(box->isReadOnly());
    EXPECT_LT(box->toPlainText().size(), 51'000);
    box->setFocus();
    box->clearFocus();
    EXPECT_EQ(note().size(), 60'000U) << "what is not shown is not lost";
    selection.clear();
    EXPECT_FALSE(inspector.widget()->findChild<QPlainTextEdit*>()) << "settings have none";
}

TEST_F(InspectorTest, ScrollingThroughItChangesNothing)
{
    const Design before = document.design();
    selection.set({firstSquare});
    QList<QWidget*> fields;
    for (QComboBox* box : inspector.widget()->findChildren<QComboBox*>())
        fields << box;
    for (QSlider* slider : inspector.widget()->findChildren<QSlider*>())
        fields << slider;
    ASSERT_GE(fields.size(), 2);
    const QPointF at(5, 5);
    for (QWidget* field : fields)
        for (const int notches : {1, -1}) {
            QWheelEvent wheel(at, field->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(field, &wheel);
            EXPECT_FALSE(wheel.isAccepted()) << "it is the panel's";
        }
    EXPECT_TRUE(document.design() == before);
}

TEST_F(InspectorTest, TheColourDialogSaysWhatItColours)
{
    const auto titleFor = [this](auto element) {
        const ElementId id = document.design().nextId();
        document.commit(edits::addElement(document.design(), makeElement(element)));
        selection.set({id});
        for (QToolButton* button : inspector.widget()->findChildren<QToolButton*>())
            if (button->text().startsWith('#'))
                button->click();
        auto* dialog = inspector.widget()->findChild<QColorDialog*>();
        const QString title = dialog ? dialog->windowTitle() : QString();
        delete dialog;
        return title;
    };
    EXPECT_EQ(titleFor(Frame()), "Colour of the frame");
    EXPECT_EQ(titleFor(Fabric()), "Colour of the fabric");
}

/// At any width that the dock can have.
TEST_F(InspectorTest, CoordinatesAreShownWhole)
{
    selection.set({});
    const int least = inspector.minimumWidth();
    for (int width = least; width < least + 160; width += 4) {
        inspector.resize(width, 900);
        QCoreApplication::processEvents();
        const QList<NumberBox*> all = inspector.widget()->findChildren<NumberBox*>();
        EXPECT_GE(all.size(), 10);
        for (const NumberBox* box : all) {
            const QRect place(box->mapTo(inspector.viewport(), QPoint(0, 0)), box->size());
            EXPECT_TRUE(inspector.viewport()->rect().contains(place)) << width << " " << place.right();
        }
        for (const NumberBox* box : boxes("Axis through")) {
            const QLineEdit* line = box->findChild<QLineEdit*>();
            EXPECT_GE(line->width(), line->fontMetrics().horizontalAdvance("-214.335") + 4);
        }
    }
}

/// Of one word.
class OneWord : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char*, int) const override
    {
        return qstrcmp(context, "ElementText") == 0 && qstrcmp(text, "%1 patches") == 0
                   ? QStringLiteral("%1 Schnittteile")
                   : QString();
    }
};

TEST_F(InspectorTest, WhatAnEditSaysOfSeveralElementsIsInTheLanguageOfWhoeverReadsIt)
{
    OneWord german;
    QCoreApplication::installTranslator(&german);
    selection.set({firstSquare, secondSquare});
    type(boxes("Pressure").front(), "7");
    const Message verb = document.history().node(document.history().current()).edit.verb;
    const QString shown = translated(verb);
    QCoreApplication::removeTranslator(&german);
    EXPECT_EQ(verb.english(), "Change the pressure of 2 patches");
    EXPECT_TRUE(shown.endsWith("2 Schnittteile")) << qPrintable(shown);
}

TEST_F(InspectorTest, ADoubleClickBehindANumberTakesTheNumber)
{
    NumberBox box({.unit = " mm", .decimals = 2});
    box.display(5);
    box.resize(200, 30);
    box.show();
    auto* line = box.findChild<QLineEdit*>();
    QTest::mouseDClick(line, Qt::LeftButton, {}, {190, 12});
    QTest::keyClicks(line, "7");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(box.value(), 7);
}

TEST_F(InspectorTest, AThirdClickTakesTheNumberToo)
{
    NumberBox box({.unit = " mm", .decimals = 2});
    box.display(589.38);
    box.resize(200, 30);
    box.show();
    auto* line = box.findChild<QLineEdit*>();
    QTest::mouseDClick(line, Qt::LeftButton, {}, {20, 12});
    QTest::mouseClick(line, Qt::LeftButton, {}, {20, 12});
    QTest::keyClicks(line, "420");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(box.value(), 420);
}

TEST_F(InspectorTest, ChangesSeveralPatchesAsOneEdit)
{
    set(secondSquare, 0.25);
    const Design before = document.design();
    selection.set({firstSquare, secondSquare});
    NumberBox* pressure = boxes("Pressure").front();
    EXPECT_EQ(pressure->text(), "");
    EXPECT_EQ(pressure->findChild<QLineEdit*>()->placeholderText(), "varies");
    keepPicture(inspector, "inspector-several");

    type(pressure, "0.5");
    EXPECT_EQ(patch(firstSquare).pressure, 0.5);
    EXPECT_EQ(patch(secondSquare).pressure, 0.5);
    EXPECT_EQ(document.history().count(), 3);
    EXPECT_EQ(document.history().node(2).edit.verb.english(), "Change the pressure of 2 patches");
    EXPECT_EQ(boxes("Pressure").front()->text(), "0.5");
    document.undo();
    EXPECT_TRUE(document.design() == before);
    EXPECT_EQ(boxes("Pressure").front()->text(), "");
}

TEST_F(InspectorTest, TheNameIsTheElementsOwnEvenIfTypingChangedNothing)
{
    const auto typeName = [&](const QString& text) {
        auto* edit = inspector.widget()->findChildren<QLineEdit*>().front();
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
        return inspector.widget()->findChildren<QLineEdit*>().front()->text();
    };
    selection.set({secondSquare});
    const QString taken = QString::fromStdString(patch(firstSquare).name);
    const QString free = typeName(taken);
    EXPECT_NE(free, taken);
    EXPECT_EQ(free, QString::fromStdString(patch(secondSquare).name));
    EXPECT_EQ(typeName(taken), free) << "the free name is its own already: no edit, and the field says so";
    EXPECT_EQ(document.history().count(), 2);
}

/// By AT-SPI, as programs do that type for somebody.
TEST_F(InspectorTest, ANameThatIsSetByAnotherProgramIsTaken)
{
    selection.set({firstSquare});
    const auto name = [&] { return inspector.widget()->findChildren<QLineEdit*>().front(); };
    const std::string before = patch(firstSquare).name;
    const auto set = [&](const QString& text) {
        name()->setFocus();
        QAccessible::queryAccessibleInterface(name())->setText(QAccessible::Value, text);
    };
    set("Left");
    QTest::keyClick(name(), Qt::Key_Escape);
    EXPECT_EQ(name()->text().toStdString(), before) << "given up";
    set("Seat");
    QTest::keyClick(name(), Qt::Key_Return);
    EXPECT_EQ(patch(firstSquare).name, "Seat");
    EXPECT_EQ(document.history().count(), 2);
    document.undo();
    EXPECT_EQ(name()->text().toStdString(), before);
}

TEST_F(InspectorTest, AHighDockDoesNotPullTheRowsApart)
{
    selection.set({firstSquare});
    const auto lowest = [&] {
        QCoreApplication::processEvents();
        int y = 0;
        for (const QLabel* label : inspector.widget()->findChildren<QLabel*>())
            if (label->isVisible())
                y = std::max(y, label->geometry().bottom());
        return y;
    };
    inspector.resize(300, inspector.widget()->sizeHint().height() + 40);
    const int before = lowest();
    inspector.resize(300, 2000);
    EXPECT_LE(lowest(), before + 4);
}

TEST_F(InspectorTest, AnEdgeTakesALengthByNumber)
{
    selection.set({firstSquare}, {{firstSquare, 0}, {firstSquare, 1}});
    NumberBox* length = boxes("Length between").front();
    EXPECT_EQ(length->text(), "100 mm");
    type(length, "3*25 mm");
    EXPECT_LT((patch(firstSquare).outline.points()[1] - Vec2(75, 0)).norm(), 1e-6);
    EXPECT_EQ(document.history().count(), 2);
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());

    // What would break something is not done, and said.
    std::string refused;
    QObject::connect(&document, &Document::refused, [&](const Message& why) { refused = why.english(); });
    Patch bent = patch(firstSquare);
    bent.outline = BSpline2(1, true, {{0, 0}, {100, 0}, {50, 10}, {50, 60}, {0, 60}});
    document.commit({{}, {{firstSquare, nullptr, makeElement(bent)}}});
    selection.set({firstSquare}, {{firstSquare, 1}, {firstSquare, 2}});
    const Design before = document.design();
    type(boxes("Length between").front(), "200");
    EXPECT_TRUE(document.design() == before);
    EXPECT_EQ(refused, "The outline of First would cross or touch itself.");

    selection.set({firstSquare, secondSquare}, {{firstSquare, 1}, {secondSquare, 2}});
    EXPECT_TRUE(boxes("Length between").isEmpty());
}

TEST_F(InspectorTest, TakesTheNumberThatLayBelowVaries)
{
    selection.set({firstSquare, secondSquare});
    const auto pressure = [this] { return boxes("Pressure").front(); }; // the form is made anew after edits
    EXPECT_EQ(pressure()->text(), "0") << "both have it";
    set(secondSquare, 0.25);
    ASSERT_EQ(pressure()->text(), "");
    type(pressure(), "0"); // what the box had last
    EXPECT_EQ(patch(secondSquare).pressure, 0);
    EXPECT_EQ(document.history().count(), 3);

    set(secondSquare, 0.25);
    type(pressure(), "nonsense");
    EXPECT_EQ(document.history().count(), 4) << "refused";
    EXPECT_EQ(pressure()->text(), "");
    QTest::keyClick(pressure(), Qt::Key_Up);
    EXPECT_EQ(document.history().count(), 4) << "no step from nowhere";
}

TEST_F(InspectorTest, WhatIsHalfTypedStaysWhenTheSolverHasSomethingToSay)
{
    selection.set({firstSquare});
    const auto pressure = [this] { return boxes("Pressure").front(); };
    const auto name = [this] { return inspector.widget()->findChildren<QLineEdit*>().front(); };
    int said = 0;
    const auto solverSays = [&] {
        problems.set({{firstSquare, {}, {}, {"%1", {std::to_string(++said)}}, Severity::Warning}});
    };
    const auto typeHalf = [](QWidget* field, const QString& text) {
        field->setFocus();
        QMetaObject::invokeMethod(field, "selectAll");
        QTest::keyClicks(field, text);
    };
    typeHalf(pressure(), "0.2");
    solverSays();
    EXPECT_EQ(pressure()->text(), "0.2");
    QTest::keyClicks(pressure(), "5");
    solverSays();
    QTest::keyClick(pressure(), Qt::Key_Return);
    EXPECT_EQ(patch(firstSquare).pressure, 0.25);
    EXPECT_EQ(document.history().count(), 2);

    typeHalf(pressure(), "0.7");
    solverSays();
    QTest::keyClick(pressure(), Qt::Key_Escape);
    EXPECT_EQ(pressure()->text(), "0.25") << "given up";

    const QString before = name()->text();
    typeHalf(name(), "Hal");
    solverSays();
    EXPECT_EQ(name()->text(), "Hal");
    QTest::keyClick(name(), Qt::Key_Escape);
    EXPECT_EQ(name()->text(), before);

    typeHalf(pressure(), "0.7");
    selection.set({secondSquare});
    EXPECT_EQ(pressure()->text(), "0") << "another element's";
    EXPECT_EQ(patch(firstSquare).pressure, 0.7) << "taken, as whenever the keyboard goes elsewhere";
    EXPECT_EQ(document.history().count(), 3);

    set(secondSquare, 0.5);
    selection.set({firstSquare, secondSquare});
    typeHalf(pressure(), "0.7");
    solverSays();
    EXPECT_EQ(pressure()->text(), "0.7");
    QTest::keyClick(pressure(), Qt::Key_Escape);
    EXPECT_EQ(pressure()->text(), "") << "they differ still";
    QTest::keyClick(pressure(), Qt::Key_Return);
    EXPECT_EQ(document.history().count(), 4) << "the one of set() above";
}

TEST(NumberBox, WhatIsHalfTypedStaysWhenAnotherValueComes)
{
    NumberBox box({QStringLiteral(" mm")});
    std::vector<double> entered;
    QObject::connect(&box, &NumberBox::entered, [&](double value) { entered.push_back(value); });
    const auto typeWhile = [&](const QString& text, std::optional<double> comes) {
        box.display(3);
        box.selectAll();
        QTest::keyClicks(&box, text);
        box.display(comes);
        EXPECT_EQ(box.text(), text + " mm");
        QTest::keyClick(&box, Qt::Key_Return);
    };
    typeWhile("5", 4);
    typeWhile("3", 4); // what it was, but is not any more
    typeWhile("3", std::nullopt);
    EXPECT_EQ(entered, (std::vector<double>{5, 3, 3}));
    entered.clear();
    typeWhile("wide", 4);
    EXPECT_EQ(box.text(), "4 mm") << "refused";
    typeWhile("wide", std::nullopt);
    EXPECT_EQ(box.text(), "") << "refused";
    EXPECT_TRUE(entered.empty());
}

TEST_F(InspectorTest, ChecksAndChoicesShowWhereTheyDiffer)
{
    Patch turned = patch(secondSquare);
    turned.wrongSideOut = true;
    turned.fabric = ElementId{99};
    document.reset(document.design().with({{}, {{secondSquare, nullptr, makeElement(turned)}}}));
    selection.set({firstSquare, secondSquare});
    auto* check = inspector.findChild<QCheckBox*>();
    EXPECT_EQ(check->checkState(), Qt::PartiallyChecked);
    EXPECT_EQ(inspector.findChild<QComboBox*>()->currentIndex(), -1);
    QTest::mouseClick(check, Qt::LeftButton, {}, QPoint(8, check->height() / 2));
    EXPECT_TRUE(patch(firstSquare).wrongSideOut);
    EXPECT_TRUE(patch(secondSquare).wrongSideOut);
    EXPECT_EQ(check->checkState(), Qt::Checked);
    EXPECT_EQ(document.history().count(), 2);
}

TEST_F(InspectorTest, ASliderMovesAllOfThem)
{
    selection.set({firstSquare, secondSquare});
    auto* slider = inspector.findChild<QSlider*>();
    ASSERT_TRUE(slider);
    slider->setSliderDown(true);
    slider->setValue(slider->maximum() / 2);
    EXPECT_TRUE(document.gestureRunning());
    EXPECT_DOUBLE_EQ(patch(firstSquare).pressure, 0.5);
    EXPECT_DOUBLE_EQ(patch(secondSquare).pressure, 0.5);
    slider->setSliderDown(false);
    EXPECT_FALSE(document.gestureRunning());
    EXPECT_EQ(document.history().count(), 2);
}

TEST_F(InspectorTest, ShowsEachKindOfAMixedSelection)
{
    selection.set({firstSquare, secondSquare, squareSeam});
    ASSERT_FALSE(boxes("Pressure").isEmpty());
    QStringList texts;
    for (const QLabel* label : inspector.widget()->findChildren<QLabel*>())
        texts << label->text();
    EXPECT_TRUE(texts.contains("2 patches"));
    EXPECT_TRUE(texts.contains("Continuity"));
    keepPicture(inspector, "inspector-mixed");
}

TEST_F(InspectorTest, PlacesSelectedPointsInTheLayout)
{
    const Design before = document.design();
    selection.set({}, {{secondSquare, 0}, {secondSquare, 1}}); // at 200, 0 and 300, 0
    QList<NumberBox*> place = boxes("Layout");
    ASSERT_EQ(place.size(), 2);
    EXPECT_EQ(place[0]->text(), "");
    EXPECT_EQ(place[1]->text(), "0");
    type(place[1], "-2.5 cm + 5");
    EXPECT_EQ(patch(secondSquare).outline.points()[0], Vec2(0, -20));
    EXPECT_EQ(patch(secondSquare).outline.points()[1], Vec2(100, -20));
    EXPECT_EQ(document.history().node(1).edit.verb.english(), "Move 2 points of Second");
    type(boxes("Layout")[0], "250");
    EXPECT_EQ(patch(secondSquare).outline.points()[0], Vec2(50, -20));
    EXPECT_EQ(patch(secondSquare).outline.points()[1], Vec2(50, -20));
    document.undo();
    document.undo();
    EXPECT_TRUE(document.design() == before);
}

TEST_F(InspectorTest, PlacesSelectedPointsInSpace)
{
    selection.set({}, {{testCurve, 0}, {testCurve, 1}});
    QList<NumberBox*> place = boxes("Space");
    ASSERT_EQ(place.size(), 3);
    EXPECT_EQ(place[0]->text(), "300");
    EXPECT_EQ(place[1]->text(), "");
    type(place[2], "3*25 mm");
    const auto& points = document.design().find<FixationCurve>(testCurve)->curve.points();
    EXPECT_EQ(points[0], Vec3(300, 0, 75));
    EXPECT_EQ(points[1], Vec3(300, 100, 75));
    EXPECT_EQ(document.history().count(), 2);
}

TEST_F(InspectorTest, ShowsCoordinatesInFull)
{
    Frame frame;
    frame.name = "Frame";
    frame.position = Vec3(-214.335, -1093.062, -859.113);
    const ElementId id{90};
    document.commit(Edit{{"Add"}, {{id, nullptr, makeElement(frame)}}});
    selection.set({id});
    QCoreApplication::processEvents();
    const QList<NumberBox*> place = boxes("Position");
    ASSERT_EQ(place.size(), 3);
    for (const NumberBox* box : place) {
        const auto* line = box->findChild<QLineEdit*>();
        EXPECT_GE(line->contentsRect().width(), line->fontMetrics().horizontalAdvance(line->text()))
            << line->width();
    }
}

TEST_F(InspectorTest, ChangesWhatAFrameIsMadeOf)
{
    Frame frame;
    frame.name = "Frame";
    const ElementId id{90};
    document.commit(Edit{{"Add"}, {{id, nullptr, makeElement(frame)}}});
    selection.set({id});
    QComboBox* material = nullptr;
    for (QComboBox* box : inspector.findChildren<QComboBox*>())
        if (box->findText(QStringLiteral("Wood")) >= 0)
            material = box;
    ASSERT_TRUE(material);
    material->setFocus();
    QTest::keyClicks(material, "W");
    const auto kind = [&] { return document.design().find<Frame>(id)->material.kind; };
    EXPECT_EQ(kind(), FrameMaterial::Kind::Wood);
    document.undo();
    EXPECT_EQ(kind(), FrameMaterial::Kind::Plain);
}

TEST(NumberBoxExpressions, TakesUnitsWhereLengthsAre)
{
    const auto typed = [](const NumberBox::Range& range, const char* text) {
        NumberBox box(range);
        box.setLocale(QLocale("en"));
        box.display(7);
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
        return box.value();
    };
    const NumberBox::Range length{QStringLiteral(" mm")};
    EXPECT_DOUBLE_EQ(typed(length, "3*25"), 75);
    EXPECT_DOUBLE_EQ(typed(length, "3*25 mm"), 75);
    EXPECT_DOUBLE_EQ(typed(length, "2.5 cm"), 25);
    EXPECT_DOUBLE_EQ(typed(length, "1 in"), 25.4);
    const NumberBox::Range angle{QStringLiteral("\u00b0")};
    EXPECT_DOUBLE_EQ(typed(angle, "360/8"), 45);
    EXPECT_DOUBLE_EQ(typed(angle, "2 cm"), 7) << "no angle";
}

TEST_F(InspectorTest, PartsOfAFrameAreShownAndHidden)
{
    Frame frame;
    frame.name = "Sofa";
    const ElementId id = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(frame)));
    auto mesh = std::make_shared<TriangleMesh>();
    for (const double x : {0.0, 100.0, 200.0}) { // the first is a part, the others are two pieces of another one
        mesh->points.insert(mesh->points.end(), {{x, 0, 0}, {x + 50 - x / 10, 0, 0}, {x, 50, 20}});
        const auto last = static_cast<std::uint32_t>(mesh->points.size());
        mesh->triangles.push_back({last - 3, last - 2, last - 1});
    }
    mesh->parts = {{"Frame", 0, 1}, {"Cushions", 1, 2}};
    selection.set({id});
    EXPECT_FALSE(inspector.widget()->findChild<QTreeWidget*>()) << "the file is not there yet";
    inspector.setFiles({{{id, mesh}}, {}});
    auto* list = inspector.widget()->findChild<QTreeWidget*>();
    ASSERT_TRUE(list);
    ASSERT_EQ(list->topLevelItemCount(), 2);
    EXPECT_EQ(list->topLevelItem(0)->text(0), QStringLiteral("Frame: 50 \u00d7 50 \u00d7 20 mm"));
    QTreeWidgetItem* cushions = list->topLevelItem(1);
    ASSERT_EQ(cushions->childCount(), 2);
    EXPECT_TRUE(cushions->isExpanded());

    const auto hidden = [&] { return document.design().find<Frame>(id)->hiddenParts; };
    const auto click = [&](QTreeWidgetItem* item) {
        list = inspector.widget()->findChild<QTreeWidget*>();
        list->setCurrentItem(item);
        QTest::keyClick(list, Qt::Key_Space);
        list = inspector.widget()->findChild<QTreeWidget*>();
        cushions = list->topLevelItem(1);
    };
    click(cushions->child(1));
    EXPECT_EQ(hidden(), std::vector<std::string>{"Cushions#2"});
    EXPECT_EQ(cushions->checkState(0), Qt::PartiallyChecked);
    click(cushions->child(0));
    EXPECT_EQ(hidden(), std::vector<std::string>{"Cushions"});
    EXPECT_EQ(cushions->checkState(0), Qt::Unchecked);
    click(cushions->child(0));
    EXPECT_EQ(hidden(), std::vector<std::string>{"Cushions#2"}) << "of a hidden part one piece is shown";
    const auto buttons = inspector.widget()->findChildren<QPushButton*>();
    const auto showAll = std::ranges::find(buttons, "Show a&ll parts", &QPushButton::text);
    ASSERT_NE(showAll, buttons.end());
    (*showAll)->click();
    EXPECT_TRUE(hidden().empty());
    document.undo();
    EXPECT_EQ(hidden(), std::vector<std::string>{"Cushions#2"});
    document.undo();
    document.undo();
    document.undo();
    EXPECT_TRUE(hidden().empty()) << "each an edit";
}

TEST_F(InspectorTest, APieceThatIsPointedAtInTheListIsTold)
{
    Frame frame;
    const ElementId id = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(frame)));
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, 0, 0}, {90, 0, 0}, {0, 50, 0}, {200, 0, 0}, {250, 0, 0}, {200, 50, 0}};
    mesh->triangles = {{0, 1, 2}, {3, 4, 5}};
    mesh->parts = {{"", 0, 2}};
    selection.set({id});
    inspector.setFiles({{{id, mesh}}, {}});
    auto* list = inspector.widget()->findChild<QTreeWidget*>();
    ASSERT_TRUE(list);
    std::vector<std::vector<int>> told;
    const QObject here; // the list tells once more when it goes
    QObject::connect(&inspector, &Inspector::framePiecesPointedAt, &here,
                     [&](ElementId, const std::vector<int>& pieces) { told.push_back(pieces); });
    list->setCurrentItem(list->topLevelItem(0)->child(1));
    list->setCurrentItem(list->topLevelItem(0));
    EXPECT_EQ(told, (std::vector<std::vector<int>>{{1}, {0, 1}}));
}

TEST_F(InspectorTest, PartsOfACushionAreChosenAmongThoseOfItsFrame)
{
    const auto add = [&](const Element& element) {
        const ElementId id = document.design().nextId();
        document.commit(edits::addElement(document.design(), makeElement(element)));
        return id;
    };
    Frame frame;
    frame.hiddenParts = {"Legs"};
    const ElementId chair = add(frame), stool = add(Frame{});
    Cushion cushion;
    cushion.frame = chair;
    cushion.parts = {"Arm"};
    const ElementId id = add(cushion);
    auto mesh = std::make_shared<TriangleMesh>();
    for (const double x : {0.0, 100.0, 200.0, 300.0}) {
        mesh->points.insert(mesh->points.end(), {{x, 0, 0}, {x + 50, 0, 0}, {x, 50, 20}});
        const auto last = static_cast<std::uint32_t>(mesh->points.size());
        mesh->triangles.push_back({last - 3, last - 2, last - 1});
    }
    mesh->parts = {{"Seat", 0, 1}, {"Back", 1, 2}, {"Legs", 3, 1}};
    auto plain = std::make_shared<TriangleMesh>(*mesh);
    plain->parts = {{"Stool", 0, 4}};
    inspector.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&inspector));
    selection.set({id});
    inspector.setFiles({{{chair, mesh}, {stool, plain}}, {}});
    const auto list = [&] { return inspector.widget()->findChild<QTreeWidget*>(); };
    const auto parts = [&] { return document.design().find<Cushion>(id)->parts; };
    const auto click = [&](int row) {
        list()->setFocus();
        list()->setCurrentItem(list()->topLevelItem(row));
        QTest::keyClick(list(), Qt::Key_Space);
    };
    ASSERT_TRUE(list());
    ASSERT_EQ(list()->topLevelItemCount(), 3) << "what the frame hides nobody pads";
    EXPECT_EQ(list()->topLevelItem(1)->text(0), QStringLiteral("Back: 150 \u00d7 50 \u00d7 20 mm"));
    EXPECT_TRUE(list()->topLevelItem(2)->text(0).contains("not in this frame"));
    EXPECT_EQ(list()->topLevelItem(2)->checkState(0), Qt::Checked);

    std::vector<int> told;
    QObject::connect(&inspector, &Inspector::framePiecesPointedAt, list(),
                     [&](ElementId of, const std::vector<int>& pieces) {
                         EXPECT_EQ(of, chair);
                         told = pieces;
                     });
    click(1);
    EXPECT_EQ(told, (std::vector<int>{1, 2})) << "all of it is marked";
    EXPECT_EQ(parts(), (std::vector<std::string>{"Arm", "Back"}));
    click(2);
    EXPECT_EQ(parts(), std::vector<std::string>{"Back"});
    click(1);
    EXPECT_TRUE(parts().empty()) << "those that the cover is fixed to";
    document.undo();
    EXPECT_EQ(parts(), std::vector<std::string>{"Back"});

    cushion.frame = stool; // chosen while the keyboard is in the form
    inspector.focusFirst();
    document.commit(edits::replaceElement(document.design(), id, makeElement(cushion), {}));
    ASSERT_TRUE(list());
    EXPECT_EQ(list()->topLevelItem(0)->text(0), QStringLiteral("Stool: 350 \u00d7 50 \u00d7 20 mm"));
}

TEST_F(InspectorTest, TheFormOfACushionSaysWhatItsFieldsDo)
{
    Cushion cushion;
    const ElementId id = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(cushion)));
    selection.set({id});
    for (const QString label : {"Pushes", "Padding", "Strength", "Slanted faces", "Smallest detail"}) {
        const auto labels = inspector.widget()->findChildren<QLabel*>();
        const auto found = std::ranges::find(labels, label, &QLabel::text);
        ASSERT_NE(found, labels.end()) << label.toStdString();
        EXPECT_GT((*found)->toolTip().size(), 20) << label.toStdString();
    }
}

TEST_F(InspectorTest, OfAScanItIsSaidHowManyPointsAreThereAndWhenItWasThinned)
{
    const QLocale locale;
    Scan scan;
    scan.scale = 1000; // a file in metres
    const ElementId id = document.design().nextId();
    document.commit(edits::addElement(document.design(), makeElement(scan)));
    selection.set({id});
    const auto says = [&](const QString& text) {
        const auto labels = inspector.widget()->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
    };
    auto cloud = std::make_shared<PointCloud>();
    cloud->points.assign(1234, Vec3(0, 0, 0));
    inspector.setFiles({{}, {{id, cloud}}});
    EXPECT_TRUE(says(locale.toString(1234) + " points"));
    auto thinned = std::make_shared<PointCloud>(*cloud);
    thinned->thinnedFrom = 10'000'000;
    thinned->spacing = 0.00283;
    inspector.setFiles({{}, {{id, thinned}}});
    EXPECT_TRUE(says(QString("%1 of %2 points, one every %3 mm")
                         .arg(locale.toString(1234), locale.toString(10'000'000), locale.toString(2.8, 'f', 1))));
    inspector.setFiles({});
    EXPECT_FALSE(says(locale.toString(1234) + " points"));
}

} // namespace
} // namespace bolster
