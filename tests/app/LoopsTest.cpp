// No window waits for another one in a loop of its own.
#include "TestPaths.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include <gtest/gtest.h>

namespace bolster {
namespace {

TEST(SourceTest, NothingInTheProgramWaitsInALoopOfItsOwn)
{
    const QRegularExpression waiting(QStringLiteral(
        R"(\bexec\s*\(|\bQEventLoop\b|\bprocessEvents\s*\(|QMessageBox::(question|warning|information|critical|about)\s*\(|)"
        R"(QFileDialog::get\w+\s*\(|QInputDialog::get\w+\s*\(|QColorDialog::getColor|QFontDialog::getFont)"));
    int files = 0;
    for (const char* const folder : {"app", "widgets", "model", "solver"}) {
        QDirIterator all(QString::fromStdString(test::sourceFolder() + "/" + folder), {"*.cpp", "*.h"}, QDir::Files,
                         QDirIterator::Subdirectories);
        while (all.hasNext()) {
            const QString path = all.next();
            QFile file(path);
            ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
            ++files;
            const QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
            for (qsizetype i = 0; i < lines.size(); ++i) {
                const QString code = lines[i].section(QStringLiteral("//"), 0, 0);
                const bool application = path.endsWith(QLatin1String("app/main.cpp")) &&
                                         code.contains(QLatin1String("QApplication::exec()"));
                EXPECT_TRUE(application || !code.contains(waiting))
                    << path.toStdString() << ':' << i + 1 << ": " << code.toStdString()
                    << "\nDialogs and menus are opened and answer later: see Ask.h.";
            }
        }
    }
    EXPECT_GT(files, 200);
}

} // namespace
} // namespace bolster
