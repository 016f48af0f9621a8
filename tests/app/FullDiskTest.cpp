// A disk that fills up while a project is saved to it.
#include "WindowTest.h"

#include "ElementEdits.h"
#include "FabricLink.h"
#include "Project.h"
#include "RenderDialog.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSignalSpy>
#include <QStorageInfo>
#include <QTemporaryDir>

namespace bolster {
namespace {

/// A file system of its own; only the system's administrator may make one.
class SmallDisk {
public:
    explicit SmallDisk(int kilobytes)
        : m_mounted(run("mount",
                        {"-t", "tmpfs", "-o", QStringLiteral("size=%1k").arg(kilobytes), "tmpfs", m_folder.path()}))
    {}
    ~SmallDisk()
    {
        if (m_mounted)
            run("umount", {"-l", m_folder.path()});
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool mounted() const { return m_mounted; }
    QString filePath(const QString& name) const { return m_folder.filePath(name); }

    /// Leaves so much room.
    void fill(qint64 left)
    {
        QFile filler(filePath("filler"));
        ASSERT_TRUE(filler.open(QFile::WriteOnly));
        filler.write(QByteArray(QStorageInfo(m_folder.path()).bytesAvailable() - left, 'x'));
    }
    void makeRoom() { QFile::remove(filePath("filler")); }

private:
    static bool run(const QString& program, const QStringList& arguments)
    {
        return QProcess::execute(program, arguments) == 0;
    }

    QTemporaryDir m_folder;
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
    window.actions().save->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.isWindowModified(); }, 30000));
    EXPECT_EQ(failures, 1);
    EXPECT_TRUE(openProject(path).design == window.document().design());
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
                         window.surfaceView().camera()});
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
