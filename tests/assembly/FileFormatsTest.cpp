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

/// The rows of the tables at its beginning: each name with its endings, in the order of the uses.
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
    for (const FileFormat& format : fileFormats()) {
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

/// The desktop opens with Bolster what the list says, and knows it by its ending.
TEST(FileFormats, TheDesktopKnowsThem)
{
    const auto resource = [](const char* name) {
        QFile file(QString::fromStdString(test::sourceFolder() + "/resources/" + name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return QString::fromUtf8(file.readAll());
    };
    QString types;
    const QString mime = resource("bolster-mime.xml");
    for (const FileFormat& format : fileFormats()) {
        if (!format.mime)
            continue;
        types += QLatin1String(format.mime) + QLatin1Char(';');
        const QString type = mime.section(QStringLiteral("<mime-type type=\"%1\">").arg(format.mime), 1)
                                 .section(QStringLiteral("</mime-type>"), 0, 0);
        EXPECT_TRUE(type.contains(QStringLiteral(".%1\"").arg(format.ending))) << format.mime;
    }
    EXPECT_TRUE(resource("bolster.desktop").contains("\nMimeType=" + types + "\n")) << types.toStdString();
}

TEST(FileFormats, EndingsAreFoundWhateverTheirCase)
{
    EXPECT_TRUE(isFileOf(FileUse::Frame, "Chair.STEP"));
    EXPECT_TRUE(isFileOf(FileUse::Frame, "a/b.chair.glb"));
    EXPECT_FALSE(isFileOf(FileUse::Frame, "glb"));
    EXPECT_FALSE(isFileOf(FileUse::Scan, "chair.step"));
    EXPECT_TRUE(isFileOf(FileUse::Scan, "room.ply") && isFileOf(FileUse::Frame, "room.ply"));
    EXPECT_EQ(namesOf(FileUse::Pattern), "DXF, SVG");
    EXPECT_TRUE(isFileOf(FileUse::Scan, "room.laz")) << "so that somebody hears what helps";
    EXPECT_EQ(namesOf(FileUse::Scan), "E57, LAS, PTX, PTS, PLY, XYZ, PCD, OBJ, STL, OFF");
    EXPECT_EQ(filtersOf(FileUse::FoamOut), "STL (*.stl);;3MF (*.3mf);;STEP, of flat faces (*.step)");
    EXPECT_TRUE(patternsOf(FileUse::Pattern).startsWith("*.dxf *.DXF "));
}

} // namespace
} // namespace bolster
