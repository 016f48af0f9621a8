// Projects in the window: the whole history comes back, and nothing that was done is lost.
#include "ProgramThatDies.h"
#include "WindowTest.h"

#include "Background.h"
#include "CompareWindow.h"
#include "CoverView.h"
#include "ElementEdits.h"
#include "FileFlows.h"
#include "HistoryModel.h"
#include "HistoryView.h"
#include "Project.h"
#include "RestingCache.h"
#include "SolverLink.h"
#include "VersionPane.h"
#include "WholeFile.h"

#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QStandardPaths>
#include <QThreadPool>
#include <QTreeWidget>

#include <limits>

namespace bolster {
namespace {

class ProjectFilesTest : public WindowTest {
protected:
    ~ProjectFilesTest() override
    {
        for (const char* name : {"journals", "bin"})
            QDir(stateFolder(name)).removeRecursively();
    }

    static QString stateFolder(const char* name)
    {
        return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + '/' + name;
    }
    static qsizetype journals() { return QDir(stateFolder("journals")).entryList({"*.bolster"}).size(); }

    Message save(const QString& path)
    {
        bool done = false;
        Message problem;
        window.session().save(path, [&](const Message& why) {
            problem = why;
            done = true;
        });
        EXPECT_TRUE(QTest::qWaitFor([&] { return done; }, 30000));
        return problem;
    }

    /// The box cushion as a project of its own; "" when it could not be saved.
    QString savedBox()
    {
        const QString path = folder.filePath("box.bolster");
        EXPECT_TRUE(open(sample("box-cushion")));
        const std::string problem = save(path).english();
        EXPECT_EQ(problem, "");
        return problem.empty() ? path : QString();
    }

    void change(int times = 1)
    {
        for (int i = 0; i < times; ++i) {
            Settings settings = window.document().design().settings();
            settings.edgeLength += 1;
            window.document().commit(edits::changeSettings(window.document().design(), settings));
        }
    }

    /// Two edits of somebody else, saved to the same project. Returns their design.
    Design saveElsewhere(const QString& path)
    {
        Journal::Opened opened = Journal::begin(path, folder.filePath("theirs"));
        EXPECT_TRUE(opened.journal);
        Document document;
        document.reset(opened.project.design, opened.project.history);
        for (const char* name : {"Lid", "Cover"}) {
            const auto patch = document.design().elements().lower_bound(ElementId{2})->first;
            document.commit(edits::renameElement(document.design(), patch, name));
        }
        EXPECT_EQ(opened.journal->record(document.history(), document.committed()).english(), "");
        EXPECT_EQ(opened.journal->save(path).english(), "");
        return document.design();
    }

    /// What begins now waits for `then`, as if the disk were slow. Presses Cancel, or not, in the progress that
    /// comes up, which speaks of the box.
    void whileTheDiskIsSlow(const std::function<void()>& begin, bool cancel)
    {
        QSemaphore slowDisk;
        QThreadPool& pool = backgroundPool();
        for (int i = 0; i < pool.maxThreadCount(); ++i)
            pool.start([&] { slowDisk.acquire(); });
        const auto progress = [&]() -> QProgressDialog* {
            for (auto* dialog : window.findChildren<QProgressDialog*>())
                if (dialog->isVisible())
                    return dialog;
            return nullptr;
        };
        begin();
        EXPECT_TRUE(QTest::qWaitFor([&] { return progress() != nullptr; }, 20000));
        if (auto* dialog = progress()) {
            EXPECT_TRUE(dialog->labelText().contains("box")) << qPrintable(dialog->labelText());
            if (cancel)
                QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
        }
        slowDisk.release(pool.maxThreadCount());
        EXPECT_TRUE(pool.waitForDone(60000));
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChildren<QProgressDialog*>().isEmpty(); }, 20000));
    }

    void triggerUnsaved()
    {
        QMenu menu;
        window.files().left.fillUnsaved(menu);
        ASSERT_FALSE(menu.isEmpty());
        menu.actions().front()->trigger();
    }

    QTemporaryDir folder;
};

TEST_F(ProjectFilesTest, ComeBackWithTheirHistoryAndTheirFiles)
{
    ASSERT_TRUE(open(sample("armchair")));
    change(4);
    window.document().nameVersion(2, "Good one");
    window.command("edit.undo")->trigger();
    const Design design = window.document().design();
    const QString path = folder.filePath("chair.bolster");
    EXPECT_EQ(save(path).english(), "");
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_EQ(window.session().path(), path);

    ASSERT_TRUE(open(sample("box-cushion")));
    EXPECT_EQ(journals(), 0) << "a saved project leaves nothing behind";
    ASSERT_TRUE(open(path));
    EXPECT_TRUE(window.document().design() == design);
    EXPECT_FALSE(window.document().dirty());
    EXPECT_EQ(window.session().files().meshes.size(), 1U);
    EXPECT_FALSE(window.banner().shown()) << qPrintable(window.banner().text());
    EXPECT_EQ(window.document().history().count(), 5);
    EXPECT_EQ(window.document().history().node(2).name, "Good one");
    window.command("edit.redo")->trigger();
    EXPECT_EQ(window.document().design().settings().edgeLength, design.settings().edgeLength + 1);
    while (window.command("edit.undo")->isEnabled())
        window.command("edit.undo")->trigger();
    EXPECT_EQ(window.document().history().current(), 0);
    EXPECT_TRUE(waitUntilSolved());
}

TEST_F(ProjectFilesTest, TheWorkOfAKilledProgramIsThereAtTheNextStart)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const double edge = window.document().design().settings().edgeLength;
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();

    ASSERT_TRUE(ProgramThatDies::run(path, 5, 2));
    EXPECT_EQ(journals(), 1);
    window.recover();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.banner().text().contains('3')) << qPrintable(window.banner().text());
    EXPECT_EQ(window.session().path(), path);
    EXPECT_TRUE(window.document().dirty());
    EXPECT_EQ(window.document().design().settings().edgeLength, edge + 3);
    window.command("edit.redo")->trigger();
    EXPECT_EQ(window.document().design().settings().edgeLength, edge + 4) << "redo came back, too";

    const auto buttons = window.banner().findChildren<QAbstractButton*>();
    const auto back = std::ranges::find_if(buttons, [](auto* b) { return b->text().contains("saved"); });
    ASSERT_NE(back, buttons.end());
    (*back)->click();
    EXPECT_EQ(window.document().design().settings().edgeLength, edge);
    EXPECT_TRUE(window.document().dirty()) << "what was left is a branch, and in no file";
    EXPECT_EQ(window.document().history().count(), 6);
}

TEST_F(ProjectFilesTest, RestoringThatTakesLongSaysSoAndCanBeCancelled)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();
    const Design before = window.document().design();
    ASSERT_TRUE(ProgramThatDies::run(path, 5, 0));
    whileTheDiskIsSlow([&] { triggerUnsaved(); }, true);
    EXPECT_TRUE(window.document().design() == before);
    EXPECT_EQ(WorkJournal::left().size(), 1) << "it stays";
    whileTheDiskIsSlow([&] { triggerUnsaved(); }, false);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_EQ(window.session().path(), path);
    EXPECT_EQ(window.document().history().count(), 6);
}

TEST_F(ProjectFilesTest, WhatIsDoneWhileUnsavedWorkIsLookedForStays)
{
    ASSERT_TRUE(ProgramThatDies::run(sample("pillow"), 2, 0));
    window.recover();
    change();
    const Design changed = window.document().design();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.banner().text().contains("Unsaved work")) << qPrintable(window.banner().text());
    EXPECT_TRUE(window.document().design() == changed);
}

TEST_F(ProjectFilesTest, TheBannerCountsWhatIsNotInTheFileAndGoesWithIt)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change(10);
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();

    ASSERT_TRUE(ProgramThatDies::run(path, 0, 3, 4)); // away from what was saved
    window.recover();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.banner().text().startsWith("4 unsaved edits")) << qPrintable(window.banner().text());
    window.command("file.save")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.banner().shown(); }, 30000));
    EXPECT_FALSE(window.document().dirty());
    EXPECT_EQ(openProject(path).history.count(), 15);
}

TEST_F(ProjectFilesTest, CopiesOfFilesDoNotPileUpWhenProgramsAreKilled)
{
    ASSERT_TRUE(open(sample("armchair")));
    const QString path = folder.filePath("chair.bolster");
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();
    const auto copies = [] {
        return QDir(stateFolder("untitled")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size();
    };
    const auto areGone = [&] { return QTest::qWaitFor([&] { return copies() == 0; }, 30000); };
    ASSERT_TRUE(areGone());
    for (int killed = 0; killed < 3; ++killed)
        ASSERT_TRUE(ProgramThatDies::run(path, 0, 0)); // nothing was done
    ASSERT_TRUE(ProgramThatDies::run(path, 2, 0));
    EXPECT_GE(copies(), 4);
    window.recover();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_EQ(copies(), 2) << "that of the work that is restored, and its lock";
    EXPECT_EQ(window.session().files().meshes.size(), 1U);
    window.command("file.save")->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.document().dirty(); }, 30000));
    window.command("file.new")->trigger();
    EXPECT_TRUE(areGone());
    answer(QMessageBox::Ok);
    window.open(folder.filePath("nothing.bolster")); // cannot be opened
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
    EXPECT_TRUE(areGone());
}

TEST_F(ProjectFilesTest, ANewDesignThatWasNeverSavedIsFoundAgain)
{
    ASSERT_TRUE(ProgramThatDies::run(sample("pillow"), 2, 0));
    window.recover();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.session().path().isEmpty());
    EXPECT_TRUE(window.document().dirty());
    EXPECT_EQ(window.document().history().count(), 3);
}

TEST_F(ProjectFilesTest, OfSeveralCrashedProgramsTheOthersAreSaidToBeThere)
{
    for (const char* name : {"pillow", "box-cushion"})
        ASSERT_TRUE(ProgramThatDies::run(sample(name), 2, 0));
    window.recover();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.banner().text().contains("1 more")) << qPrintable(window.banner().text());
}

/// What a killed program has left does not open.
class DamagedWorkTest : public ProjectFilesTest {
protected:
    void SetUp() override
    {
        ProjectFilesTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        change(edits);
        path = folder.filePath("box.bolster");
        ASSERT_EQ(save(path).english(), "");
        saved = window.document().design();
        window.command("file.new")->trigger();
        ASSERT_TRUE(ProgramThatDies::run(path, 5, 0));
        journal = QDir(stateFolder("journals")).entryInfoList({"*.bolster"}).value(0).filePath();
    }
    void rewrite(const QString& file, const std::function<void(QByteArray&)>& damage)
    {
        QFile there(file);
        ASSERT_TRUE(there.open(QFile::ReadWrite));
        QByteArray bytes = there.readAll();
        damage(bytes);
        there.resize(0);
        there.seek(0);
        there.write(bytes);
    }
    /// The box says it, and which project is meant; then that is open, and nothing is in its way any more.
    void expectSetAside(const std::function<void()>& start)
    {
        QString said;
        whenABoxHas([&](QMessageBox& box) -> QAbstractButton* {
            said = box.text() + box.informativeText();
            return box.button(QMessageBox::Ok);
        });
        start();
        ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1 && window.session().path() == path; }, 30000));
        EXPECT_TRUE(said.contains("box.bolster")) << qPrintable(said);
        EXPECT_TRUE(said.contains("Unsaved work")) << qPrintable(said);
        EXPECT_TRUE(window.document().design() == saved);
        EXPECT_TRUE(WorkJournal::left().isEmpty());
        const auto damaged = WorkJournal::damaged();
        ASSERT_EQ(damaged.size(), 1);
        EXPECT_EQ(damaged[0].place.original, path);
        EXPECT_TRUE(QFileInfo::exists(damaged[0].journal));
        change();
        EXPECT_EQ(save(path).english(), "");
        WorkJournal::putIntoBin(damaged[0]);
        EXPECT_TRUE(WorkJournal::damaged().isEmpty());
    }
    /// How many versions were recovered.
    NodeId recovered()
    {
        const OpenedProject found = openProject(folder.filePath("box (recovered).bolster"));
        return found.problem.empty() ? found.history.count() : 0;
    }

    static constexpr int edits = 120; // more than one page: the log does not hold them all
    QString path;
    QString journal;
    Design saved;
};

TEST_F(DamagedWorkTest, ABeginningOfZeros)
{
    QFile::remove(journal + "-wal");
    rewrite(journal, [](QByteArray& bytes) { bytes.replace(0, 40960, QByteArray(40960, 0)); });
    expectSetAside([&] { window.open(path); });
}

TEST_F(DamagedWorkTest, AnEmptyFile)
{
    rewrite(journal, [](QByteArray& bytes) { bytes.clear(); });
    expectSetAside([&] { window.recover(); });
}

TEST_F(DamagedWorkTest, AFolderInPlaceOfItsLog)
{
    QFile::remove(journal + "-wal");
    ASSERT_TRUE(QDir().mkpath(journal + "-wal/inside"));
    expectSetAside([&] { window.open(path); });
    EXPECT_EQ(recovered(), edits + 1) << "what was in the file itself";
}

TEST_F(DamagedWorkTest, ARow)
{
    rewrite(journal, [](QByteArray& bytes) {
        const qsizetype place = bytes.indexOf("Change the settings");
        ASSERT_GT(place, 0);
        bytes[place] = static_cast<char>(bytes[place] ^ 4);
    });
    expectSetAside([&] { window.open(path); });
    EXPECT_GT(recovered(), 0);
}

TEST_F(DamagedWorkTest, AJournalThatDoesNotSayWhereItBelongsIsOfferedWithItsProject)
{
    rewrite(QString(journal).replace(".bolster", ".about"), [](QByteArray& bytes) { bytes.clear(); });
    window.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown(); }, 30000));
    EXPECT_TRUE(window.banner().text().startsWith("5 unsaved edits")) << qPrintable(window.banner().text());
    EXPECT_EQ(window.session().path(), path);
    EXPECT_EQ(window.document().history().count(), edits + 6);
}

TEST_F(DamagedWorkTest, RecoveringThatTakesLongSaysSoAndCanBeCancelled)
{
    rewrite(journal, [](QByteArray& bytes) {
        const qsizetype place = bytes.indexOf("Change the settings");
        ASSERT_GT(place, 0);
        bytes[place] = static_cast<char>(bytes[place] ^ 4);
    });
    const auto left = WorkJournal::left();
    ASSERT_EQ(left.size(), 1);
    ASSERT_TRUE(WorkJournal::setAside(left[0]));
    const auto recover = [&] {
        triggerUnsaved();
        pressInBox("Recover");
    };
    whileTheDiskIsSlow(recover, true);
    EXPECT_EQ(answered, 1) << "nobody needs to be told what he has done";
    EXPECT_EQ(recovered(), 0);
    EXPECT_EQ(WorkJournal::damaged().size(), 1);
    answered = 0;
    whileTheDiskIsSlow(recover, false);
    answer(QMessageBox::Ok);
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 2; }, 30000));
    EXPECT_GT(recovered(), 0);
}

TEST_F(ProjectFilesTest, KeptForLaterItWaitsForItsProject)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    change(2);
    const Design kept = window.document().design();
    window.session().journal().setFate(WorkJournal::Fate::KeepForLater);
    window.session().startNew();
    ASSERT_EQ(WorkJournal::left().size(), 1);
    EXPECT_TRUE(WorkJournal::left()[0].kept);
    window.recover(); // nothing has crashed
    EXPECT_FALSE(window.banner().shown());
    ASSERT_TRUE(open(path));
    EXPECT_TRUE(window.document().design() == kept);
    EXPECT_TRUE(window.document().dirty());
}

TEST_F(ProjectFilesTest, KeptWorkOfASampleHasItsName)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString title = window.session().title();
    change();
    window.session().journal().setFate(WorkJournal::Fate::KeepForLater);
    window.session().startNew();
    const auto left = WorkJournal::left();
    ASSERT_EQ(left.size(), 1);
    EXPECT_EQ(left[0].place.original, QString());
    EXPECT_EQ(left[0].place.title, title);
    QMenu menu;
    window.files().left.fillUnsaved(menu);
    EXPECT_TRUE(menu.actions().front()->text().startsWith(title)) << qPrintable(menu.actions().front()->text());
    menu.actions().front()->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.document().history().count() == 2; }, 30000));
    EXPECT_EQ(window.session().title(), title);
}

TEST_F(ProjectFilesTest, TheCameraStandsWhereItStoodWhenTheProjectWasClosed)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    ASSERT_TRUE(waitUntilAtRest());
    const auto standing = [&] { return static_cast<const Viewpoint&>(window.coverView().navigation().camera()); };
    Viewpoint own;
    own.target = {12, 34, 56.7};
    own.distance = 300;
    own.azimuth = 2;
    own.perspective = false;
    window.coverView().navigation().setCamera(Camera{own, {1, 1}});
    ASSERT_TRUE(open(sample("pillow")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return standing().azimuth != own.azimuth; }, 60000))
        << "a sample is seen as it looks best";

    const QString link = folder.filePath("link.bolster");
    ASSERT_TRUE(QFile::link(path, link));
    for (const QString& file : {path, link}) {
        ASSERT_TRUE(open(file));
        ASSERT_TRUE(waitUntilAtRest());
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return window.coverView().shown().surface() == window.solver().surface(); }));
        EXPECT_TRUE(standing() == own) << "also when the cover has come";
        EXPECT_FALSE(window.isWindowModified());
        EXPECT_FALSE(window.document().hasUnsavedWork());
    }
    change();
    window.command("file.revert")->trigger();
    EXPECT_EQ(window.document().history().current(), 0);
    ASSERT_TRUE(waitUntilAtRest());
    EXPECT_TRUE(standing() == own);
    window.document().markSaved();
    window.session().startNew();
    EXPECT_TRUE(QTest::qWaitFor([&] { return standing().distance != own.distance; }));
}

TEST_F(ProjectFilesTest, OnlyWhatIsInAFileCanBeRevertedToIt)
{
    EXPECT_FALSE(window.command("file.revert")->isEnabled()) << "a new design";
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    EXPECT_FALSE(window.command("file.revert")->isEnabled()) << "a sample is nobody's file";
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    EXPECT_FALSE(window.command("file.revert")->isEnabled()) << "nothing has changed since";
    change();
    EXPECT_TRUE(window.command("file.revert")->isEnabled());
    window.command("file.revert")->trigger();
    EXPECT_EQ(window.document().history().current(), 1);
    EXPECT_FALSE(window.command("file.revert")->isEnabled());
}

TEST_F(ProjectFilesTest, WhatIsDiscardedLiesInTheBin)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    EXPECT_EQ(journals(), 1);
    answer(QMessageBox::Discard);
    ASSERT_TRUE(open(sample("pillow")));
    EXPECT_EQ(journals(), 0);
    EXPECT_EQ(QDir(stateFolder("bin")).entryList({"*.bolster"}).size(), 1);
    EXPECT_TRUE(WorkJournal::left().isEmpty());
}

TEST_F(ProjectFilesTest, AnOlderStateOfTheFileIsReplaced)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    ASSERT_TRUE(QFile::copy(path, folder.filePath("older.bolster")));
    change();
    ASSERT_EQ(save(path).english(), "");
    QFile::remove(path);
    ASSERT_TRUE(QFile::rename(folder.filePath("older.bolster"), path)); // all in it is known
    change();
    EXPECT_EQ(save(path).english(), "");
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(ProjectFilesTest, WhatSomebodyElseHasSavedIsNotReplaced)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    saveElsewhere(path);
    change();
    EXPECT_FALSE(save(path).empty());
    EXPECT_TRUE(window.session().changedByOthers());
    EXPECT_TRUE(window.document().dirty());
    EXPECT_EQ(save(folder.filePath("mine.bolster")).english(), "");
    EXPECT_FALSE(window.session().changedByOthers());
    EXPECT_FALSE(window.document().dirty());
}

/// What is in the place of a project, or of a design as text, that somebody has removed.
class StrangerTest : public ProjectFilesTest {
protected:
    void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        ASSERT_TRUE(file.open(QFile::WriteOnly));
        file.write(bytes);
    }
    static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    /// Saving asks, and what is there is beside the new file afterwards.
    void expectKept(const QString& path, const QByteArray& stranger)
    {
        change();
        EXPECT_FALSE(save(path).empty());
        EXPECT_TRUE(window.session().placeTaken());
        EXPECT_EQ(bytesOf(path), stranger);
        const QString other =
            folder.filePath(QFileInfo(path).completeBaseName() + " (other)." + QFileInfo(path).suffix());
        pressInBox("Keep the other file");
        window.command("file.save")->trigger();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.isWindowModified(); }, 30000));
        EXPECT_EQ(bytesOf(other), stranger);
        EXPECT_TRUE(openDesignOrProject(path).design == window.document().design());
        QFile::remove(other);
    }
};

TEST_F(StrangerTest, IsNeverReplacedByAProject)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    for (const QByteArray& stranger : {QByteArray("my only copy"), QByteArray(), bytesOf(sample("pillow"))}) {
        QFile::remove(path);
        write(path, stranger);
        expectKept(path, stranger);
    }
    saveElsewhere(path); // newer, and damaged then
    QByteArray damaged = bytesOf(path);
    for (qsizetype i = damaged.size() / 2; i < damaged.size(); i += 100) // single ones may lie where nothing is
        damaged[i] = static_cast<char>(damaged[i] ^ 4);
    write(path, damaged);
    ASSERT_NE(openProject(path).problem.english(), "");
    expectKept(path, damaged);
}

TEST_F(StrangerTest, AnotherProjectIsAskedAboutToo)
{
    ASSERT_TRUE(open(sample("pillow")));
    ASSERT_EQ(save(folder.filePath("pillow.bolster")).english(), "");
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    const QByteArray pillow = bytesOf(folder.filePath("pillow.bolster"));
    write(path, pillow);
    expectKept(path, pillow);
}

TEST_F(StrangerTest, ANewLinkIsNotFollowed)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    const QString moved = folder.filePath("moved.bolster");
    ASSERT_TRUE(QFile::rename(path, moved));
    const QByteArray before = bytesOf(moved);
    ASSERT_TRUE(QFile::link(moved, path));
    expectKept(path, before);
    EXPECT_EQ(bytesOf(moved), before);
    QFile::remove(path);
    ASSERT_TRUE(QFile::link(folder.filePath("nowhere"), path));
    change();
    EXPECT_FALSE(save(path).empty());
    EXPECT_TRUE(window.session().placeTaken());
    EXPECT_TRUE(QFileInfo(path).isSymLink());
}

TEST_F(StrangerTest, ALinkThatWasOpenedIsFollowed)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString real = folder.filePath("real.bolster");
    ASSERT_EQ(save(real).english(), "");
    const QString path = folder.filePath("link.bolster");
    ASSERT_TRUE(QFile::link(real, path));
    ASSERT_TRUE(open(path));
    for (int saves = 0; saves < 2; ++saves) {
        change();
        EXPECT_EQ(save(path).english(), "");
    }
    EXPECT_TRUE(QFileInfo(path).isSymLink());
    EXPECT_TRUE(openProject(real).design == window.document().design());
}

TEST_F(StrangerTest, IsNeverReplacedByADesignAsText)
{
    const QString path = folder.filePath("pillow.json");
    ASSERT_TRUE(QFile::copy(sample("pillow"), path));
    ASSERT_TRUE(open(path));
    write(path, bytesOf(path)); // by a sync service
    change();
    EXPECT_EQ(save(path).english(), "");
    change();
    EXPECT_EQ(save(path).english(), "");
    const QByteArray theirs = bytesOf(path) + "\n";
    write(path, theirs);
    expectKept(path, theirs);
}

TEST_F(ProjectFilesTest, WhatSomebodyElseHasSavedBecomesABranch)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    const Design theirs = saveElsewhere(path);
    change();
    const Design mine = window.document().design();
    QTimer pressing;
    QObject::connect(&pressing, &QTimer::timeout, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        for (QAbstractButton* button : box ? box->buttons() : QList<QAbstractButton*>())
            if (button->text().contains("branch")) {
                button->click();
            }
    });
    pressing.start(20);
    window.command("file.save")->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.banner().shown() && !window.document().dirty(); }, 30000));
    EXPECT_TRUE(window.document().design() == mine);
    const History& history = window.document().history();
    EXPECT_EQ(history.count(), 4) << "the start, ours, and two of theirs";
    const OpenedProject both = openProject(path, ProjectCheck::Everything);
    EXPECT_EQ(both.problem.english(), "");
    EXPECT_EQ(both.history.count(), history.count());

    for (QAbstractButton* button : window.banner().findChildren<QAbstractButton*>())
        if (button->text().remove(u'&').contains("Go there")) {
            button->click();
            break;
        }
    EXPECT_TRUE(window.document().design() == theirs);
    EXPECT_EQ(history.node(history.current()).name.rfind("From the file", 0), 0U);
    window.document().jumpTo(0);
}

TEST_F(ProjectFilesTest, EditsMadeWhileSavingAreProtectedAndUnsaved)
{
    ASSERT_TRUE(open(sample("armchair")));
    const QString path = folder.filePath("chair.bolster");
    ASSERT_EQ(save(path).english(), "");
    bool done = false;
    change();
    window.session().save(path, [&](const Message& why) {
        EXPECT_EQ(why.english(), "");
        done = true;
    });
    int during = 0;
    while (!done) {
        change();
        ++during;
        QApplication::processEvents();
    }
    const OpenedProject saved = openProject(path, ProjectCheck::Everything);
    EXPECT_EQ(saved.problem.english(), "");
    EXPECT_EQ(window.document().saved(), saved.history.current());
    if (saved.history.count() < window.document().history().count()) {
        EXPECT_TRUE(window.document().dirty());
    }
    EXPECT_GT(during, 0);
}

TEST_F(ProjectFilesTest, WhatAnotherWindowHasOpenIsShownWithoutItsPlace)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    MainWindow other;
    bool opened = false;
    QObject::connect(&other.session(), &DesignSession::opened, [&] { opened = true; });
    answer(QMessageBox::Cancel);
    other.open(path);
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000));
    EXPECT_FALSE(opened);
    answer(QMessageBox::Open);
    other.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened; }, 30000));
    EXPECT_TRUE(other.session().path().isEmpty()) << "Save must not write to it";
    EXPECT_TRUE(other.windowTitle().contains("(read-only)")) << qPrintable(other.windowTitle());
    EXPECT_FALSE(window.windowTitle().contains("(read-only)")) << qPrintable(window.windowTitle());
    EXPECT_TRUE(other.document().design() == window.document().design());
}

TEST_F(ProjectFilesTest, AnotherNameOfAFileThatIsOpenElsewhereIsNoWayToTakeIt)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    const QString link = folder.filePath("link.bolster");
    ASSERT_TRUE(QFile::link(path, link));
    MainWindow other;
    other.show();
    answer(QMessageBox::Cancel);
    other.open(link);
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 10000)) << "it is the same file";

    const std::string before = readWholeFile(path, 1 << 24).bytes;
    other.files().saving.saveAs();
    QFileDialog* files = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) != nullptr; }, 10000));
    QString said;
    answer(QMessageBox::Yes); // replace it
    files->findChild<QLineEdit*>()->setText(path);
    QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
    whenABoxHas([&](QMessageBox& box) {
        said = box.informativeText();
        return box.button(QMessageBox::Ok);
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !said.isEmpty(); }, 10000));
    EXPECT_TRUE(said.contains("open in another window")) << qPrintable(said);
    EXPECT_TRUE(other.session().path().isEmpty());
    EXPECT_TRUE(readWholeFile(path, 1 << 24).bytes == before);
}

TEST_F(ProjectFilesTest, AnEmptyVersionIsComparedAsWell)
{
    window.document().reset(Design());
    for (const char* name : {"Red", "Blue"})
        window.document().commit(edits::addElement(window.document().design(), makeElement(Fabric{.name = name})));
    for (const NodeId node : {1, 0}) {
        emit window.findChild<HistoryView*>()->compareWanted(node);
        auto* compare = window.findChild<CompareWindow*>();
        ASSERT_TRUE(compare);
        EXPECT_EQ(compare->left().design().elements().size(), static_cast<std::size_t>(node));
    }
}

TEST_F(ProjectFilesTest, VersionsAreComparedAndPartsTaken)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const auto top = window.document().design().elements().lower_bound(ElementId{2})->first;
    const Design first = window.document().design();
    window.document().commit(edits::renameElement(first, top, "Lid"));
    change();
    emit window.findChild<HistoryView*>()->compareWanted(0);
    auto* compare = window.findChild<CompareWindow*>();
    ASSERT_TRUE(compare);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(compare));
    QTreeWidget& list = compare->differences();
    ASSERT_EQ(list.topLevelItemCount(), 2) << "the settings and the lid";
    EXPECT_EQ(list.topLevelItem(1)->text(0), "Lid");
    EXPECT_EQ(list.topLevelItem(1)->child(0)->text(2), "Lid");
    EXPECT_FALSE(compare->take().isEnabled());
    list.topLevelItem(1)->setSelected(true);
    ASSERT_TRUE(compare->take().isEnabled());
    QTest::mouseClick(&compare->take(), Qt::LeftButton);
    EXPECT_EQ(*window.document().design().element(top), *first.element(top));
    EXPECT_EQ(window.document().design().settings().edgeLength, first.settings().edgeLength + 1);
    EXPECT_EQ(list.topLevelItemCount(), 1);

    CoverView& left = compare->left().coverView();
    CoverView& right = compare->right().coverView();
    const auto turn = [&left] { // as with the wheel: at once
        Camera camera = left.navigation().camera();
        camera.azimuth += 0.4;
        left.navigation().setCamera(camera);
        return camera.azimuth;
    };
    EXPECT_EQ(turn(), right.navigation().camera().azimuth);
    compare->together().click();
    EXPECT_NE(turn(), right.navigation().camera().azimuth);

    auto* pattern = compare->findChild<PatternView*>(); // looked at, not edited
    const std::uint64_t revision = window.document().revision();
    QTest::keyClick(pattern, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(pattern, Qt::Key_Delete);
    EXPECT_EQ(window.document().revision(), revision);
    EXPECT_FALSE(left.visibility().layerVisible(CoverView::Layer::Checker)) << "fabrics, as in the window";
    QTest::keyClick(pattern, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChild<CompareWindow*>() == nullptr; }))
        << "closed, and its memory given back";
}

TEST_F(ProjectFilesTest, AComparedVersionSaysThatItIsBeingComputed)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilSolved());
    change();
    const NodeId neverShown = window.document().history().current();
    change(); // at once: nobody has come to solve the one before
    ASSERT_TRUE(waitUntilSolved());
    emit window.findChild<HistoryView*>()->compareWanted(neverShown);
    auto* compare = window.findChild<CompareWindow*>();
    ASSERT_TRUE(compare);
    const auto computing = [](VersionPane& pane) {
        return !pane.findChild<QWidget*>(QStringLiteral("computing"))->isHidden();
    };
    EXPECT_TRUE(computing(compare->left())); // at once: what is computed comes later, however quickly
    EXPECT_FALSE(computing(compare->right())) << "the window has that already";
    EXPECT_TRUE(QTest::qWaitFor([&] { return !computing(compare->left()); }, 120000));
    EXPECT_EQ(compare->differences().topLevelItem(0)->text(0), "Design");

    // The window has shown the first version: nothing of it has to be computed again.
    const std::size_t kept = window.solver().kept()->count();
    emit window.findChild<HistoryView*>()->compareWanted(0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !computing(compare->left()); }, 120000));
    EXPECT_EQ(window.solver().kept()->count(), kept);
    compare->close();
}

TEST_F(ProjectFilesTest, VersionsHavePicturesThatComeBack)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change();
    const NodeId node = window.document().history().current();
    auto* model = &window.findChild<HistoryView*>()->history();
    const auto toolTip = [&] { return model->indexOf(node).data(Qt::ToolTipRole).toString(); };
    EXPECT_TRUE(QTest::qWaitFor([&] { return toolTip().contains("<img"); }, 60000));
    EXPECT_FALSE(model->indexOf(node).data(HistoryModel::PictureRole).value<QImage>().isNull())
        << "seen at a glance";
    EXPECT_FALSE(model->indexOf(node).data(HistoryModel::TimeRole).toString().isEmpty());
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    ASSERT_TRUE(open(sample("pillow")));
    ASSERT_TRUE(open(path));
    EXPECT_TRUE(toolTip().contains("<img"));
}

TEST_F(ProjectFilesTest, PicturesOfVersionsSuitAnyTheme)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    auto* model = &window.findChild<HistoryView*>()->history();
    const auto picture = [&] { return model->index(0).data(HistoryModel::PictureRole).value<QImage>(); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return !picture().isNull(); }, 60000));
    const QImage seen = picture();
    EXPECT_EQ(seen.pixelColor(0, 0).alpha(), 0);
    EXPECT_LT(seen.pixelColor(seen.rect().bottomRight()).alpha(), 20) << "a shadow at most";
    EXPECT_EQ(seen.pixelColor(seen.rect().center()).alpha(), 255);
}

TEST_F(ProjectFilesTest, VersionsThatWereSeenForAMomentHavePictures)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    constexpr NodeId versions = 4;
    for (NodeId version = 0; version < versions; ++version) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.solver().atRest(); }, 60000));
        if (version + 1 < versions)
            change();
    }
    auto* model = &window.findChild<HistoryView*>()->history();
    const auto has = [&](NodeId node) {
        return !model->indexOf(node).data(HistoryModel::PictureRole).value<QImage>().isNull();
    };
    for (NodeId node = 0; node < versions; ++node)
        EXPECT_TRUE(QTest::qWaitFor([&] { return has(node); }, 60000)) << node;
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    ASSERT_TRUE(open(sample("pillow")));
    ASSERT_TRUE(open(path));
    for (NodeId node = 0; node < versions; ++node)
        EXPECT_TRUE(has(node)) << node;
}

TEST_F(ProjectFilesTest, WhatCannotBeStoredIsNotDone)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const Design before = window.document().design();
    std::vector<Message> reasons;
    QObject::connect(&window.document(), &Document::refused, [&](const Message& why) { reasons.push_back(why); });
    Settings settings = before.settings();
    settings.edgeLength = std::numeric_limits<double>::quiet_NaN();
    window.document().commit(edits::changeSettings(before, settings));
    EXPECT_EQ(reasons.size(), 1U);
    EXPECT_TRUE(window.document().design() == before);
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(ProjectFilesTest, SavesThatFollowEachOtherTakeTurns)
{
    ASSERT_TRUE(open(sample("armchair")));
    const QString path = folder.filePath("chair.bolster");
    int ended = 0;
    for (int i = 0; i < 4; ++i) {
        change();
        window.session().save(path, [&](const Message& why) {
            EXPECT_EQ(why.english(), "");
            ++ended;
        });
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return ended == 4; }, 60000));
    const OpenedProject saved = openProject(path, ProjectCheck::Everything);
    EXPECT_EQ(saved.problem.english(), "");
    EXPECT_TRUE(saved.design == window.document().design());
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(ProjectFilesTest, WhatCanBeReadOfADamagedOneIsRecovered)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString path = folder.filePath("box.bolster");
    change(40);
    const Design design = window.document().design();
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();
    QFile file(path);
    ASSERT_TRUE(file.open(QFile::ReadWrite));
    const QByteArray whole = file.readAll();
    const qsizetype place =
        whole.lastIndexOf("edgeLength") > 0 ? whole.lastIndexOf("edgeLength") : whole.size() / 2;
    file.seek(place);
    file.write(QByteArray(1, static_cast<char>(whole[place] ^ 4)));
    file.close();
    const QByteArray damaged = [&] {
        QFile now(path);
        return now.open(QFile::ReadOnly) ? now.readAll() : QByteArray();
    }();
    ASSERT_NE(openProject(path, ProjectCheck::ToWork).problem.english(), "");

    bool opened = false;
    const auto connection =
        QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
    pressInBox("Recover");
    window.open(path);
    answer(QMessageBox::Ok);
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened && answered == 2; }, 30000));
    QObject::disconnect(connection);
    EXPECT_EQ(window.session().path(), folder.filePath("box (recovered).bolster"));
    EXPECT_GT(window.document().history().count(), 1);
    EXPECT_EQ(openProject(window.session().path(), ProjectCheck::Everything).problem.english(), "");
    QFile after(path);
    ASSERT_TRUE(after.open(QFile::ReadOnly));
    EXPECT_EQ(after.readAll(), damaged) << "the damaged file stays as it is";
}

TEST_F(ProjectFilesTest, OfAnEmptyFileNothingIsOffered)
{
    const QString path = folder.filePath("empty.bolster");
    ASSERT_TRUE(QFile(path).open(QFile::WriteOnly));
    QString said;
    int buttons = 0;
    whenABoxHas([&](QMessageBox& box) {
        said = box.informativeText();
        buttons = static_cast<int>(box.buttons().size());
        return box.button(QMessageBox::Ok);
    });
    window.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
    EXPECT_TRUE(said.contains(QStringLiteral("the file is empty"), Qt::CaseInsensitive)) << said.toStdString();
    EXPECT_EQ(buttons, 1);
}

TEST_F(ProjectFilesTest, RevertingIsAStepInTheHistory)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_EQ(save(folder.filePath("box.bolster")).english(), "");
    const Design saved = window.document().design();
    change(3);
    window.command("file.revert")->trigger();
    EXPECT_TRUE(window.document().design() == saved);
    EXPECT_EQ(window.document().history().count(), 4);
}

TEST_F(ProjectFilesTest, ACopyWithoutHistoryHasTheDesignAlone)
{
    ASSERT_TRUE(open(sample("armchair")));
    change(3);
    const QString path = folder.filePath("copy.bolster");
    bool done = false;
    window.session().saveCopy(path, {.withHistory = false}, [&](const Message& why) {
        EXPECT_EQ(why.english(), "");
        done = true;
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, 30000));
    EXPECT_TRUE(window.document().dirty()) << "a copy is not what was to be saved";
    const OpenedProject copy = openProject(path, ProjectCheck::Everything);
    EXPECT_EQ(copy.problem.english(), "");
    EXPECT_TRUE(copy.design == window.document().design());
    EXPECT_EQ(copy.history.count(), 1);
    EXPECT_EQ(copy.assets.size(), 1U);
}

TEST_F(ProjectFilesTest, ACopyDoesNotTakeThePlaceOfItsOriginal)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    change(3);
    ASSERT_EQ(save(path).english(), "");
    const int held = openProject(path, ProjectCheck::Everything).history.count();
    ASSERT_EQ(held, 4);
    const QString link = folder.filePath("link.bolster");
    ASSERT_TRUE(QFile::link(path, link));
    for (const QString& target : {path, link}) {
        std::string why;
        window.session().saveCopy(target, {.withHistory = false},
                                  [&](const Message& problem) { why = problem.english(); });
        EXPECT_TRUE(QTest::qWaitFor([&] { return !why.empty(); }, 30000)) << target.toStdString();
        EXPECT_NE(why.find("choose another name"), why.npos) << why;
    }
    EXPECT_EQ(openProject(path, ProjectCheck::Everything).history.count(), held);
}

TEST_F(ProjectFilesTest, ADamagedProjectChangesNothing)
{
    const QString path = savedBox();
    ASSERT_FALSE(path.isEmpty());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    file.seek(file.size() / 2);
    file.write(QByteArray(4000, 'x'));
    file.close();
    const Design before = window.document().design();
    answer(QMessageBox::Close);
    window.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
    EXPECT_TRUE(window.document().design() == before);
}

TEST_F(ProjectFilesTest, WhatIsWrongIsSaidInASentenceThatNamesTheFile)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    change(40);
    const QString path = folder.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    window.command("file.new")->trigger();
    QFile file(path);
    ASSERT_TRUE(file.open(QFile::ReadWrite));
    file.seek(file.readAll().lastIndexOf("Change the settings"));
    file.write("X");
    file.close();
    QString said;
    const auto opening = [&](const QString& what) {
        const int before = answered;
        whenABoxHas([&](QMessageBox& box) {
            said = box.informativeText();
            return box.button(QMessageBox::Close) ? box.button(QMessageBox::Close) : box.button(QMessageBox::Ok);
        });
        window.open(what);
        return QTest::qWaitFor([&] { return answered > before; }, 30000);
    };
    ASSERT_TRUE(opening(path));
    EXPECT_TRUE(said.startsWith('"' + path + '"')) << qPrintable(said);
    ASSERT_TRUE(opening(folder.filePath("nothing.bolster")));
    EXPECT_TRUE(said.startsWith("There is no file")) << qPrintable(said);
}

/// What only older versions mean is not laid out when a project is opened.
class OlderFilesTest : public ProjectFilesTest {
protected:
    QString write(const QString& name, const QByteArray& bytes)
    {
        const QString path = folder.filePath(name);
        QDir().mkpath(QFileInfo(path).absolutePath());
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return path;
    }
    /// A scan "room.xyz" of so many points.
    void importScan(int points, std::optional<ElementId> replaced = {})
    {
        QByteArray text;
        for (int i = 0; i < points; ++i)
            text += QByteArray::number(i) + " 0 0\n";
        const QString path = write(QString::number(points) + "/room.xyz", text);
        EXPECT_EQ(window.session()
                      .addWithFile(path, importFile(FileKind::Cloud, path).content, Scan(), replaced)
                      .english(),
                  "");
    }
    void setPicture(ElementId fabric, QColor color)
    {
        QImage image(20, 20, QImage::Format_RGB32);
        image.fill(color);
        const QString path = write(color.name().mid(1) + "/cloth.png", {});
        EXPECT_TRUE(image.save(path));
        Fabric changed = *window.document().design().find<Fabric>(fabric);
        changed.look = usualLook(FabricLook::Kind::Image);
        EXPECT_EQ(window.session().addWithFile(path, {}, changed, fabric).english(), "");
    }
    bool hasPoints(ElementId scan, std::size_t count)
    {
        return QTest::qWaitFor(
            [&] {
                const auto& clouds = window.session().files().clouds;
                return clouds.contains(scan) && clouds.at(scan)->points.size() == count;
            },
            120000);
    }
    QColor picture(ElementId fabric)
    {
        const QString file = QString::fromStdString(window.document().design().find<Fabric>(fabric)->look.file);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !window.session().findFile(file).isEmpty(); }, 30000));
        return QImage(window.session().findFile(file)).pixelColor(5, 5);
    }
    void reopen()
    {
        const QString path = folder.filePath("room.bolster");
        ASSERT_EQ(save(path).english(), "");
        ASSERT_TRUE(open(sample("box-cushion")));
        ASSERT_TRUE(open(path));
    }
};

TEST_F(OlderFilesTest, ComeFromTheProject)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const ElementId scan = window.document().design().nextId();
    importScan(4);
    const NodeId four = window.document().history().current();
    importScan(6, scan);
    const NodeId six = window.document().history().current();
    reopen();
    EXPECT_TRUE(hasPoints(scan, 6));
    window.document().jumpTo(four);
    ASSERT_EQ(window.document().history().current(), four);
    EXPECT_TRUE(hasPoints(scan, 4));
    EXPECT_TRUE(window.session().problems().empty());
    window.document().jumpTo(six);
    EXPECT_TRUE(hasPoints(scan, 6));
}

TEST_F(OlderFilesTest, AreNotMistakenForANewOneOfTheSameName)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const ElementId scan = window.document().design().nextId();
    importScan(4);
    const NodeId four = window.document().history().current();
    importScan(6, scan);
    reopen();
    importScan(8, scan);
    EXPECT_TRUE(hasPoints(scan, 8));
    const NodeId eight = window.document().history().current();
    window.document().jumpTo(four);
    EXPECT_TRUE(hasPoints(scan, 4));
    window.document().jumpTo(eight);
    reopen();
    EXPECT_TRUE(hasPoints(scan, 8));
    window.document().jumpTo(four);
    EXPECT_TRUE(hasPoints(scan, 4));
}

TEST_F(OlderFilesTest, PicturesOfFabricsAreInTheProjectToo)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ElementId fabric{};
    window.document().design().each<Fabric>([&](ElementId id, const Fabric&) { fabric = id; });
    setPicture(fabric, QColor(200, 0, 0));
    const NodeId red = window.document().history().current();
    setPicture(fabric, QColor(0, 0, 200));
    reopen();
    EXPECT_EQ(picture(fabric), QColor(0, 0, 200));
    window.document().jumpTo(red);
    EXPECT_EQ(picture(fabric), QColor(200, 0, 0));
}

TEST_F(OlderFilesTest, AreShownBesideThePresentOnes)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    const ElementId scan = window.document().design().nextId();
    importScan(4);
    const NodeId four = window.document().history().current();
    importScan(6, scan);
    reopen();
    Design older = *window.document().history().designAt(four, window.document().committed());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            const DesignFiles files = window.session().filesOf(older);
            return files.clouds.contains(scan) && files.clouds.at(scan)->points.size() == 4;
        },
        30000));
    EXPECT_TRUE(hasPoints(scan, 6));
}

} // namespace
} // namespace bolster
