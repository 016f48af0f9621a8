// The start page, dropped files, jobs and the tour in the real window.
#include "CoverView.h"
#include "Docks.h"
#include "DropFlow.h"
#include "ElementEdits.h"
#include "FabricLink.h"
#include "FileImportDialog.h"
#include "Jobs.h"
#include "Project.h"
#include "RecentFiles.h"
#include "Selection.h"
#include "StartCard.h"
#include "StartHint.h"
#include "StartPage.h"
#include "StartPictures.h"
#include "Templates.h"
#include "Tour.h"
#include "TourMark.h"
#include "TourPanel.h"
#include "WhatsNew.h"

#include "WindowTest.h"

#include <QMenuBar>
#include <QMimeData>
#include <QSettings>

namespace bolster {
namespace {

class StartTest : public WindowTest {
protected:
    StartPage& page() { return window.startPage(); }

    QList<StartCard*> cards(const char* name)
    {
        QList<StartCard*> found = page().widget()->findChildren<StartCard*>(QLatin1String(name));
        found.removeIf([](const StartCard* card) { return !card->isVisible(); });
        return found;
    }

    QString copied(const QString& from, const QString& name)
    {
        const QString to = folder.filePath(name);
        EXPECT_TRUE(QFile::copy(from, to));
        return to;
    }

    /// As the program begins when no design is named.
    void greetIn(MainWindow& started)
    {
        recentFiles::clear();
        window.document().markSaved();
        started.greet();
        started.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&started));
        waitUntilLaidOut();
    }

    bool waitForOpened(const std::function<void()>& ask)
    {
        bool opened = false;
        const auto connection =
            QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
        ask();
        const bool done = QTest::qWaitFor([&] { return opened; }, 60000);
        QObject::disconnect(connection);
        return done;
    }

    /// In the way of a file manager.
    void dropOnWindow(const QStringList& files)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files)
            urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &drop);
    }

    template <class T>
    int count()
    {
        int found = 0;
        window.document().design().each<T>([&](ElementId, const T&) { ++found; });
        return found;
    }

    QTemporaryDir folder;
};

TEST_F(StartTest, ThePageLiesOverBothViewsUntilSomethingIsOpened)
{
    recentFiles::clear();
    window.greet();
    ASSERT_TRUE(page().isVisible());
    EXPECT_TRUE(page().geometry().contains(window.docks().pattern->geometry()));
    EXPECT_TRUE(page().geometry().contains(window.docks().cover->geometry()));
    EXPECT_FALSE(window.findChild<StartHint*>()->isVisible()) << "its keys would be the page's, too";
    EXPECT_GE(cards("sample-card").size(), 5);
    EXPECT_TRUE(cards("recent-card").isEmpty());
    EXPECT_EQ(page().findChild<QPushButton*>("start-back"), nullptr) << "there is nothing to go back to";
    window.resize(1100, 800);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return page().geometry().contains(window.docks().cover->geometry()); }, 5000));

    ASSERT_TRUE(open(sample("box-cushion")));
    EXPECT_FALSE(page().isVisible());
    window.command("file.start-page")->trigger();
    ASSERT_TRUE(page().isVisible());
    auto* back = page().findChild<QPushButton*>("start-back");
    ASSERT_TRUE(back);
    back->click();
    EXPECT_FALSE(page().isVisible());
    EXPECT_GT(count<Patch>(), 0);
}

TEST_F(StartTest, WhatLiesBelowIsNeitherDrawnNorDressed)
{
    MainWindow started;
    greetIn(started);
    waitForBackground();
    EXPECT_TRUE(started.startPage().geometry().contains(started.docks().cover->geometry()));
    EXPECT_TRUE(started.startPage().isAncestorOf(started.focusWidget())) << "keys go to the page";
    EXPECT_FALSE(started.fabricLink().begun()) << "nobody sees a fabric";
    EXPECT_TRUE(started.fabricLink().maps().empty());
    EXPECT_FALSE(started.coverView().draws()) << "nobody sees a cover";
    EXPECT_TRUE(started.coverView().pictures(started.solver().surface()));

    started.startPage().close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return started.coverView().draws(); }, 60000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return started.fabricLink().upToDate(); }, 60000));
    EXPECT_FALSE(started.fabricLink().maps().empty());
    started.document().markSaved();
    started.close();
}

TEST_F(StartTest, FabricsThatAreSeenBesideThePageAreDressed)
{
    MainWindow started;
    greetIn(started);
    ASSERT_FALSE(started.fabricLink().begun());
    Docks::reveal(started.docks().fabrics);
    EXPECT_TRUE(QTest::qWaitFor([&] { return started.fabricLink().upToDate(); }, 60000));
    EXPECT_FALSE(started.coverView().draws());
    started.document().markSaved();
    started.close();
}

TEST_F(StartTest, KeysAreEnough)
{
    recentFiles::clear();
    window.greet();
    QApplication::sendPostedEvents();
    const QList<StartCard*> samples = cards("sample-card");
    ASSERT_FALSE(samples.isEmpty());
    for (int tabs = 0; tabs < 60 && QApplication::focusWidget() != samples.front(); ++tabs)
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget(), samples.front());
    QTest::keyClick(samples.front(), Qt::Key_Right);
    EXPECT_EQ(QApplication::focusWidget(), samples[1]);
    EXPECT_TRUE(
        page().viewport()->rect().intersects({samples[1]->mapTo(page().viewport(), QPoint()), samples[1]->size()}));
    ASSERT_TRUE(waitForOpened([&] { QTest::keyClick(samples[1], Qt::Key_Return); }));
    EXPECT_FALSE(page().isVisible());
}

TEST_F(StartTest, DrawingBeginsFromThePage)
{
    window.greet();
    ASSERT_EQ(cards("begin-nothing").size(), 1);
    cards("begin-nothing").front()->click();
    EXPECT_FALSE(page().isVisible());
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Rectangle);
}

TEST_F(StartTest, RecentFilesHaveTheirPicturesAndMissingOnesCanBeTakenOut)
{
    recentFiles::clear();
    const QString there = copied(sample("box-cushion"), "there.json"), gone = folder.filePath("gone.json");
    QImage picture(40, 30, QImage::Format_ARGB32);
    picture.fill(Qt::red);
    ASSERT_TRUE(picture.save(folder.filePath("there.png")));
    recentFiles::add(there);
    recentFiles::add(gone);
    window.command("file.start-page")->trigger();
    // The page is filled anew when work that was left becomes known: the cards are others then.
    QList<StartCard*> recent;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            recent = cards("recent-card");
            return recent.size() == 2 && recent[0]->missing() && recent[1]->hasPicture();
        },
        10000));
    EXPECT_EQ(recent[0]->text(), "gone");
    EXPECT_FALSE(recent[1]->missing());
    QTest::keyPress(recent[0], Qt::Key_Delete);
    ASSERT_EQ(cards("recent-card").size(), 1);
    EXPECT_EQ(cards("recent-card").front()->text(), "there");
    EXPECT_EQ(recentFiles::remembered(), QStringList{there});
}

TEST_F(StartTest, ProjectsShowThePictureOfTheirLastVersion)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Fabric fabric{"Another"};
    window.document().commit(edits::addElement(window.document().design(), makeElement(fabric)));
    ASSERT_TRUE(waitUntilAtRest());
    const QString path = folder.filePath("box.bolster");
    QImage found;
    const bool pictured = QTest::qWaitFor(
        [&] {
            bool saved = false;
            window.session().save(path, [&](const Message&) { saved = true; });
            return QTest::qWaitFor([&] { return saved; }, 20000) &&
                   !(found = StartPictures::pictureOf(path)).isNull();
        },
        60000);
    EXPECT_TRUE(pictured);
    EXPECT_EQ(found.size(), QSize(192, 144));
    EXPECT_TRUE(projectPicture(sample("box-cushion")).png.empty()) << "that is no project";
}

TEST_F(StartTest, ATemplateBecomesANewDesignOfItsName)
{
    const QString path = copied(sample("box-cushion"), "bench.json");
    copied(sample("box-cushion"), "own.json");
    const QList<Sample> all = templates(folder.path());
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all[0].title, "Bench");
    EXPECT_EQ(all[1].title, "own");
    recentFiles::clear();
    page().setTemplates(folder.path());
    window.greet();
    ASSERT_EQ(cards("template-card").size(), 2);
    ASSERT_TRUE(waitForOpened([&] { cards("template-card").front()->click(); }));
    EXPECT_FALSE(page().isVisible());
    EXPECT_GT(count<Patch>(), 0);
    EXPECT_TRUE(window.session().path().isEmpty()) << "Save asks where";
    EXPECT_FALSE(window.session().readOnly());
    EXPECT_TRUE(window.windowTitle().startsWith("Bench")) << qPrintable(window.windowTitle());
    EXPECT_TRUE(recentFiles::all().isEmpty());
}

TEST_F(StartTest, DroppedFilesGoOneAfterTheOther)
{
    QStringList elsewhere;
    window.drops().setOtherWindows([&](const QString& file) {
        elsewhere << file;
        return true;
    });
    const QString frame = QFileInfo(sample("pillow")).absolutePath() + "/pillow.obj";
    const QString first = copied(sample("box-cushion"), "first.json"),
                  second = copied(sample("cylinder"), "second.json");
    int dialogs = 0;
    QTimer accept;
    QObject::connect(&accept, &QTimer::timeout, &window, [&] {
        if (auto* dialog = qobject_cast<FileImportDialog*>(QApplication::activeModalWidget())) {
            ++dialogs;
            dialog->accept();
        }
    });
    accept.start(20);
    dropOnWindow({frame, first, second});
    ASSERT_TRUE(QTest::qWaitFor([&] { return count<Frame>() == 1 && !window.drops().busy(); }, 60000));
    EXPECT_EQ(dialogs, 1);
    EXPECT_EQ(window.session().path(), first) << "designs come first: the frame belongs to it";
    EXPECT_EQ(elsewhere, QStringList{second});
}

/// As the program's argument, say.
TEST_F(StartTest, AFrameThatIsOpenedIsImported)
{
    window.greet();
    QTimer accept;
    QObject::connect(&accept, &QTimer::timeout, &window, [&] {
        if (auto* dialog = qobject_cast<FileImportDialog*>(QApplication::activeModalWidget()))
            dialog->accept();
    });
    accept.start(20);
    window.open(QFileInfo(sample("pillow")).absolutePath() + "/pillow.obj");
    ASSERT_TRUE(QTest::qWaitFor([&] { return count<Frame>() == 1 && !window.drops().busy(); }, 60000));
    EXPECT_FALSE(page().isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.coverView().hasFocus(); }, 10000))
        << "keys mean the view, not the frame's name";
}

TEST_F(StartTest, WhatCannotBeOpenedIsSaid)
{
    QFile odd(folder.filePath("odd.docx"));
    ASSERT_TRUE(odd.open(QIODevice::WriteOnly));
    odd.close();
    QString said;
    whenABoxHas([&said](QMessageBox& box) {
        said = box.text() + box.informativeText();
        return box.button(QMessageBox::Ok);
    });
    dropOnWindow({odd.fileName()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    EXPECT_TRUE(said.contains("odd.docx")) << qPrintable(said);
    EXPECT_TRUE(said.contains("OBJ") && said.contains("DXF")) << qPrintable(said);
}

TEST_F(StartTest, ALibraryOfFabricsIsNoDesign)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const int before = count<Fabric>();
    const Design empty;
    const QString path = folder.filePath("velvet.json");
    ASSERT_TRUE(saveDesign(empty.with(edits::addElement(empty, makeElement(Fabric{"Velvet"}))), path).empty());
    dropOnWindow({path});
    EXPECT_TRUE(QTest::qWaitFor([&] { return count<Fabric>() == before + 1; }, 20000));
    EXPECT_GT(count<Patch>(), 0) << "the design stays";
}

TEST_F(StartTest, ClosingAsksWhileSomethingIsWorkedAt)
{
    bool cancelled = false;
    auto job = std::make_unique<RunningJob>("Writing seat.dxf", [&] { cancelled = true; });
    answer(QMessageBox::Cancel);
    EXPECT_FALSE(window.close());
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    QCoreApplication::processEvents();
    EXPECT_TRUE(window.isVisible());
    EXPECT_FALSE(cancelled);
    pressInBox("Stop it");
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 10000));
    EXPECT_TRUE(cancelled);
}

TEST_F(StartTest, JobsAreListedAndCanBeStopped)
{
    bool cancelled = false;
    ASSERT_FALSE(window.docks().jobs->isVisible());
    {
        RunningJob job("Drawing seat.png", [&] { cancelled = true; });
        job.report(0.4);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.docks().jobs->isVisible(); }, 10000));
        QPushButton* stop = nullptr;
        for (auto* button : window.docks().jobs->findChildren<QPushButton*>())
            stop = button;
        ASSERT_TRUE(stop);
        stop->click();
        EXPECT_TRUE(cancelled);
    }
    EXPECT_FALSE(window.docks().jobs->isVisible()) << "it came by itself";
}

/// What is worked at ends with what the window consists of, when its list of jobs is gone already.
TEST_F(StartTest, AWindowGoesWithItsJobs)
{
    auto other = std::make_unique<MainWindow>();
    other->show();
    auto* worker = new QObject(other.get());
    auto job = std::make_shared<RunningJob>("Writing seat.dxf", [] {});
    QObject::connect(other.get(), &QObject::objectNameChanged, worker, [held = job] { Q_UNUSED(held); });
    job.reset(); // only the worker has it now
    ASSERT_TRUE(QTest::qWaitFor([&] { return other->docks().jobs->isVisible(); }, 10000));
    other.reset();
    EXPECT_TRUE(Jobs::all().running().isEmpty());
}

TEST_F(StartTest, TheTourLiesOverNoMenu)
{
    QSettings().remove("tour/step");
    ASSERT_TRUE(waitForOpened([&] { window.command("help.tour")->trigger(); }));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.tour().running(); }, 20000));
    auto* panel = window.findChild<TourPanel*>();
    ASSERT_TRUE(panel && panel->isVisible());
    const QRect bar = window.menuBar()->geometry();
    panel->placeBeside(bar); // what it points at may be there
    EXPECT_FALSE(panel->geometry().intersects(bar));
    QMenu* menu = window.commands().menu("seam");
    menu->popup(window.menuBar()->mapToGlobal(panel->geometry().topLeft() - QPoint(20, bar.height())));
    const auto clear = [&] {
        return !panel->geometry().intersects(QRect(window.mapFromGlobal(menu->pos()), menu->size()));
    };
    EXPECT_TRUE(menu->isVisible());
    EXPECT_TRUE(QTest::qWaitFor(clear, 5000));
    EXPECT_TRUE(window.rect().contains(panel->geometry()));
    menu->close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel->geometry().left() < bar.width(); }, 5000));
    panel->findChild<QPushButton*>("tour-leave")->click();
}

TEST_F(StartTest, TheTourGoesOnByDeedsAndFromWhereItWasLeft)
{
    QSettings().remove("tour/step");
    ASSERT_TRUE(waitForOpened([&] { window.command("help.tour")->trigger(); }));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.tour().running(); }, 20000));
    EXPECT_EQ(window.tour().step(), 0);
    auto* mark = window.findChild<TourMark*>();
    ASSERT_TRUE(mark && mark->isVisible());
    EXPECT_TRUE(window.docks().cover->geometry().contains(mark->target()));

    // A curve is changed, then that is undone.
    Document& document = window.document();
    ElementId curve = noElement, seam = noElement, patch = noElement;
    document.design().each<FixationCurve>([&](ElementId id, const FixationCurve&) { curve = id; });
    document.design().each<Seam>([&](ElementId id, const Seam&) { seam = id; });
    document.design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    ASSERT_NE(curve, noElement);
    FixationCurve moved = *document.design().find<FixationCurve>(curve);
    moved.name += " moved";
    document.commit(edits::replaceElement(document.design(), curve, makeElement(moved), {"Change %1", {"it"}}));
    EXPECT_EQ(window.tour().step(), 1);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(window.tour().step(), 2);
    window.selection().set({seam});
    EXPECT_EQ(window.tour().step(), 3);

    auto* panel = window.findChild<TourPanel*>();
    ASSERT_TRUE(panel);
    panel->findChild<QPushButton*>("tour-leave")->click();
    EXPECT_FALSE(window.tour().running());
    EXPECT_FALSE(mark->isVisible());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    window.command("help.tour")->trigger();
    ASSERT_TRUE(window.tour().running());
    EXPECT_EQ(window.tour().step(), 3);
    panel = window.findChild<TourPanel*>();
    for (int step = 3; step < 7; ++step)
        panel->findChild<QPushButton*>("tour-next")->click();
    EXPECT_EQ(window.tour().step(), 7) << "the end";
    panel->findChild<QPushButton*>("tour-next")->click();
    EXPECT_FALSE(window.tour().running());
    EXPECT_EQ(QSettings().value("tour/step").toInt(), 0);
}

TEST_F(StartTest, WhatIsNewIsSaidOnceAfterAnUpdate)
{
    QSettings().remove("last-version");
    EXPECT_FALSE(newSinceLastStart("1.0")) << "nobody knows another one";
    EXPECT_FALSE(newSinceLastStart("1.0"));
    EXPECT_TRUE(newSinceLastStart("1.1"));
    EXPECT_FALSE(newSinceLastStart("1.1"));
    EXPECT_TRUE(whatsNewText().contains("start page"));
    QSettings().setValue("last-version", "0.0.1");
    window.greet();
    EXPECT_TRUE(window.banner().shown());
    window.banner().dismiss();
    window.greet();
    EXPECT_FALSE(window.banner().shown());
}

} // namespace
} // namespace bolster
