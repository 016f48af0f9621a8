// Reports of problems, the log of a run, and the view on paper.
#include "PackedFile.h"
#include "ReportDialog.h"
#include "RunLog.h"
#include "ViewPrint.h"

#include "WindowTest.h"

#include <QCheckBox>
#include <QPainter>
#include <QPdfWriter>
#include <QPlainTextEdit>
#include <QProcess>

#include <csignal>

namespace bolster {
namespace {

class ReportTest : public WindowTest {
protected:
    QByteArray read(const QString& name)
    {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir folder;
};

TEST_F(ReportTest, TheReportHasWhatIsSaidAndTheDesignOnlyWhenWanted)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    window.command("help.report")->trigger();
    auto* dialog = window.findChild<ReportDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_FALSE(dialog->findChild<QCheckBox*>("with-design")->isChecked());
    dialog->findChild<QPlainTextEdit*>("happened")->setPlainText("The seam went away");
    for (const bool with : {false, true}) {
        dialog->findChild<QCheckBox*>("with-design")->setChecked(with);
        QString problem = "not yet";
        QObject::connect(dialog, &ReportDialog::written, &window,
                         [&](const QString&, const QString& why) { problem = why; });
        dialog->writeTo(folder.filePath("report.zip"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return problem != "not yet"; }, 20000));
        QObject::disconnect(dialog, &ReportDialog::written, &window, nullptr);
        EXPECT_EQ(problem, "");
        const QByteArray bytes = read("report.zip");
        EXPECT_TRUE(bytes.startsWith("PK"));
        EXPECT_TRUE(bytes.contains("versions.txt"));
        EXPECT_TRUE(bytes.contains("what-happened.txt"));
        EXPECT_EQ(bytes.contains("design.json"), with);
    }
    QString problem;
    QObject::connect(dialog, &ReportDialog::written, &window,
                     [&](const QString&, const QString& why) { problem = why; });
    dialog->writeTo(folder.filePath("nowhere/report.zip"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !problem.isEmpty(); }, 20000));
    waitForBackground();
    dialog->reject();
}

TEST(ReportVersions, NobodyIsNamed)
{
    const QString versions = versionsText("none");
    EXPECT_TRUE(versions.contains(qVersion()));
    EXPECT_EQ(withoutHome(QDir::homePath() + "/seat.json"), "~/seat.json");
}

TEST(RunLogDeathTest, ACrashLeavesItsStackAndTheLastMessages)
{
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const QString folder = QDir::temp().filePath("bolster-crash-test");
    QDir(folder).removeRecursively();
    const auto crash = [&] {
        beginRunLog(folder);
        qWarning("the thread is torn");
        std::raise(SIGSEGV);
    };
    EXPECT_EXIT(crash(), testing::KilledBySignal(SIGSEGV), "");
    const QString left = lastCrashText(folder);
    EXPECT_TRUE(left.contains("the thread is torn")) << qPrintable(left);
    EXPECT_TRUE(left.contains("signal 11"));
    EXPECT_GT(left.mid(left.indexOf("Stack:")).count('\n'), 3);
    const QStringList runs = QDir(folder).entryList({"run-*.log"});
    EXPECT_EQ(runs.size(), 1);
    QDir(folder).removeRecursively();
}

TEST_F(ReportTest, TheViewIsPrintedWithTitleAndLegend)
{
    QImage picture(400, 300, QImage::Format_RGB32);
    picture.fill(Qt::darkGreen);
    const auto printed = [&](const ShownMapPtr& map) {
        const QString path = folder.filePath("view.pdf");
        {
            QPdfWriter paper(path);
            paper.setPageSize(QPageSize(QPageSize::A4));
            EXPECT_TRUE(paintSheet(paper, {picture, "Seat in green", QDateTime::currentDateTime(), map}));
        }
        QProcess text;
        text.start("pdftotext", {path, "-"});
        EXPECT_TRUE(text.waitForFinished(20000));
        return QString::fromUtf8(text.readAllStandardOutput());
    };
    EXPECT_TRUE(printed(nullptr).contains("Seat in green"));
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    map(CoverMap::Kind::Strain)->setChecked(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.coverView().map() != nullptr; }, 20000));
    EXPECT_TRUE(printed(window.coverView().map()).contains(window.coverView().map()->title));
}

} // namespace
} // namespace bolster
