// A designer prepares a car seat's pattern for the cutter, in the real window.
#include "WindowTest.h"

#include "CornerWay.h"
#include "CutPattern.h"
#include "CuttingPanel.h"
#include "Designer.h"
#include "ExportPatternDialog.h"
#include "NumberBox.h"
#include "PatchMark.h"
#include "Selection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QSettings>
#include <QSignalSpy>
#include <QToolTip>

#include <algorithm>

namespace bolster {
namespace {

class CuttingTest : public WindowTest {
protected:
    void SetUp() override
    {
        QSettings().remove(QStringLiteral("export-pattern"));
        WindowTest::SetUp();
    }

    const Design& design() { return window.document().design(); }

    template <class T>
    std::vector<std::pair<ElementId, T>> all()
    {
        std::vector<std::pair<ElementId, T>> found;
        design().each<T>([&](ElementId id, const T& value) { found.emplace_back(id, value); });
        return found;
    }

    std::pair<ElementId, Patch> firstPatch() { return all<Patch>().front(); }

    /// A place on the outline, between control points.
    QPoint onOutline(const Patch& patch, double share)
    {
        const BSpline2& outline = patch.outline;
        return patternPixel(
            toLayout(patch, outline.at(outline.wrapped(outline.domainStart() + share * outline.period()))));
    }

    void click(QPoint at)
    {
        move(window.patternView(), at, Qt::NoButton);
        press(window.patternView(), at);
        release(window.patternView(), at);
    }

    void begin(const char* tool)
    {
        window.command(tool)->trigger();
        EXPECT_TRUE(window.command(tool)->isChecked()) << tool;
    }

    /// The cut pattern is shown for the present design.
    bool waitForCut(const std::function<bool(const CutPattern&)>& right)
    {
        return QTest::qWaitFor(
            [&] {
                const auto& cut = window.patternView().shown().cut();
                return cut && right(*cut);
            },
            30000);
    }
};

TEST_F(CuttingTest, NotchesAreClickedOntoOutlinesMovedAndRemoved)
{
    ASSERT_TRUE(open(sample("car-seat")));
    const auto [id, patch] = firstPatch();
    EXPECT_FALSE(window.patternView().shown().cut()) << "its layer is off";
    begin("cutting.notch");
    EXPECT_TRUE(window.command("layer.cutting")->isChecked()) << "what is placed shall be seen";
    const QPoint at = onOutline(patch, 0.13);
    click(at);
    ASSERT_EQ(all<Notch>().size(), 1u);
    const auto [notch, before] = all<Notch>().front();
    EXPECT_EQ(before.place.patch, id);
    EXPECT_TRUE(window.selection().contains(notch));
    EXPECT_TRUE(waitForCut([&, notch = notch](const CutPattern& cut) {
        return std::ranges::any_of(cut.pieces, [&](const CutPiece& piece) {
            return std::ranges::any_of(piece.notches, [&](const CutNotch& n) { return n.element == notch; });
        });
    }));

    // By the tool that selects it is dragged along the outline.
    begin("tool.select");
    const QPoint to = onOutline(patch, 0.17);
    move(window.patternView(), at, Qt::NoButton);
    press(window.patternView(), at);
    move(window.patternView(), (at + to) / 2, Qt::LeftButton);
    move(window.patternView(), to, Qt::LeftButton);
    release(window.patternView(), to);
    ASSERT_EQ(all<Notch>().size(), 1u);
    EXPECT_NE(all<Notch>().front().second.place.at, before.place.at);
    EXPECT_EQ(design().find<Patch>(id)->outline, patch.outline) << "the outline stays";

    QTest::keyClick(&window.patternView(), Qt::Key_Delete);
    EXPECT_TRUE(all<Notch>().empty());
    for (int k = 0; k < 3; ++k)
        window.command("edit.undo")->trigger();
    EXPECT_TRUE(all<Notch>().empty()) << "before it was placed";
    window.command("edit.redo")->trigger();
    EXPECT_EQ(all<Notch>().size(), 1u);
}

TEST_F(CuttingTest, NotchesAndHolesLieWhereIsTyped)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto [id, patch] = firstPatch();
    PatternView& view = window.patternView();
    const auto type = [&](const char* text) {
        QTest::keyClicks(&view, QString::fromUtf8(text));
        QTest::keyClick(&view, Qt::Key_Return);
    };
    const auto distance = [&, id = id] {
        return wayFromCorner(design().find<Patch>(id)->outline, all<Notch>().front().second.place.at)->length;
    };
    begin("cutting.notch");
    const QPoint at = onOutline(patch, 0.05);
    move(view, at, Qt::NoButton);
    type("62.5");
    ASSERT_EQ(all<Notch>().size(), 1u);
    EXPECT_NEAR(distance(), 62.5, 1e-6);
    EXPECT_TRUE(window.selection().contains(all<Notch>().front().first));
    // Farther than the edge is long there is no place.
    move(view, onOutline(patch, 0.08), Qt::NoButton);
    type("5000");
    EXPECT_EQ(all<Notch>().size(), 1u);
    QTest::keyClick(&view, Qt::Key_Escape); // what was typed
    EXPECT_TRUE(window.command("cutting.notch")->isChecked());

    // Dragged, and in the properties.
    const OutlinePlace place = all<Notch>().front().second.place;
    const QPoint from = patternPixel(toLayout(patch, patch.outline.at(place.at)));
    begin("tool.select");
    move(view, from, Qt::NoButton);
    press(view, from);
    move(view, onOutline(patch, 0.06), Qt::LeftButton);
    move(view, onOutline(patch, 0.07), Qt::LeftButton);
    type("80");
    release(view, onOutline(patch, 0.07));
    EXPECT_NEAR(distance(), 80, 1e-6);
    Designer(window).setField(QStringLiteral("From the corner"), QStringLiteral("4 cm"));
    EXPECT_NEAR(distance(), 40, 1e-6);
    Designer(window).setField(QStringLiteral("From the corner"), QStringLiteral("90000"));
    EXPECT_NEAR(distance(), 40, 1e-6) << "no edge has room for it";

    begin("cutting.drill-hole");
    move(view, patternPixel(toLayout(patch, patch.outline.boundingBox().center())), Qt::NoButton);
    type("120, 45");
    ASSERT_EQ(all<DrillHole>().size(), 1u);
    EXPECT_TRUE(all<DrillHole>().front().second.place.position.isApprox(Vec2(120, 45), 1e-9));
}

TEST_F(CuttingTest, AllowancesOfEdgesAreTypedBeforeAndAfterTheClick)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Patch patch = firstPatch().second;
    PatternView& view = window.patternView();
    const auto type = [&](const char* text) {
        QTest::keyClicks(&view, QString::fromUtf8(text));
        QTest::keyClick(&view, Qt::Key_Return);
    };
    begin("cutting.edge-allowance");
    click(onOutline(patch, 0.12));
    ASSERT_EQ(all<EdgeAllowance>().size(), 1u);
    type("20");
    ASSERT_EQ(all<EdgeAllowance>().size(), 1u);
    EXPECT_EQ(all<EdgeAllowance>().front().second.width, 20) << "the key 2 means nothing else here";
    EXPECT_TRUE(window.selection().contains(all<EdgeAllowance>().front().first));
    move(view, onOutline(patch, 0.37), Qt::NoButton); // another edge
    type("1.5 cm");
    ASSERT_EQ(all<EdgeAllowance>().size(), 2u);
    EXPECT_EQ(all<EdgeAllowance>().back().second.width, 15);
    type("abc");
    move(view, onOutline(patch, 0.37), Qt::NoButton);
    type("100000");
    EXPECT_EQ(all<EdgeAllowance>().back().second.width, 15) << "no such width";
}

TEST_F(CuttingTest, ANumberWithoutAnEdgeStaysWithTheToolAndTheCutLineCountsAsTheEdge)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Patch patch = firstPatch().second;
    PatternView& view = window.patternView();
    Designer(window).zoom(10); // cut lines are farther from their edges than a click reaches
    begin("cutting.edge-allowance");
    ASSERT_TRUE(waitForCut([](const CutPattern& cut) { return !cut.pieces.empty(); }));
    const auto camera = [&] { return window.coverView().navigation().camera(); };
    const double azimuth = camera().azimuth;
    QSignalSpy failed(&view, &PatternView::failed);
    move(view, patternPixel(toLayout(patch, patch.outline.boundingBox().center())), Qt::NoButton);
    QTest::keyClick(&view, Qt::Key_2);
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed.front().front().toString().startsWith(QStringLiteral("Point at an edge")));
    EXPECT_EQ(camera().azimuth, azimuth);

    const BSpline2& outline = patch.outline;
    const double t = outline.wrapped(outline.domainStart() + 0.12 * outline.period());
    const Vec2 along = outline.derivative(t).normalized(), right(along.y(), -along.x());
    const Vec2 outward = outline.signedArea() < 0 ? Vec2(-right) : right;
    const QPoint cutLine = patternPixel(toLayout(patch, Vec2(outline.at(t) + 10 * outward)));
    ASSERT_FALSE(view.shown().hit(view.navigation().transform(), cutLine)) << "nothing but the cut line";
    move(view, cutLine, Qt::NoButton);
    QTest::keyClicks(&view, "25");
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(all<EdgeAllowance>().size(), 1u);
    EXPECT_EQ(all<EdgeAllowance>().front().second.width, 25);
}

TEST_F(CuttingTest, TheCheckStandsBesideThePatternWhileItIsMended)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto [id, patch] = firstPatch();
    const CuttingPanel& panel = window.cuttingPanel();
    EXPECT_FALSE(panel.isVisible());
    window.command("cutting.check")->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel.isVisible() && panel.known(); }, 30000));
    const std::size_t before = panel.findings().size();
    // A notch in the middle of nothing that is sewn, by the commands of the window.
    Fabric fabric = *design().find<Fabric>(patch.fabric);
    fabric.cutting.width = 100;
    window.document().commit(
        {{"narrow", {}}, {{patch.fabric, design().element(patch.fabric), makeElement(fabric)}}, {}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel.known() && panel.findings().size() > before; }, 30000));
    EXPECT_EQ(panel.findings().front().harm, CutHarm::CannotBeCut);
    const ElementId wide = panel.findings().front().problem.element;
    emit window.cuttingPanel().itemActivated(window.cuttingPanel().item(0));
    EXPECT_TRUE(window.selection().contains(wide));
    EXPECT_TRUE(window.command("layer.cutting")->isChecked()) << "what is wrong is to be seen";
    window.command("edit.undo")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.known() && panel.findings().size() == before; }, 30000));
}

TEST_F(CuttingTest, EdgesCornersAndHolesAreClickedToo)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto [id, patch] = firstPatch();
    begin("cutting.edge-allowance");
    click(onOutline(patch, 0.125));
    ASSERT_EQ(all<EdgeAllowance>().size(), 1u);
    EXPECT_EQ(all<EdgeAllowance>().front().second.stretch.patch, id);
    EXPECT_EQ(all<EdgeAllowance>().front().second.width, 10);
    begin("cutting.cut-corner");
    click(patternPixel(toLayout(patch, patch.outline.at(patch.outline.corners().front()))));
    ASSERT_EQ(all<CutCorner>().size(), 1u);
    begin("cutting.drill-hole");
    click(patternPixel(toLayout(patch, patch.outline.boundingBox().center())));
    ASSERT_EQ(all<DrillHole>().size(), 1u);
    EXPECT_TRUE(waitForCut([&, id = id](const CutPattern& cut) {
        const auto piece = std::ranges::find(cut.pieces, id, &CutPiece::patch);
        return piece != cut.pieces.end() && piece->holes.size() == 1;
    }));
}

TEST_F(CuttingTest, ThePatternIsExportedAsItIsShown)
{
    ASSERT_TRUE(open(sample("car-seat")));
    QTemporaryDir folder;
    window.command("file.export-pattern")->trigger();
    ExportPatternDialog* dialog = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        dialog = window.findChild<ExportPatternDialog*>();
        return dialog && dialog->isVisible() && dialog->pattern();
    }));
    EXPECT_EQ(dialog->pattern()->pieces.size(), all<Patch>().size());
    auto* format = dialog->findChild<QComboBox*>(QStringLiteral("format"));
    format->setCurrentIndex(static_cast<int>(PatternFormat::Svg));
    EXPECT_FALSE(dialog->findChild<QComboBox*>(QStringLiteral("paper"))->isEnabled()) << "it has no pages";
    dialog->accept();
    QFileDialog* files = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        files = window.findChild<QFileDialog*>();
        return files && files->isVisible();
    }));
    const QString path = folder.filePath(QStringLiteral("seat.svg"));
    files->findChild<QLineEdit*>()->setText(path);
    QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
    waitForBackground();
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    EXPECT_EQ(svg.mid(svg.indexOf("<g id=\"cut\"")).count("<path"), static_cast<int>(all<Patch>().size()));
}

/// The window in which an export is chosen.
class ExportWindowTest : public CuttingTest {
protected:
    ExportPatternDialog* chooser()
    {
        window.command("file.export-pattern")->trigger();
        ExportPatternDialog* dialog = nullptr;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                dialog = window.findChild<ExportPatternDialog*>();
                return dialog && dialog->isVisible() && dialog->pattern();
            },
            30000));
        return dialog;
    }

    static void choose(ExportPatternDialog* dialog, PatternFormat format)
    {
        dialog->findChild<QComboBox*>(QStringLiteral("format"))->setCurrentIndex(static_cast<int>(format));
    }
};

TEST_F(ExportWindowTest, TheSewingSheetShowsItsPages)
{
    ASSERT_TRUE(open(sample("car-seat")));
    ExportPatternDialog* dialog = chooser();
    ASSERT_TRUE(dialog);
    auto* preview = dialog->findChild<SheetPreview*>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return preview->isVisible() && preview->isDrawn(); }, 30000));
    choose(dialog, PatternFormat::SewingSheet);
    auto* pages = dialog->findChild<PagesView*>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return pages->isVisible() && pages->count() > 0; }, 60000));
    EXPECT_FALSE(preview->isVisible());
    choose(dialog, PatternFormat::Pdf);
    EXPECT_TRUE(QTest::qWaitFor([&] { return preview->isVisible() && preview->isDrawn(); }, 30000));
    dialog->reject();
}

TEST_F(ExportWindowTest, WhatIsWrongLeadsOutOfItAndTheChoicesAreKept)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    Fabric fabric = *design().find<Fabric>(firstPatch().second.fabric);
    fabric.cutting.width = 100;
    const ElementId id = firstPatch().second.fabric;
    window.document().commit({{"narrow", {}}, {{id, design().element(id), makeElement(fabric)}}, {}});
    ExportPatternDialog* dialog = chooser();
    ASSERT_TRUE(dialog);
    choose(dialog, PatternFormat::Hpgl);
    auto* list = dialog->findChild<CutFindingsList*>();
    ASSERT_TRUE(list && list->count() > 0);
    emit list->itemActivated(list->item(0));
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(window.cuttingPanel().isVisible());
    EXPECT_FALSE(window.selection().elements().empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.findChildren<ExportPatternDialog*>().isEmpty(); }));
    dialog = chooser();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->order().format, PatternFormat::Hpgl);
    dialog->reject();
}

TEST_F(ExportWindowTest, AnAllowanceThatCannotBeTakenStopsTheExportAndIsSaid)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ExportPatternDialog* dialog = chooser();
    ASSERT_TRUE(dialog);
    auto* allowance = dialog->findChild<NumberBox*>(QStringLiteral("allowance"));
    ASSERT_TRUE(allowance && allowance->isEnabled());
    const double before = allowance->value();
    for (const char* text : {"9999", "wide"}) {
        QToolTip::hideText();
        allowance->setFocus();
        allowance->selectAll();
        QTest::keyClicks(allowance, text);
        dialog->accept(); // as the button does
        EXPECT_TRUE(dialog->isVisible()) << text;
        EXPECT_TRUE(QTest::qWaitFor([&] { return QToolTip::text().startsWith(QStringLiteral("Not taken")); }))
            << text;
        EXPECT_EQ(allowance->value(), before) << text;
    }
    EXPECT_TRUE(window.findChildren<QFileDialog*>().isEmpty());
    allowance->selectAll();
    QTest::keyClicks(allowance, "20");
    dialog->accept();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_EQ(dialog->order().cutting.allowance, 20);
    QFileDialog* files = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] {
        files = window.findChild<QFileDialog*>();
        return files && files->isVisible();
    }));
    files->reject();
}

TEST_F(ExportWindowTest, WritingThatTakesLongSaysSoAndCanBeCancelled)
{
    ASSERT_TRUE(open(sample("car-seat")));
    QTemporaryDir folder;
    QSemaphore slowDisk;
    QThreadPool& pool = backgroundPool();
    for (const bool cancel : {true, false}) {
        ExportPatternDialog* dialog = chooser();
        ASSERT_TRUE(dialog);
        dialog->accept();
        QFileDialog* files = nullptr;
        ASSERT_TRUE(QTest::qWaitFor([&] {
            files = window.findChild<QFileDialog*>();
            return files && files->isVisible();
        }));
        for (int i = 0; i < pool.maxThreadCount(); ++i)
            pool.start([&] { slowDisk.acquire(); });
        files->findChild<QLineEdit*>()->setText(folder.filePath(QStringLiteral("seat.pdf")));
        QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
        const auto writing = [&]() -> QProgressDialog* {
            auto* progress = window.findChild<QProgressDialog*>();
            return progress && progress->isVisible() ? progress : nullptr;
        };
        EXPECT_TRUE(QTest::qWaitFor([&] { return writing() != nullptr; }, 20000));
        if (cancel && writing())
            QTest::mouseClick(writing()->findChild<QPushButton*>(), Qt::LeftButton);
        slowDisk.release(pool.maxThreadCount());
        EXPECT_TRUE(pool.waitForDone(60000));
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                return window.findChildren<QProgressDialog*>().isEmpty() &&
                       window.findChildren<ExportPatternDialog*>().isEmpty();
            },
            20000));
        EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), cancel ? 0 : 1);
    }
}

} // namespace
} // namespace bolster
