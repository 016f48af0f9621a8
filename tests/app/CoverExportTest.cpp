// The cover is exported for others from the window, in the format that the file's ending says.
#include "WindowTest.h"

#include "ElidedLabel.h"
#include "StatusLine.h"

#include <QFile>
#include <QFileDialog>
#include <QLineEdit>

namespace bolster {
namespace {

class CoverExportTest : public WindowTest {
protected:
    /// Gives the file dialog of a command this path, and what was written there.
    QByteArray exported(const char* command, const QString& path)
    {
        window.command(command)->trigger();
        QFileDialog* files = nullptr;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                files = window.findChild<QFileDialog*>();
                return files && files->isVisible();
            },
            60000));
        if (!files)
            return {};
        files->findChild<QLineEdit*>()->setText(path);
        QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
        EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, 60000)) << path.toStdString();
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir folder;
};

TEST_F(CoverExportTest, CustomersGetAPageOthersAModel)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.command("file.export-cover")->isEnabled(); }, 60000));
    const QByteArray page = exported("file.export-cover", folder.filePath("cushion.html"));
    EXPECT_TRUE(page.startsWith("<!DOCTYPE html>"));
    EXPECT_TRUE(page.contains("three.js")) << "the viewer comes along, with its licence";
    EXPECT_GT(page.size(), 1'000'000) << "and so does the model";
    EXPECT_TRUE(exported("file.export-cover", folder.filePath("cushion.glb")).startsWith("glTF"));
    EXPECT_TRUE(exported("file.export-cover", folder.filePath("cushion.step")).startsWith("ISO-10303-21"));
}

TEST_F(CoverExportTest, FoamIsExportedWithItsWeight)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.command("file.export-foam")->isEnabled(); }, 60000));
    EXPECT_GT(exported("file.export-foam", folder.filePath("foam.3mf")).size(), 1000);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return window.statusLine().findChild<ElidedLabel*>()->fullText().contains(QStringLiteral(" kg")); }));
}

} // namespace
} // namespace bolster
