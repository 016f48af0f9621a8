// One list of formats: what people read about them is what the program takes.
#include "FileFormats.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>

#include <set>

namespace bolster {
namespace {

std::string document()
{
    QFile file(QString::fromStdString(test::sourceFolder() + "/docs/formats.md"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll().toStdString();
}

/// The rows of its first table: each name with its endings, in the order of the uses.
std::vector<std::pair<std::string, std::set<std::string>>> documented()
{
    std::vector<std::pair<std::string, std::set<std::string>>> rows;
    const QString text = QString::fromStdString(document());
    for (const QString& line : text.left(text.indexOf("\n## ")).split('\n')) {
        const QStringList cells = line.split('|');
        if (cells.size() != 5 || !cells[3].contains('`'))
            continue;
        std::set<std::string> endings;
        for (auto at = QRegularExpression("`\\.(\\w+)`").globalMatch(cells[3]); at.hasNext();)
            endings.insert(at.next().captured(1).toStdString());
        rows.emplace_back(cells[2].trimmed().toStdString(), endings);
    }
    return rows;
}

TEST(FileFormats, TheDocumentListsThemAll)
{
    std::vector<std::pair<std::string, std::set<std::string>>> listed;
    const FileFormat* before = nullptr;
    for (const FileFormat& format : readFormats()) {
        if (!before || before->use != format.use || std::string_view(before->name) != format.name)
            listed.push_back({format.name, {}});
        listed.back().second.insert(format.ending);
        before = &format;
    }
    const auto rows = documented();
    std::multiset<std::set<std::string>> inTable, inDocument;
    for (const auto& [name, endings] : listed)
        if (name.find("Bolster") == std::string::npos)
            inTable.insert(endings);
    for (const auto& [name, endings] : rows)
        if (name.find("Bolster") == std::string::npos)
            inDocument.insert(endings);
    EXPECT_EQ(inTable, inDocument);
}

TEST(FileFormats, EndingsAreFoundWhateverTheirCase)
{
    EXPECT_TRUE(isFileOf(FileUse::Frame, "Chair.STEP"));
    EXPECT_TRUE(isFileOf(FileUse::Frame, "a/b.chair.glb"));
    EXPECT_FALSE(isFileOf(FileUse::Frame, "glb"));
    EXPECT_FALSE(isFileOf(FileUse::Scan, "chair.step"));
    EXPECT_TRUE(isFileOf(FileUse::Scan, "room.ply") && isFileOf(FileUse::Frame, "room.ply"));
    EXPECT_EQ(namesOf(FileUse::Pattern), "DXF, SVG");
    EXPECT_TRUE(patternsOf(FileUse::Pattern).startsWith("*.dxf *.DXF "));
}

} // namespace
} // namespace bolster
