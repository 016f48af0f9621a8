// What the state line says of a cover that has come to rest, and where a click on it goes.
#include "WindowTest.h"

#include "Crosshair.h"
#include "CurveEdits.h"
#include "ElidedLabel.h"
#include "FindingsLink.h"
#include "Gesture.h"
#include "ProblemsView.h"
#include "Samples.h"
#include "StatusLine.h"

#include <QDir>
#include <QMenu>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace bolster {
namespace {

TEST(StatusLineTest, WhatACommandSaysStays)
{
    StatusLine line;
    const auto* prompt = line.findChild<ElidedLabel*>();
    line.flashNext(QStringLiteral("The cover sprang"), QStringLiteral("Folds"));
    EXPECT_EQ(prompt->fullText(), "The cover sprang");
    line.flash(QStringLiteral("The first side was changed"));
    line.flashNext(QStringLiteral("The cover sprang"), QStringLiteral("Folds"));
    EXPECT_EQ(prompt->fullText(), "The first side was changed");
    line.findChild<QTimer*>(QStringLiteral("flash-time"))->start(1); // in place of six seconds
    EXPECT_TRUE(QTest::qWaitFor([&] { return prompt->fullText() == "The cover sprang"; })) << "then";
}

class FindingsTest : public WindowTest {
protected:
    StatusLine::Mood mood() { return window.statusLine().mood(); }
    /// And seen, with the stitches and the piping of its seams.
    bool waitUntilKnown()
    {
        return waitUntilAtRest() &&
               QTest::qWaitFor(
                   [&] { return window.findings().known() && isSeen() && mood() != StatusLine::Mood::Busy; },
                   60000);
    }
    bool isSeen() { return window.coverView().pictures(window.solver().surface()); }
    QToolButton* button() { return window.statusLine().findChild<QToolButton*>(QStringLiteral("show-finding")); }
    bool crossShown() { return window.patternView().findChild<Crosshair*>()->isVisible(); }

    /// Lifts the curve that holds the cushion, all of it or one point, far up.
    void lift(std::vector<int> points)
    {
        const Design& design = window.document().design();
        ElementId curve{};
        design.each<FixationCurve>([&](ElementId id, const FixationCurve&) { curve = id; });
        window.document().commit(edits::moveCurvePoints(design, curve, points, Vec3(0, 0, 400)));
    }
};

TEST_F(FindingsTest, GreenMeansThatThereIsNothingToWorryAbout)
{
    for (const char* name : {"box-cushion", "car-seat", "armchair"}) {
        ASSERT_TRUE(open(sample(QString::fromLatin1(name))));
        EXPECT_NE(mood(), StatusLine::Mood::Good) << "not before it is known";
        ASSERT_TRUE(waitUntilKnown());
        EXPECT_EQ(mood(), StatusLine::Mood::Good) << name << ": " << window.statusLine().solverText().toStdString();
        EXPECT_FALSE(button()->isVisible());
    }
}

TEST_F(FindingsTest, TemplatesHaveNothingToWorryAbout)
{
    const QDir folder(shippedFolder("templates"));
    const QStringList files = folder.entryList({"*.json"}, QDir::Files);
    EXPECT_GE(files.size(), 7);
    for (const QString& file : files) {
        ASSERT_TRUE(open(folder.filePath(file)));
        ASSERT_TRUE(waitUntilKnown());
        for (const CoverFinding& finding : window.findings().findings())
            ADD_FAILURE() << file.toStdString() << ": " << finding.text.english() << " "
                          << finding.place.value_or(CoverFinding::Place()).outline.transpose();
    }
}

TEST_F(FindingsTest, WhatIsWrongIsSaidAndAClickGoesThere)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilKnown());
    lift({0});
    EXPECT_NE(mood(), StatusLine::Mood::Good) << "at once";
    ASSERT_TRUE(waitUntilKnown());
    EXPECT_EQ(mood(), StatusLine::Mood::Worried);
    const CoverFinding first = window.findings().findings().front();
    EXPECT_EQ(window.statusLine().solverText().toStdString(), first.text.english());
    ASSERT_TRUE(button()->isVisible());
    EXPECT_FALSE(crossShown());
    auto* words = window.statusLine().findChildren<ElidedLabel*>().back();
    ASSERT_EQ(words->fullText(), window.statusLine().solverText());
    QTest::mouseClick(words, Qt::LeftButton);
    EXPECT_TRUE(window.selection().contains(first.element));
    EXPECT_EQ(crossShown(), first.place.has_value());
    emit button()->menu()->aboutToShow();
    const auto findings = static_cast<int>(window.findings().findings().size());
    EXPECT_EQ(button()->menu()->actions().size(), findings > 1 ? findings + 2 : 1);
    EXPECT_EQ(window.statusLine().solverKey().toStdString(), first.text.key);
    QPointer<QWidget> manual;
    button()->menu()->actions().back()->trigger();
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->inherits("bolster::ManualWindow"))
            manual = widget;
    ASSERT_TRUE(manual);
    EXPECT_TRUE(manual->isVisible());
    delete manual;
    window.command("edit.undo")->trigger();
    ASSERT_TRUE(waitUntilKnown());
    EXPECT_EQ(mood(), StatusLine::Mood::Good);
}

TEST_F(FindingsTest, TheListOfProblemsHasThemAndLeadsThere)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilKnown());
    auto* list = window.findChild<ProblemsView*>();
    ASSERT_TRUE(list);
    EXPECT_EQ(list->count(), 0);
    lift({0});
    ASSERT_TRUE(waitUntilKnown());
    const std::vector<CoverFinding> findings = window.findings().findings();
    const int before = list->count() - static_cast<int>(findings.size());
    ASSERT_GE(before, 0);
    for (int i = 0; i < static_cast<int>(findings.size()); ++i)
        EXPECT_EQ(list->item(before + i)->text().toStdString(),
                  findings[static_cast<std::size_t>(i)].text.english());
    window.selection().clear();
    list->setCurrentRow(before);
    EXPECT_EQ(list->currentKey().toStdString(), findings.front().text.key);
    emit list->itemClicked(list->item(before));
    EXPECT_TRUE(window.selection().contains(findings.front().element));
    window.command("edit.undo")->trigger();
    ASSERT_TRUE(waitUntilKnown());
    EXPECT_EQ(list->count(), 0);
}

TEST_F(FindingsTest, ShowTurnsTheCoverUntilThePlaceIsSeen)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilKnown());
    lift({0});
    ASSERT_TRUE(waitUntilKnown());
    const std::vector<CoverFinding> findings = window.findings().findings();
    const auto found =
        std::ranges::find_if(findings, [](const CoverFinding& one) { return one.place.has_value(); });
    ASSERT_NE(found, findings.end());
    CoverView& view = window.coverView();
    CoverNavigation& navigation = view.navigation();
    navigation.setAnimated(false);
    const std::optional<Vec3> place = view.shown().onCover({found->place->patch, found->place->outline});
    ASSERT_TRUE(place);
    auto* list = window.findChild<ProblemsView*>();
    const int row = list->count() - static_cast<int>(findings.end() - found);
    int turned = 0;
    for (double azimuth = 0; azimuth < 6; azimuth += 1.5)
        for (const double elevation : {-1.2, 0.1, 1.2}) {
            navigation.lookFrom(azimuth, elevation);
            const Camera before = navigation.camera();
            emit list->itemClicked(list->item(row));
            const Camera& camera = navigation.camera();
            turned += camera != before;
            const std::optional<Vec2> pixel = camera.pixel(*place);
            ASSERT_TRUE(pixel && view.rect().contains(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())));
            const CoverHit hit = view.shown().hits().hitSolid(camera, {pixel->x(), pixel->y()});
            EXPECT_TRUE(!hit || camera.depth(hit.position) > camera.depth(*place) - 5)
                << azimuth << " " << elevation;
        }
    EXPECT_GT(turned, 0);
    EXPECT_LT(turned, 12) << "where it is seen nothing moves";
}

TEST_F(FindingsTest, WhatIsTriedIsCalledAPreview)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilKnown());
    const Design& design = window.document().design();
    ElementId curve{};
    design.each<FixationCurve>([&](ElementId id, const FixationCurve&) { curve = id; });
    Gesture gesture(window.document());
    const std::array first{0};
    gesture.update(edits::moveCurvePoints(design, curve, first, Vec3(0, 0, 20)));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window.statusLine().solverText() == QStringLiteral("A preview, not checked yet"); }, 60000))
        << window.statusLine().solverText().toStdString();
    EXPECT_EQ(mood(), StatusLine::Mood::Idle);
    gesture.cancel();
    ASSERT_TRUE(waitUntilKnown());
    EXPECT_EQ(mood(), StatusLine::Mood::Good);
}

TEST_F(FindingsTest, AnotherLimitOfTheFabricIsAnotherJudgement)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(waitUntilKnown());
    ASSERT_EQ(mood(), StatusLine::Mood::Good);
    const Design& design = window.document().design();
    Edit edit;
    design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
        Fabric stiff = fabric;
        stiff.limits = {0.2, 0.2, 0.2};
        edit.changes.push_back({id, design.element(id), makeElement(stiff)});
    });
    window.document().commit(edit);
    ASSERT_TRUE(QTest::qWaitFor([&] { return mood() == StatusLine::Mood::Worried; }, 60000));
    EXPECT_EQ(window.findings().findings().front().kind, CoverFinding::Kind::OverLimit);
}

} // namespace
} // namespace bolster
