// Dialogs are opened and answer later; one tool at a time; keys do what they do elsewhere.
#include "WindowTest.h"

#include "CoverView.h"
#include "ElementEdits.h"
#include "FileFlows.h"
#include "FileImportDialog.h"
#include "Inspector.h"
#include "NextStep.h"
#include "NumberBox.h"
#include "RenderDialog.h"
#include "SimplifyChoice.h"
#include "ViewPrint.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPrintDialog>
#include <QProgressDialog>
#include <QSpinBox>
#include <QThread>
#include <QToolTip>
#include <QUrl>

namespace bolster {
namespace {

class DialogsTest : public WindowTest {
protected:
    template <class Dialog>
    static Dialog* opened()
    {
        Dialog* found = nullptr;
        (void)QTest::qWaitFor(
            [&] {
                found = qobject_cast<Dialog*>(QApplication::activeModalWidget());
                return found && found->isVisible();
            },
            20000);
        return found;
    }
    static QAction* withKeys(MainWindow& window, const QKeySequence& keys)
    {
        for (QAction* action : window.commands().findChildren<QAction*>())
            if (action->shortcuts().contains(keys))
                return action;
        return nullptr;
    }
    /// A box of 1 x 1 x 1, as a mesh that says nothing of its unit.
    QString writeBox(double size)
    {
        const QString path = m_folder.filePath(QStringLiteral("box.obj"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        for (const double x : {0.0, size})
            for (const double y : {0.0, size})
                for (const double z : {0.0, size})
                    file.write(QStringLiteral("v %1 %2 %3\n").arg(x).arg(y).arg(z).toLatin1());
        file.write("f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
        return path;
    }
    int frames()
    {
        int count = 0;
        window.document().design().each<Frame>([&](ElementId, const Frame&) { ++count; });
        return count;
    }

    QTemporaryDir m_folder;
};

TEST_F(DialogsTest, NothingComesUpInFrontOfTheImportDialog)
{
    window.command("file.import-frame")->trigger();
    auto* files = opened<QFileDialog>();
    ASSERT_TRUE(files);
    const int loops = QThread::currentThread()->loopLevel();
    files->findChild<QLineEdit*>()->setText(writeBox(800));
    QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    EXPECT_EQ(QThread::currentThread()->loopLevel(), loops) << "nothing waits inside the dialog";
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChildren<QProgressDialog*>().isEmpty(); }))
        << "what said that the file was being read has gone";
    EXPECT_EQ(QApplication::activeModalWidget(), import);
    QTest::keyClick(import, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return frames() == 1; }));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !QApplication::activeModalWidget(); }));
}

TEST_F(DialogsTest, ANewWindowTakesClicksAfterAnImportWasGivenUp)
{
    window.files().imports.importFrame(writeBox(800));
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    QTest::keyClick(import, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !QApplication::activeModalWidget(); }));
    EXPECT_EQ(frames(), 0);
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(DialogsTest, AFrameThatIsLargerThanThePictureIsSeenWhole)
{
    ASSERT_TRUE(open(sample(QStringLiteral("pillow"))));
    ASSERT_TRUE(waitUntilSolved());
    window.coverView().navigation().setAnimated(false);
    const int before = frames();
    window.files().imports.importFrame(writeBox(3400));
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    QTest::keyClick(import, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return frames() == before + 1; }));
    const Box3 box = window.coverView().shown().selectedBox();
    EXPECT_NEAR(box.sizes().maxCoeff(), 3400, 1);
    EXPECT_TRUE(window.coverView().navigation().inPicture(box));
}

TEST_F(DialogsTest, WhatNobodyCouldSeeIsNotImportedWithoutAsking)
{
    window.files().imports.importFrame(writeBox(800));
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    import->setUnit(FileUnit::Custom);
    import->findChild<NumberBox*>()->setValue(1e-6);
    QTest::keyClick(import, Qt::Key_Return);
    auto* question = opened<QMessageBox>();
    ASSERT_TRUE(question);
    EXPECT_TRUE(question->text().contains(QStringLiteral("0.0008 mm"))) << question->text().toStdString();
    QTest::keyClick(question, Qt::Key_Return); // without reading it
    EXPECT_EQ(opened<FileImportDialog>(), import) << "it is still there, with what was chosen";
    EXPECT_EQ(frames(), 0);

    QTest::keyClick(import, Qt::Key_Return);
    answer(QMessageBox::Cancel);
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }));
    import->setUnit(FileUnit::Millimetre);
    QTest::keyClick(import, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return frames() == 1; }));
}

/// A project would keep half of it.
TEST_F(DialogsTest, AFrameWithAFileBesideItBecomesOneFile)
{
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    QFile buffer(m_folder.filePath(QStringLiteral("leg.bin")));
    ASSERT_TRUE(buffer.open(QIODevice::WriteOnly));
    buffer.write(reinterpret_cast<const char*>(corners), sizeof corners);
    buffer.close();
    QFile file(m_folder.filePath(QStringLiteral("leg.gltf")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "Leg", "mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": "leg.bin", "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 0]}]})");
    file.close();

    window.files().imports.importFrame(file.fileName());
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    QTest::keyClick(import, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return frames() == 1; }, 20000));
    window.document().design().each<Frame>([&](ElementId id, const Frame& frame) {
        EXPECT_TRUE(QString::fromStdString(frame.file).endsWith(QLatin1String("leg.obj"))) << frame.file;
        ASSERT_TRUE(window.session().files().meshes.contains(id));
        const TriangleMesh& mesh = *window.session().files().meshes.at(id);
        EXPECT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(mesh.parts.at(0).name, "Leg");
        EXPECT_EQ(frame.scale, 1000) << "as the file said: metres";
    });
}

TEST_F(DialogsTest, AFrameThatIsReplacedKeepsItsPlaceAndSaysWhichFixationsItLeavesBehind)
{
    window.files().imports.importFrame(writeBox(800));
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    import->setUnit(FileUnit::Millimetre);
    QTest::keyClick(import, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return frames() == 1; }));
    ElementId id = noElement;
    Placement placement;
    window.document().design().each<Frame>([&](ElementId frame, const Frame& there) {
        id = frame;
        placement = there;
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.session().files().meshes.contains(id); }));
    const auto curve = [&](const std::string& name, double height) {
        window.document().commit(edits::addElement(
            window.document().design(),
            makeElement(FixationCurve{
                name,
                BSpline3(1, false, {placement.placed({10, 10, height}), placement.placed({700, 10, height})})})));
    };
    curve("Front edge", 800);
    curve("Foot", 0);

    window.files().imports.replaceFile(id);
    auto* files = opened<QFileDialog>();
    ASSERT_TRUE(files);
    files->findChild<QLineEdit*>()->setText(writeBox(786));
    QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
    import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    QTest::keyClick(import, Qt::Key_Return);
    auto* box = opened<QMessageBox>();
    ASSERT_TRUE(box);
    EXPECT_TRUE(box->informativeText().contains(QStringLiteral("Front edge")))
        << box->informativeText().toStdString();
    EXPECT_TRUE(box->informativeText().contains(QStringLiteral("14 mm"))) << box->informativeText().toStdString();
    EXPECT_FALSE(box->informativeText().contains(QStringLiteral("Foot")));
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_EQ(frames(), 1);
    EXPECT_EQ(static_cast<const Placement&>(*window.document().design().find<Frame>(id)), placement);
    window.document().undo();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return window.session().files().meshes.at(id)->boundingBox().max().x() == 800; }));
}

TEST_F(DialogsTest, TheSizeInTheImportDialogIsSeenWhateverItIs)
{
    window.files().imports.importFrame(writeBox(3.4));
    auto* import = opened<FileImportDialog>();
    ASSERT_TRUE(import);
    const auto shows = [&](const QString& figure) {
        const auto labels = import->findChildren<QLabel*>();
        const auto size = std::ranges::find_if(
            labels, [&](const QLabel* label) { return label->text().contains(QStringLiteral(" \u00d7 ")); });
        return size != labels.end() && (*size)->text().startsWith(figure) &&
               QTest::qWaitFor([&] { return (*size)->width() >= (*size)->sizeHint().width(); }, 3000);
    };
    for (const auto& [factor, figure] :
         {std::pair(0.001, "0.0034 "), std::pair(1e-6, "0.0000034 "), std::pair(1.0, "3.4 "),
          std::pair(100.0, "340 "), std::pair(1e6, "3400000 ")}) {
        import->setUnit(FileUnit::Custom);
        import->findChild<NumberBox*>()->setValue(factor);
        EXPECT_TRUE(shows(QLatin1String(figure))) << figure;
    }
    import->close();
}

TEST_F(DialogsTest, WhatAFieldDoesNotTakeIsSaidBesideIt)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.selection().set({window.document().design().elements().begin()->first});
    window.selection().clear(); // the properties of the design
    const auto boxes = [&] { return window.inspector().widget()->findChildren<NumberBox*>(); };
    ASSERT_FALSE(boxes().empty());
    const auto type = [&](const char* text) {
        QToolTip::hideText();
        NumberBox* box = boxes().front();
        const double before = box->value();
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return); // the keyboard goes back to the view
        EXPECT_EQ(box->value(), before) << text;
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().hasFocus() && QToolTip::isVisible(); }))
            << text;
        return QToolTip::text();
    };
    EXPECT_TRUE(type("wide").contains(QStringLiteral("\"wide\" is not a")));
    EXPECT_TRUE(type("-1").contains(QStringLiteral("at least")));
    EXPECT_TRUE(type("1e9").contains(QStringLiteral("at most")));
    EXPECT_TRUE(QToolTip::isVisible()) << "it stays";
}

/// What the solver has to say may come at any moment.
TEST_F(DialogsTest, AHalfTypedNumberIsNotLostWhenTheSolverHasSomethingToSay)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    const Document& document = window.document();
    ElementId patch = noElement;
    document.design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    window.selection().set({patch});
    const auto box = [&] { return window.inspector().widget()->findChild<NumberBox*>(); };
    const QString shown = box()->text();
    const double before = box()->value();
    const int edits = document.history().count();
    const auto typeHalf = [&](const QString& text) {
        box()->setFocus();
        box()->selectAll();
        QTest::keyClicks(box(), text);
        window.inspector().setScanFigures({}); // as problems do: all fields are shown anew
        EXPECT_EQ(box()->text(), text + box()->suffix());
    };
    typeHalf("1");
    QTest::keyClick(box(), Qt::Key_Escape);
    EXPECT_EQ(box()->text(), shown);
    EXPECT_EQ(document.history().count(), edits);
    typeHalf("1");
    QTest::keyClick(box(), Qt::Key_Tab);
    EXPECT_EQ(document.history().count(), edits + 1);
    EXPECT_NE(box()->value(), before);
}

TEST_F(DialogsTest, TheFirstClickIntoANumberTakesAllOfItTheSecondPlacesTheCaret)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.patternView().setFocus();
    auto* box = window.inspector().widget()->findChild<NumberBox*>(); // of the design
    ASSERT_TRUE(box);
    auto* line = box->findChild<QLineEdit*>();
    const QPoint behindTheUnit(line->width() - 3, line->height() / 2);
    QTest::mouseClick(line, Qt::LeftButton, {}, behindTheUnit);
    ASSERT_TRUE(box->hasFocus());
    EXPECT_TRUE(line->hasSelectedText()) << "what is typed takes its place";
    QTest::mouseClick(line, Qt::LeftButton, {}, behindTheUnit);
    EXPECT_FALSE(line->hasSelectedText());
}

/// Its picture takes less time.
void makeSmall(const RenderDialog& dialog)
{
    for (auto* box : dialog.findChildren<QSpinBox*>())
        if (box->accessibleName() == "Width" || box->accessibleName() == "Height")
            box->setValue(160);
}

TEST_F(DialogsTest, APictureIsProposedBesideItsProjectAndItIsSaidWhereItIs)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    bool saved = false;
    window.session().save(m_folder.filePath("my.sofa.bolster"), [&](const Message&) { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, 30000));
    ASSERT_TRUE(waitUntilSolved());
    window.command("file.render-picture")->trigger();
    auto* dialog = opened<RenderDialog>();
    ASSERT_TRUE(dialog);
    for (QAbstractButton* button : dialog->findChild<QDialogButtonBox*>()->buttons())
        if (button->text().contains(QStringLiteral("Render")))
            button->click();
    auto* files = opened<QFileDialog>();
    ASSERT_TRUE(files);
    EXPECT_EQ(files->selectedFiles(), QStringList{m_folder.filePath("my.sofa.png")});
    files->reject();
    const QString path = m_folder.filePath(QStringLiteral("a & b.png"));
    makeSmall(*dialog);
    dialog->renderTo(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->rendering(); }, 60000));
    const auto labels = dialog->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* label) {
        return label->text().contains(path.toHtmlEscaped()) &&
               label->text().contains(QUrl::fromLocalFile(m_folder.path()).toString());
    }));
    dialog->close();
}

TEST_F(DialogsTest, CtrlPPrintsF12MakesAPictureAndPauseHasOtherKeys)
{
    EXPECT_EQ(withKeys(window, QKeySequence::Print), window.command("file.print-view"));
    EXPECT_FALSE(window.command("surface.pause")->shortcuts().isEmpty());
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    window.patternView().setFocus();
    QTest::keyClick(&window.patternView(), Qt::Key_P, Qt::ControlModifier);
    auto* print = opened<QPrintDialog>();
    ASSERT_TRUE(print);
    print->reject();
    takeKeyboard();
    QTest::keyClick(&window.patternView(), Qt::Key_F12);
    auto* dialog = opened<RenderDialog>();
    ASSERT_TRUE(dialog);
    EXPECT_FALSE(window.solver().paused());
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChildren<RenderDialog*>().isEmpty(); }));
    takeKeyboard();
    QTest::keyClick(&window.patternView(), Qt::Key_Period, Qt::ControlModifier);
    EXPECT_TRUE(window.solver().paused());
}

TEST_F(DialogsTest, PaperIsLightInTheDarkTheme)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    window.command("view.theme-dark")->trigger();
    const auto corner = [](const QImage& picture) {
        return picture.pixelColor(3, picture.height() - 4).lightness();
    };
    ASSERT_LT(corner(window.coverView().grabPicture()), 100);
    const ViewSheet sheet = sheetOf(window.coverView(), "Chair");
    EXPECT_GT(corner(sheet.picture), 200);
    EXPECT_EQ(sheet.title, "Chair");
    EXPECT_LT(corner(window.coverView().grabPicture()), 100) << "the window is as it was";
    window.command("view.theme-light")->trigger();
}

TEST_F(DialogsTest, OneToolIsLit)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto lit = [&] {
        QStringList found;
        for (const QAction* action : window.commands().startingWith("tool."))
            if (action->isChecked())
                found << action->objectName();
        return found;
    };
    QAction* select = window.command("tool.select");
    QAction* draw = window.command("tool.draw-fixation");
    EXPECT_EQ(lit(), QStringList{select->objectName()});
    draw->trigger();
    EXPECT_EQ(lit(), QStringList{draw->objectName()});
    window.command("tool.sew")->trigger();
    EXPECT_EQ(lit(), QStringList{window.command("tool.sew")->objectName()});
    EXPECT_EQ(window.coverView().tool(), CoverToolKind::Select);
    draw->trigger();
    EXPECT_EQ(lit(), QStringList{draw->objectName()});
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Select);
    select->trigger();
    EXPECT_EQ(lit(), QStringList{select->objectName()});
    EXPECT_EQ(window.coverView().tool(), CoverToolKind::Select);
    select->trigger();
    EXPECT_EQ(lit(), QStringList{select->objectName()}) << "who asks for what is there has not ended it";
}

TEST_F(DialogsTest, EnterInAFieldLeadsBackToTheView)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const ElementId patch{2};
    window.patternView().setFocus();
    window.selection().set({patch});
    const std::string name = window.document().design().find<Patch>(patch)->name;
    window.inspector().focusFirst();
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(field);
    QTest::keyClicks(field, "Seat");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().hasFocus(); }));
    EXPECT_EQ(window.document().design().find<Patch>(patch)->name, "Seat");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_W);
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Sew);
    EXPECT_EQ(window.document().design().find<Patch>(patch)->name, "Seat");
    window.patternView().setTool(PatternToolKind::Select);

    window.inspector().focusFirst();
    field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(field);
    QTest::keyClicks(field, "Wrong");
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().hasFocus(); }));
    EXPECT_EQ(window.document().design().find<Patch>(patch)->name, "Seat") << "what was typed is given up";
}

TEST_F(DialogsTest, AFinishedPictureLeavesNothingToCancel)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    window.command("file.render-picture")->trigger();
    auto* dialog = opened<RenderDialog>();
    ASSERT_TRUE(dialog);
    const auto has = [&](const QString& text) {
        for (const QAbstractButton* button : dialog->findChild<QDialogButtonBox*>()->buttons())
            if (button->text().remove(u'&') == text)
                return true;
        return false;
    };
    EXPECT_FALSE(has(QStringLiteral("Cancel")));
    makeSmall(*dialog);
    dialog->renderTo(m_folder.filePath(QStringLiteral("picture.png")));
    EXPECT_TRUE(has(QStringLiteral("Cancel")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog->rendering(); }, 60000));
    EXPECT_TRUE(has(QStringLiteral("Close")));
    EXPECT_FALSE(has(QStringLiteral("Cancel")));
    dialog->close();
}

TEST(SimplifyChoiceTest, MillionsOfTrianglesAreSimplifiedUnlessSomebodyWantsThem)
{
    EXPECT_FALSE(SimplifyChoice(500'000).wanted());
    SimplifyChoice large(2'000'000);
    EXPECT_EQ(large.wanted(), 100'000u);
    large.findChild<QCheckBox*>()->click();
    EXPECT_FALSE(large.wanted());
    const SimplifyChoice tooLarge(10'000'000);
    EXPECT_TRUE(tooLarge.wanted());
    EXPECT_FALSE(tooLarge.findChild<QCheckBox*>()->isEnabled());
}

TEST(NextStepTest, BesideAFrameACoverIsFixedToIt)
{
    Design design;
    const auto add = [&](Element element) {
        design =
            design.with({{}, {{design.nextId(), nullptr, std::make_shared<const Element>(std::move(element))}}});
    };
    EXPECT_EQ(firstStep(design), FirstStep::None);
    add(Patch{});
    EXPECT_EQ(firstStep(design), FirstStep::Another);
    add(Frame{});
    EXPECT_EQ(firstStep(design), FirstStep::Fix) << "no second patch is needed";
    add(FixationCurve{});
    EXPECT_EQ(firstStep(design), FirstStep::Attach);
    add(Patch{});
    EXPECT_EQ(firstStep(design), FirstStep::Sew);
}

} // namespace
} // namespace bolster
