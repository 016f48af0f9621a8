// Opening, saving, closing: nothing is lost, nothing bad stops the rest.
#include "WindowTest.h"

#include "Background.h"
#include "DesignFile.h"
#include "ElementEdits.h"
#include "FileFlows.h"
#include "MeshImport.h"
#include "RecentFiles.h"
#include "Samples.h"
#include "StartHint.h"
#include "Theme.h"

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QThreadPool>

namespace bolster {
namespace {

class FilesTest : public WindowTest {
protected:
    bool save(const QString& path)
    {
        bool done = false;
        Message problem;
        window.session().save(path, [&](const Message& why) {
            problem = why;
            done = true;
        });
        return QTest::qWaitFor([&] { return done; }, 60000) && problem.empty();
    }

    void changeSomething()
    {
        Settings settings = window.document().design().settings();
        settings.edgeLength += 1;
        window.document().commit(edits::changeSettings(window.document().design(), settings));
    }

    QString write(const QString& name, const QByteArray& text)
    {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }

    QTemporaryDir folder;
};

/// Closing its dialogs moves the focus, which it must not hear of any more.
TEST_F(FilesTest, AWindowGoesWithTheDialogThatIsOpenInIt)
{
    auto again = std::make_unique<MainWindow>();
    again->show();
    auto* dialog = new QDialog(again.get());
    auto* field = new QLineEdit(dialog);
    dialog->show();
    dialog->activateWindow();
    field->setFocus();
    (void)QTest::qWaitForWindowActive(dialog);
    const QPointer<QDialog> gone = dialog;
    again.reset();
    EXPECT_FALSE(gone);
}

TEST_F(FilesTest, EverySampleOpensFromTheMenu)
{
    const QList<Sample> all = samples();
    ASSERT_GE(all.size(), 6);
    for (const Sample& sample : all) {
        EXPECT_FALSE(sample.title.isEmpty());
        EXPECT_TRUE(open(sample.path)) << qPrintable(sample.path);
        EXPECT_TRUE(window.session().path().isEmpty()) << "a sample must not be written to";
        EXPECT_FALSE(window.document().dirty());
        EXPECT_FALSE(window.banner().shown()) << qPrintable(sample.path + ": " + window.banner().text());
    }
}

TEST_F(FilesTest, SavedDesignsComeBackWithTheirFrames)
{
    ASSERT_TRUE(open(sample("armchair")));
    changeSomething();
    EXPECT_TRUE(window.isWindowModified());
    const QString path = folder.filePath("kept.json");
    ASSERT_TRUE(save(path));
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_EQ(window.session().path(), path);
    const Design saved = window.document().design();

    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(open(path));
    EXPECT_TRUE(window.document().design() == saved);
    EXPECT_EQ(window.session().files().meshes.size(), 1U);
    EXPECT_FALSE(window.banner().shown());
}

TEST_F(FilesTest, ASaveDoesNotStandBehindOtherWork)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    changeSomething();
    QSemaphore end;
    for (int n = 0; n < 2 * backgroundPool().maxThreadCount(); ++n)
        backgroundPool().start([&end] { end.acquire(); });
    EXPECT_TRUE(save(folder.filePath("kept.json")));
    changeSomething();
    EXPECT_TRUE(save(folder.filePath("kept.bolster")));
    end.release(2 * backgroundPool().maxThreadCount());
    backgroundPool().waitForDone();
}

TEST_F(FilesTest, AnotherFileOfTheSameNameIsNotOverwritten)
{
    ASSERT_TRUE(open(sample("armchair")));
    write("armchair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_TRUE(save(folder.filePath("design.json")));
    QFile other(folder.filePath("armchair.obj"));
    ASSERT_TRUE(other.open(QIODevice::ReadOnly));
    EXPECT_LT(other.size(), 100);
    const OpenedDesign opened = openDesign(folder.filePath("design.json"));
    EXPECT_EQ(opened.files.meshes.size(), 1U);
    EXPECT_GT(opened.files.meshes.begin()->second->points.size(), 100U);
}

TEST_F(FilesTest, ClosingAsksBeforeWorkIsLost)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(save(folder.filePath("box.json")));
    changeSomething();

    answer(QMessageBox::Cancel);
    EXPECT_FALSE(window.close());
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    EXPECT_TRUE(window.isVisible());

    answer(QMessageBox::Save);
    window.close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 10000));
    EXPECT_EQ(openDesign(folder.filePath("box.json")).design.settings().edgeLength,
              window.document().design().settings().edgeLength);
}

TEST_F(FilesTest, ChangesMadeWhileAnotherDesignIsReadAreAskedAbout)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    QSemaphore slowDisk;
    QThreadPool& pool = backgroundPool();
    for (int i = 0; i < pool.maxThreadCount(); ++i)
        pool.start([&] { slowDisk.acquire(); });
    window.open(sample("pillow"));
    changeSomething();
    slowDisk.release(pool.maxThreadCount());
    const Design changed = window.document().design();
    answer(QMessageBox::Cancel);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    EXPECT_TRUE(window.document().design() == changed);
}

TEST_F(FilesTest, OpeningThatTakesLongSaysSoAndCanBeCancelled)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Design before = window.document().design();
    QSemaphore slowDisk;
    QThreadPool& pool = backgroundPool();
    const auto reading = [&]() -> QProgressDialog* {
        auto* dialog = window.findChild<QProgressDialog*>();
        return dialog && dialog->isVisible() ? dialog : nullptr;
    };
    for (const bool cancel : {true, false}) {
        for (int i = 0; i < pool.maxThreadCount(); ++i)
            pool.start([&] { slowDisk.acquire(); });
        window.open(sample("pillow"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return reading() != nullptr; }, 20000));
        EXPECT_TRUE(reading()->labelText().contains("pillow")) << qPrintable(reading()->labelText());
        if (cancel)
            QTest::mouseClick(reading()->findChild<QPushButton*>(), Qt::LeftButton);
        slowDisk.release(pool.maxThreadCount());
        EXPECT_TRUE(pool.waitForDone(60000));
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChildren<QProgressDialog*>().isEmpty(); }, 20000));
        EXPECT_EQ(window.document().design() == before, cancel);
    }
}

TEST_F(FilesTest, ClosingWaitsForASaveThatIsOnItsWay)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    changeSomething();
    window.session().save(folder.filePath("box.json"), [](const Message&) {});
    window.close(); // no question: all of it is being saved
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 10000));
    EXPECT_EQ(answered, 0);
    EXPECT_EQ(openDesign(folder.filePath("box.json")).design.settings().edgeLength,
              window.document().design().settings().edgeLength);
}

TEST_F(FilesTest, TheMeshOfAFrameIsKnownAsSuch)
{
    ASSERT_TRUE(open(sample("armchair")));
    ASSERT_TRUE(save(folder.filePath("armchair.json")));
    EXPECT_TRUE(window.session().isElementFile(folder.filePath("armchair.obj")));
    EXPECT_FALSE(window.session().isElementFile(folder.filePath("armchair-cover.obj")));
}

TEST_F(FilesTest, DiscardingCloses)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    changeSomething();
    answer(QMessageBox::Discard);
    window.close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isVisible(); }, 5000));
    EXPECT_EQ(answered, 1);
}

TEST_F(FilesTest, WhatIsSolvedIsTheDesignThatIsOpen)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilSolved());
    ASSERT_TRUE(open(sample("pillow"))); // its elements have the same numbers
    ASSERT_TRUE(waitUntilSolved());
    EXPECT_TRUE(window.solver().status().resting) << "nothing of the cushion is in it";
    EXPECT_EQ(window.solver().surface()->topology->patches.size(), 2U);

    ASSERT_TRUE(open(sample("pillow")));
    EXPECT_TRUE(waitUntilSolved()) << "the same design once more";
    EXPECT_TRUE(window.solver().status().resting);
}

TEST_F(FilesTest, ADesignThatCannotBeOpenedLeavesTheJournalOfUnsavedWork)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    changeSomething();
    const auto copies = [] {
        const QString state = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
        return QDir(state + QStringLiteral("/journals")).entryList({"*.bolster"}, QDir::Files).size();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return copies() > 0; }, 10000));
    answer(QMessageBox::Discard);
    answer(QMessageBox::Ok); // it could not be opened
    window.open(write("broken.json", "{"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 2; }, 10000));
    waitForBackground();
    EXPECT_GT(copies(), 0);
    EXPECT_TRUE(window.document().dirty());
}

TEST_F(FilesTest, WhatWasOpenLatelyIsListedWithItsFolderUntilTheListIsCleared)
{
    recentFiles::clear();
    QFile good(sample("box-cushion"));
    ASSERT_TRUE(good.open(QIODevice::ReadOnly));
    const QByteArray text = good.readAll();
    for (const char* name : {"one", "two"}) {
        QDir(folder.path()).mkdir(name);
        ASSERT_TRUE(open(write(QString(name) + "/box.json", text)));
    }
    QMenu menu;
    window.files().opening.fillRecent(menu);
    ASSERT_GE(menu.actions().size(), 3);
    EXPECT_EQ(menu.actions()[0]->toolTip(), QDir::toNativeSeparators(folder.filePath("two/box.json")));
    EXPECT_TRUE(menu.actions()[0]->text().endsWith("two")) << qPrintable(menu.actions()[0]->text());
    EXPECT_TRUE(menu.actions()[1]->text().endsWith("one")) << qPrintable(menu.actions()[1]->text());

    window.command("file.new")->trigger();
    auto* hint = window.findChild<StartHint*>();
    ASSERT_TRUE(hint && hint->isVisible());
    const auto links = [&] {
        return std::ranges::count_if(hint->findChildren<QLabel*>("recent"), &QWidget::isVisible);
    };
    EXPECT_EQ(links(), 2);
    menu.actions().back()->trigger();
    window.files().opening.fillRecent(menu);
    EXPECT_FALSE(menu.actions()[0]->isEnabled()) << "nothing yet";
    hint->hide();
    hint->show();
    EXPECT_EQ(links(), 0);
}

TEST_F(FilesTest, PlacesInTheSamplesAreSamples)
{
    EXPECT_TRUE(isSample(sample("armchair")));
    EXPECT_TRUE(isSample(QFileInfo(sample("armchair")).absolutePath() + "/untitled.json")) << "not there yet";
    EXPECT_FALSE(isSample(folder.filePath("own.json")));
}

TEST_F(FilesTest, DiscardingOpensTheOtherDesign)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    changeSomething();
    answer(QMessageBox::Discard);
    ASSERT_TRUE(open(sample("pillow")));
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(FilesTest, ABadElementIsShownAndTheRestIsUsable)
{
    QFile good(sample("box-cushion"));
    ASSERT_TRUE(good.open(QIODevice::ReadOnly));
    QByteArray text = good.readAll();
    const QByteArray bad = R"({"id": 900, "kind": "patch", "name": "Bad", "fabric": 1,
        "outline": {"degree": 7, "closed": true, "points": [[0,0],[1,0],[1,1]]}},)";
    text.insert(text.indexOf('[', text.indexOf("\"elements\"")) + 1, bad);
    ASSERT_TRUE(open(write("bad.json", text)));

    EXPECT_TRUE(window.banner().shown());
    EXPECT_TRUE(window.banner().text().contains('1'));
    EXPECT_TRUE(window.document().design().find<Quarantined>(ElementId{900}));
    EXPECT_TRUE(waitUntilSolved());
    EXPECT_TRUE(window.solver().surface());

    // Saving keeps what could not be read.
    ASSERT_TRUE(save(folder.filePath("again.json")));
    EXPECT_TRUE(openDesign(folder.filePath("again.json")).design.find<Quarantined>(ElementId{900}));
}

TEST_F(FilesTest, WhatIsNoDesignChangesNothing)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Design before = window.document().design();
    answer(QMessageBox::Ok);
    window.open(write("broken.json", "{\"format\": \"bolster-design\", "));
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    EXPECT_TRUE(window.document().design() == before);
}

TEST_F(FilesTest, AnImportedFrameIsKeptBeforeAndAfterSaving)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString mesh = write("elsewhere.obj", "v 0 0 0\nv 500 0 0\nv 0 500 0\nv 0 0 500\nf 1 2 3\nf 1 2 4\n");
    const ImportedMesh imported = importMesh(mesh);
    ASSERT_TRUE(imported.mesh);
    Frame frame;
    frame.name = "Block";
    EXPECT_TRUE(window.session().addWithFile(mesh, {imported.mesh, nullptr}, frame).empty());
    ASSERT_EQ(window.session().files().meshes.size(), 1U);
    EXPECT_TRUE(window.selection().contains(window.session().files().meshes.begin()->first)); // to be placed
    QFile::remove(mesh); // the design has its own copy

    ASSERT_TRUE(QDir(folder.path()).mkdir("home"));
    const QString home = folder.filePath("home/design.json");
    ASSERT_TRUE(save(home));
    const OpenedDesign opened = openDesign(home);
    EXPECT_EQ(opened.files.meshes.size(), 1U);

    window.command("edit.undo")->trigger();
    EXPECT_TRUE(window.session().files().meshes.empty());
    window.command("edit.redo")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.session().files().meshes.size() == 1; }, 5000));
}

} // namespace
} // namespace bolster
