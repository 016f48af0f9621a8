// A disk that fills up while a project is saved to it.
#include "WindowTest.h"

#include "ElementEdits.h"
#include "FabricCommands.h"
#include "FabricLink.h"
#include "PreferenceStore.h"
#include "Project.h"
#include "RenderDialog.h"
#include "Units.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStorageInfo>
#include <QTemporaryDir>

namespace bolster {
namespace {

/// A file system of its own; only the system's administrator may make one.
class SmallDisk {
public:
    /// In a folder of its own, or over one that is there.
    explicit SmallDisk(int kilobytes, const QString& over = {})
        : m_path(over.isEmpty() ? m_folder.path() : over)
        , m_mounted(run("mount", {"-t", "tmpfs", "-o", QStringLiteral("size=%1k").arg(kilobytes), "tmpfs", m_path}))
    {}
    ~SmallDisk()
    {
        if (m_mounted)
            run("umount", {"-l", m_path});
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool mounted() const { return m_mounted; }
    QString filePath(const QString& name) const { return QDir(m_path).filePath(name); }

    /// Leaves so much room.
    void fill(qint64 left)
    {
        QFile filler(filePath("filler"));
        ASSERT_TRUE(filler.open(QFile::WriteOnly));
        filler.write(QByteArray(QStorageInfo(m_path).bytesAvailable() - left, 'x'));
    }
    void makeRoom() { QFile::remove(filePath("filler")); }

private:
    static bool run(const QString& program, const QStringList& arguments)
    {
        return QProcess::execute(program, arguments) == 0;
    }

    QTemporaryDir m_folder;
    QString m_path;
    bool m_mounted;
};

class FullDiskTest : public WindowTest {
protected:
    Message save(const QString& path)
    {
        std::optional<Message> problem;
        window.session().save(path, [&](const Message& why) { problem = why; });
        EXPECT_TRUE(QTest::qWaitFor([&] { return problem.has_value(); }, 30000));
        return problem.value_or(Message());
    }

    void change()
    {
        Settings settings = window.document().design().settings();
        settings.edgeLength += 1;
        window.document().commit(edits::changeSettings(window.document().design(), settings));
    }
};

TEST_F(FullDiskTest, PreferencesThatCannotBeKeptAreSaidOnceAndKeptWhenThereIsRoom)
{
    QSettings().setValue("test/there", 1);
    QSettings().sync();
    const QString folder = QFileInfo(QSettings().fileName()).absolutePath();
    SmallDisk disk(64, folder);
    if (!disk.mounted())
        GTEST_SKIP() << "only the administrator may mount";
    disk.fill(0);
    Preferences wanted = window.preferences().now();
    wanted.length = "cm";
    window.preferences().set(wanted);
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_TRUE(box);
    EXPECT_TRUE(box->text().contains("could not be stored"));
    EXPECT_TRUE(box->informativeText().contains(folder)) << qPrintable(box->informativeText());
    EXPECT_TRUE(box->informativeText().contains("full")) << qPrintable(box->informativeText());
    box->close();
    QCoreApplication::processEvents();
    EXPECT_EQ(lengthSuffix(), " cm") << "it holds all the same";
    wanted.reducedMotion = true;
    window.preferences().set(wanted);
    EXPECT_FALSE(QApplication::activeModalWidget()) << "said already";
    disk.makeRoom();
    wanted.reducedMotion = false;
    window.preferences().set(wanted);
    EXPECT_FALSE(QApplication::activeModalWidget());
    QFile kept(QSettings().fileName());
    ASSERT_TRUE(kept.open(QFile::ReadOnly));
    EXPECT_TRUE(kept.readAll().contains("length=cm")) << "with what could not be kept before";
    window.preferences().set({});
}

TEST_F(FullDiskTest, SavingSaysSoAndNothingIsLost)
{
    SmallDisk disk(4096);
    if (!disk.mounted())
        GTEST_SKIP() << "making a file system is not allowed here";
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString path = disk.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    const Design saved = window.document().design();

    for (const qint64 left : {0, 4096, 20000}) {
        disk.fill(left);
        change();
        const Design now = window.document().design();
        const std::string problem = save(path).english();
        EXPECT_NE(problem.find("full"), std::string::npos) << left << ": " << problem;
        EXPECT_NE(problem.find(path.toStdString()), std::string::npos) << left << ": " << problem;
        EXPECT_TRUE(window.isWindowModified());
        EXPECT_TRUE(window.document().design() == now);
        const OpenedProject there = openProject(path, ProjectCheck::Everything);
        EXPECT_EQ(there.problem.english(), "");
        EXPECT_TRUE(there.design == saved) << "what was saved before is whole";
        disk.makeRoom();
        EXPECT_EQ(QDir(QFileInfo(path).path()).entryList(QDir::Files | QDir::Hidden), QStringList("box.bolster"))
            << "half a file must not stay";
    }

    EXPECT_EQ(save(path).english(), "");
    EXPECT_FALSE(window.isWindowModified());
    const OpenedProject there = openProject(path, ProjectCheck::Everything);
    EXPECT_TRUE(there.design == window.document().design());
    EXPECT_EQ(there.history.count(), 4);
}

TEST_F(FullDiskTest, AFabricThatDoesNotFitLeavesTheOlderPicture)
{
    SmallDisk disk(1024);
    if (!disk.mounted())
        GTEST_SKIP() << "making a file system is not allowed here";
    QTemporaryDir folder;
    QImage picture(100, 100, QImage::Format_RGB32);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            picture.setPixel(x, y, static_cast<QRgb>(2654435761U * static_cast<unsigned>(100 * y + x)));
    ASSERT_TRUE(picture.save(folder.filePath("noise.png")));
    const ElementId id = window.document().design().nextId();
    window.fabricCommands().choosePicture(noElement, folder.filePath("noise.png"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().design().find<Fabric>(id) != nullptr; }, 60000));
    window.selection().set({id});
    const auto older = [&] {
        QFile file(disk.filePath("noise.png"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray bytes("the older picture");
    QFile file(disk.filePath("noise.png"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    file.close();
    disk.fill(4096);
    answer(QMessageBox::Ok);
    window.fabricCommands().exportFabric(disk.filePath("noise.json"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
    EXPECT_EQ(older(), bytes);
}

TEST_F(FullDiskTest, OneTriesAgainOrSavesElsewhereWithoutBeginningAnew)
{
    SmallDisk disk(4096);
    if (!disk.mounted())
        GTEST_SKIP() << "making a file system is not allowed here";
    ASSERT_TRUE(open(sample("box-cushion")));
    const QString path = disk.filePath("box.bolster");
    ASSERT_EQ(save(path).english(), "");
    change();
    disk.fill(4096);
    int failures = 0;
    whenABoxHas([&](QMessageBox& box) -> QAbstractButton* {
        EXPECT_TRUE(box.informativeText().contains(path)) << qPrintable(box.informativeText());
        QAbstractButton* again = nullptr;
        int elsewhere = 0;
        for (QAbstractButton* button : box.buttons()) {
            const QString text = button->text().remove('&');
            again = text == "Try again" ? button : again;
            elsewhere += text.startsWith("Save as");
        }
        EXPECT_EQ(elsewhere, 1);
        ++failures;
        disk.makeRoom();
        return again;
    });
    window.command("file.save")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isWindowModified(); }, 30000));
    EXPECT_EQ(failures, 1);
    EXPECT_TRUE(openProject(path).design == window.document().design());
}

/// The disk of the journals is full, that of the projects is not.
class FullStateTest : public FullDiskTest {
protected:
    FullStateTest()
        : m_disk(8192, stateFolder())
    {}

    void SetUp() override
    {
        if (!m_disk.mounted())
            GTEST_SKIP() << "making a file system is not allowed here";
        FullDiskTest::SetUp();
    }
    void TearDown() override
    {
        if (!m_disk.mounted())
            return;
        m_disk.makeRoom();
        FullDiskTest::TearDown();
        window.session().end(); // before the disk goes
    }

    static QString stateFolder()
    {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
        QDir().mkpath(folder);
        return folder;
    }
    QString path(const QString& name) { return m_projects.filePath(name); }
    bool warned() { return window.banner().shown() && window.banner().text().contains(stateFolder()); }
    bool isProtectedAgain()
    {
        return QTest::qWaitFor([&] { return !window.banner().shown(); }, 30000);
    }
    /// What a crash would leave now.
    void keepJournals(const QString& to)
    {
        QDir().mkpath(to);
        for (const QFileInfo& file : QDir(WorkJournal::folder()).entryInfoList({"*.bolster*", "*.about"}))
            EXPECT_TRUE(QFile::copy(file.filePath(), to + '/' + file.fileName()));
    }
    QList<WorkJournal::Left> leftByACrash()
    {
        keepJournals(path("journals"));
        window.document().markSaved();
        window.session().startNew();
        m_disk.makeRoom();
        QDir().mkpath(WorkJournal::folder());
        for (const QFileInfo& file : QDir(path("journals")).entryInfoList(QDir::Files))
            EXPECT_TRUE(QFile::copy(file.filePath(), WorkJournal::folder() + '/' + file.fileName()));
        return WorkJournal::left();
    }

    SmallDisk m_disk;
    QTemporaryDir m_projects;
};

TEST_F(FullStateTest, WarnsAsLongAsEditsAreNotProtected)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_EQ(save(path("box.bolster")).english(), "");
    m_disk.fill(0);
    change();
    ASSERT_TRUE(warned()) << qPrintable(window.banner().text());
    window.banner().announce(Banner::Kind::Information, "something else", {});
    window.banner().dismiss();
    change();
    EXPECT_TRUE(warned()) << "nothing else takes its place, and nobody closes it";
    m_disk.makeRoom();
    ASSERT_TRUE(isProtectedAgain()) << "without another edit";
    const auto left = leftByACrash();
    ASSERT_EQ(left.size(), 1);
    EXPECT_EQ(WorkJournal::takeLeft(left[0]).project.history.count(), 3);
}

TEST_F(FullStateTest, SavingToAnotherDiskWorks)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_EQ(save(path("box.bolster")).english(), "");
    m_disk.fill(0);
    for (int saves = 1; saves <= 2; ++saves) {
        change();
        window.document().nameVersion(saves, "Name " + std::to_string(saves));
        EXPECT_EQ(save(path("box.bolster")).english(), "");
        EXPECT_FALSE(window.document().hasUnsavedWork());
        const OpenedProject there = openProject(path("box.bolster"), ProjectCheck::Everything);
        EXPECT_EQ(there.problem.english(), "");
        EXPECT_TRUE(there.design == window.document().design());
        EXPECT_EQ(there.history.count(), 1 + saves);
        EXPECT_EQ(there.history.node(saves).name, "Name " + std::to_string(saves));
    }
    EXPECT_EQ(QDir(m_projects.path()).entryList(QDir::Files | QDir::Hidden), QStringList("box.bolster"));
    EXPECT_TRUE(warned()) << "for what comes";
    change();
    EXPECT_EQ(save(path("other.bolster")).english(), "") << "under another name";
    m_disk.makeRoom();
    ASSERT_TRUE(isProtectedAgain());
    change();
    EXPECT_EQ(save(path("other.bolster")).english(), "") << "nobody else has changed it";
    EXPECT_EQ(openProject(path("other.bolster")).history.count(), 5);
}

TEST_F(FullStateTest, ADesignThatHasNoJournalYetIsSavedToo)
{
    ASSERT_TRUE(open(sample("armchair"))); // with a file
    m_disk.fill(0);
    change();
    ASSERT_TRUE(warned());
    EXPECT_EQ(QDir(WorkJournal::folder()).entryList({"*.bolster"}), QStringList()) << "half a journal";
    EXPECT_EQ(save(path("chair.bolster")).english(), "");
    change();
    EXPECT_EQ(save(path("chair.bolster")).english(), "");
    EXPECT_EQ(openProject(path("chair.bolster")).assets.size(), 1U);
    m_disk.makeRoom();
    ASSERT_TRUE(isProtectedAgain());
    change();
    EXPECT_EQ(save(path("chair.bolster")).english(), "") << "it is the same project";
    EXPECT_EQ(openProject(path("chair.bolster"), ProjectCheck::Everything).history.count(), 4);
}

TEST_F(FullStateTest, ASoundProjectThatCannotBeOpenedIsNotCalledDamaged)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_EQ(save(path("box.bolster")).english(), "");
    window.session().startNew();
    m_disk.fill(0);
    whenABoxHas([&](QMessageBox& box) {
        EXPECT_TRUE(box.informativeText().contains(stateFolder())) << qPrintable(box.informativeText());
        EXPECT_EQ(box.buttons().size(), 1) << "nothing to recover";
        return box.button(QMessageBox::Ok);
    });
    window.open(path("box.bolster"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 30000));
}

TEST_F(FullStateTest, AnOlderJournalIsNoWorkWhenTheFileHoldsAllOfIt)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_EQ(save(path("box.bolster")).english(), "");
    change();
    m_disk.fill(0);
    change();
    EXPECT_EQ(save(path("box.bolster")).english(), "");
    EXPECT_TRUE(leftByACrash().isEmpty());
}

TEST_F(FullDiskTest, APictureThatDoesNotFitIsReportedAndTheOlderOneStays)
{
    SmallDisk disk(1024);
    if (!disk.mounted())
        GTEST_SKIP() << "making a file system is not allowed here";
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    window.show();
    RenderDialog dialog({window.solver().surface(), window.document().design(), window.session().files(),
                         window.fabricLink().baker(), window.fabricLink().bakedByNow(), window.session().title(),
                         window.coverView().navigation().camera()});
    QSignalSpy ends(&dialog, &RenderDialog::rendered);
    const QString path = disk.filePath("picture.png");
    dialog.renderTo(path);
    ASSERT_TRUE(ends.wait(60000));
    ASSERT_EQ(ends.takeFirst().front().toString(), QString());
    const QImage before(path);
    disk.fill(0);
    dialog.renderTo(path);
    ASSERT_TRUE(ends.wait(60000));
    const QString problem = ends.takeFirst().front().toString();
    EXPECT_TRUE(problem.contains("the disk is full") && problem.contains(path)) << problem.toStdString();
    EXPECT_EQ(QImage(path), before);
}

} // namespace
} // namespace bolster
