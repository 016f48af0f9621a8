// Patterns as files, read by programs of others: ezdxf, poppler, librsvg.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <sstream>

namespace bolster {
namespace {

using Json = nlohmann::json;

/// Two panels that are sewn, one of them a pair, with all that a cutter may be told.
Json panels()
{
    return Json::parse(R"({"format": "bolster-design", "version": 1, "unit": "mm",
        "settings": {"edge_length": 25, "cutting": {"style": "Stuhl", "version": "B", "notches": {"spacing_mm": 100}}},
        "elements": [
        {"id": 1, "kind": "fabric", "name": "Leather"},
        {"id": 2, "kind": "patch", "name": "Sitz links", "fabric": 1, "cutting": {"pair": true, "quantity": 2},
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[300,0],[300,400],[0,400]]}},
        {"id": 3, "kind": "patch", "name": "R\u00fccken", "fabric": 1, "position": [500, 0],
         "outline": {"degree": 3, "closed": true,
          "points": [[0,0],[150,-60],[300,0],[330,200],[300,400],[150,460],[0,400],[-30,200]]}},
        {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 6, "to": 0}},
        {"id": 5, "kind": "notch", "patch": 2, "at": 0.5, "shape": {"kind": "castle", "depth_mm": 5, "width_mm": 6}},
        {"id": 6, "kind": "drill_hole", "name": "Button", "patch": 2, "position": [100, 100], "diameter_mm": 4},
        {"id": 7, "kind": "internal_line", "name": "Strip", "patch": 2, "use": "cut",
         "curve": {"degree": 1, "closed": false, "points": [[40, 300], [260, 300]]}},
        {"id": 8, "kind": "edge_allowance", "patch": 2, "from": 0, "to": 1, "width_mm": 25}]})");
}

class Export : public TestFiles {
protected:
    void SetUp() override { m_design = write(QStringLiteral("panels.json"), panels().dump()); }

    ProgramRun run(const QStringList& more) const
    {
        return callCommandLine(QStringList{"export", m_design} + more);
    }

    Json dxf(const QStringList& more = {}) const
    {
        const ProgramRun exported = run(QStringList{"--dxf", path("p.dxf")} + more);
        EXPECT_EQ(exported.exitCode, 0) << exported.err;
        const QString tool = QString::fromStdString(test::sourceFolder()) + "/tests/cli/read_pattern.py";
        // Debian's own: only that has its packages.
        const std::string text = output("/usr/bin/python3", {tool, path("p.dxf")});
        return Json::parse(text.empty() ? "{}" : text);
    }

    static std::string output(const QString& program, const QStringList& arguments)
    {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(60000)) << program.toStdString();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        return process.readAllStandardOutput().toStdString();
    }

    QString m_design;
};

std::vector<Json> onLayer(const Json& entities, const std::string& layer, const std::string& kind)
{
    std::vector<Json> found;
    for (const Json& entity : entities)
        if (entity["layer"] == layer && entity["kind"] == kind)
            found.push_back(entity);
    return found;
}

double area(const Json& points)
{
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Json &a = points[i], &b = points[(i + 1) % points.size()];
        sum += a[0].get<double>() * b[1].get<double>() - a[1].get<double>() * b[0].get<double>();
    }
    return std::abs(sum) / 2;
}

bool hasText(const Json& entities, const std::string& text)
{
    return std::ranges::any_of(entities, [&](const Json& e) { return e["kind"] == "TEXT" && e["text"] == text; });
}

TEST_F(Export, WritesAamaThatOthersRead)
{
    for (const char* const standard : {"aama", "astm"}) {
        const Json read = dxf({"--standard", standard});
        EXPECT_EQ(read["errors"], Json::array()) << standard;
        EXPECT_EQ(read["version"], "AC1009");
        ASSERT_EQ(read["blocks"].size(), 2u);
        const Json& block = read["blocks"]["Sitz links_M"];
        const auto cut = onLayer(block, "1", "POLYLINE"), sew = onLayer(block, "14", "POLYLINE");
        ASSERT_EQ(cut.size(), 1u);
        ASSERT_EQ(sew.size(), 1u);
        EXPECT_TRUE(cut[0]["closed"]);
        EXPECT_NEAR(area(sew[0]["points"]), 300 * 400, 0.01);
        EXPECT_NEAR(area(cut[0]["points"]), 320 * 435, 0.05) << "25 mm below, 10 mm elsewhere";
        EXPECT_EQ(onLayer(block, "2", "POINT").size(), 8u) << "turn points of both lines";
        EXPECT_EQ(onLayer(block, "3", "POINT").size(), 0u) << "no curve";
        EXPECT_GT(onLayer(read["blocks"]["Rucken_M"], "3", "POINT").size(), 20u);
        EXPECT_EQ(onLayer(block, "7", "LINE").size(), 1u) << "grain";
        EXPECT_EQ(onLayer(block, "11", "POLYLINE").size(), 1u) << "a line that is cut";
        ASSERT_EQ(onLayer(block, "13", "POINT").size(), 1u);
        EXPECT_EQ(onLayer(block, "13", "POINT")[0]["at"], Json({100.0, 100.0, 4.0})) << "its diameter is in z";
        const auto castle = onLayer(block, "81", "POINT");
        ASSERT_EQ(castle.size(), 1u);
        EXPECT_EQ(castle[0]["at"], Json({150.0, -25.0, -5.0})) << "on the cut line, depth in z";
        EXPECT_EQ(castle[0]["thickness"], 6.0);
        EXPECT_EQ(castle[0]["angle"], 90.0);
        EXPECT_GE(onLayer(block, "4", "POINT").size(), 3u) << "along the seam";
        EXPECT_TRUE(hasText(block, "Piece Name: Sitz links"));
        EXPECT_TRUE(hasText(block, "Quantity: 2,2"));
        EXPECT_TRUE(hasText(block, "Fabric: Leather"));
        EXPECT_TRUE(hasText(read["space"], "Style Name: Stuhl"));
        EXPECT_TRUE(hasText(read["space"], "Units: METRIC"));
        EXPECT_EQ(hasText(read["space"], "ASTM/D13Proposal 1 Version: D 6673-04"), std::string(standard) == "astm");
    }
    const std::string bytes = read("p.dxf");
    EXPECT_NE(bytes.find("\r\n"), std::string::npos);
    EXPECT_TRUE(std::ranges::none_of(bytes, [](char c) { return static_cast<unsigned char>(c) > 0x7E; }))
        << "ASCII";
    EXPECT_EQ(bytes.find("LWPOLYLINE"), std::string::npos);
}

TEST_F(Export, WritesPlainDxfThatOthersRead)
{
    const Json read = dxf({"--standard", "plain", "--unfold"});
    EXPECT_EQ(read["errors"], Json::array());
    EXPECT_EQ(onLayer(read["space"], "cut", "POLYLINE").size(), 3u) << "a pair is two pieces";
    EXPECT_EQ(onLayer(read["space"], "holes", "CIRCLE").size(), 2u);
    EXPECT_FALSE(onLayer(read["space"], "notches", "POLYLINE").empty());
}

TEST_F(Export, WritesCurvesAsSplines)
{
    Json exact = panels();
    exact["elements"].push_back(
        {{"id", 9},
         {"kind", "internal_line"},
         {"name", "Arc"},
         {"patch", 3},
         {"curve", {{"degree", 2}, {"closed", false}, {"points", {{50, 50}, {150, 120}, {250, 50}}}}}});
    write(QStringLiteral("panels.json"), exact.dump());
    const Json read = dxf({"--splines", "--standard", "plain"});
    EXPECT_EQ(read["errors"], Json::array());
    EXPECT_EQ(read["fixes"], Json::array()) << "nothing that the reader had to put right";
    EXPECT_EQ(read["version"], "AC1015");
    const auto curves = onLayer(read["space"], "sew", "SPLINE");
    ASSERT_EQ(curves.size(), 1u) << "an outline without corners is one curve";
    EXPECT_EQ(curves[0]["degree"], 3);
    const Json &first = curves[0]["points"].front(), &last = curves[0]["points"].back();
    EXPECT_NEAR(first[0].get<double>(), last[0].get<double>(), 1e-6);
    EXPECT_NEAR(first[1].get<double>(), last[1].get<double>(), 1e-6);
    // The same outline as others draw it from the sewing line that is a polygon within 0.001 mm.
    const Json fine = dxf({"--standard", "plain", "--chord", "0.001"});
    double polygon = 0;
    for (const Json& line : onLayer(fine["space"], "sew", "POLYLINE"))
        if (line["points"].size() > 4)
            polygon = area(line["points"]);
    EXPECT_NEAR(area(curves[0]["points"]) / polygon, 1, 1e-5);
    EXPECT_EQ(onLayer(read["space"], "sew", "LWPOLYLINE").size(), 1u) << "a polygon stays one";
    EXPECT_EQ(onLayer(read["space"], "cut", "LWPOLYLINE").size(), 2u)
        << "beside an allowance there is no exact curve";
    EXPECT_EQ(onLayer(read["space"], "holes", "CIRCLE").size(), 1u);
    EXPECT_EQ(onLayer(read["space"], "internal", "SPLINE").size(), 1u);
    EXPECT_EQ(onLayer(read["space"], "internal", "SPLINE")[0]["degree"], 2);
    EXPECT_NE(run({"--dxf", path("x.dxf"), "--splines", "--standard", "aama"}).err.find("plain"),
              std::string::npos);
}

TEST_F(Export, WritesCutLinesWithoutAllowanceAsSplines)
{
    Json bare = panels();
    bare["settings"]["cutting"]["allowance"] = {{"width_mm", 0}};
    // With corners: a side from corner to corner is a curve of its own, straight ones are lines.
    bare["elements"][2]["outline"] = {{"degree", 3},
                                      {"closed", true},
                                      {"corners", {0, 3, 6, 9}},
                                      {"points",
                                       {{0, 0},
                                        {100, 0},
                                        {200, 0},
                                        {300, 0},
                                        {330, 130},
                                        {330, 260},
                                        {300, 400},
                                        {200, 400},
                                        {100, 400},
                                        {0, 400},
                                        {0, 260},
                                        {0, 130}}}};
    bare["elements"].erase(3); // the seam
    write(QStringLiteral("panels.json"), bare.dump());
    const Json read = dxf({"--splines", "--piece", "R\u00fccken"});
    EXPECT_EQ(read["errors"], Json::array());
    EXPECT_EQ(onLayer(read["space"], "cut", "SPLINE").size(), 1u);
    EXPECT_EQ(onLayer(read["space"], "cut", "LINE").size(), 3u);
}

TEST_F(Export, WritesOnlyTheLinesAndPiecesThatAreWanted)
{
    const Json read = dxf({"--lines", "sew,notches", "--piece", "Sitz links"});
    ASSERT_EQ(read["blocks"].size(), 1u);
    const Json& block = read["blocks"]["Sitz links_M"];
    ASSERT_EQ(onLayer(block, "1", "POLYLINE").size(), 1u);
    EXPECT_NEAR(area(onLayer(block, "1", "POLYLINE")[0]["points"]), 300 * 400, 0.01)
        << "the sewing line is all there is";
    EXPECT_TRUE(onLayer(block, "13", "POINT").empty());
    EXPECT_NE(run({"--svg", path("x.svg"), "--lines", "cut,frills"}).err.find("frills"), std::string::npos);
    EXPECT_EQ(run({"--svg", path("x.svg"), "--piece", "Nobody"}).exitCode, 2);
    EXPECT_EQ(run({}).exitCode, 2) << "nothing to write";
    EXPECT_EQ(run({"--pdf", path("x.pdf"), "--paper", "A9"}).exitCode, 2);
    EXPECT_EQ(run({"--svg", m_design}).exitCode, 2) << "would overwrite the design";
}

TEST_F(Export, TakesTheAllowanceWhereTheDesignSaysNone)
{
    const Json read = dxf({"--allowance", "20"});
    EXPECT_NEAR(area(onLayer(read["blocks"]["Sitz links_M"], "1", "POLYLINE")[0]["points"]), 340 * 445, 0.05);
}

TEST_F(Export, WritesSvgThatAnotherProgramDrawsAlike)
{
    ASSERT_EQ(run({"--svg", path("p.svg")}).exitCode, 0);
    output("rsvg-convert", {"--dpi-x", "25.4", "--dpi-y", "25.4", "-o", path("p.png"), path("p.svg")});
    const QImage image(path("p.png")); // a pixel is a millimetre
    ASSERT_FALSE(image.isNull());
    const std::string text = read("p.svg");
    const auto size = [&](const std::string& key) {
        return std::stod(text.substr(text.find(key + "=\"") + key.size() + 2));
    };
    EXPECT_NEAR(image.width(), size("width"), 1);
    EXPECT_NEAR(image.height(), size("height"), 1);
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            dark += qAlpha(image.pixel(x, y)) > 20;
    EXPECT_GT(dark, 1500) << "there are lines";
    for (const char* const layer : {"cut", "sew", "notches", "grain", "labels", "internal", "holes"})
        EXPECT_NE(text.find(std::string("<g id=\"") + layer), std::string::npos) << layer;
    EXPECT_NE(text.find("R\u00fccken"), std::string::npos);
}

/// Grey lines on white, found by their runs.
class SquareSearch {
public:
    explicit SquareSearch(const QImage& page)
        : m_page(page)
    {}

    /// Whether there is a square with this side, in pixels, within a pixel.
    bool finds(int side) const
    {
        for (int y = 0; y < m_page.height(); ++y)
            for (int x = 0, from = 0; x < m_page.width(); x = from + 1) {
                while (x < m_page.width() && !isInk(x, y))
                    ++x;
                for (from = x; from < m_page.width() && isInk(from, y);)
                    ++from;
                // Its upper side, or its lower one: the inch lies in a corner of the other square.
                if (std::abs(from - x - 1 - side) <= 1 &&
                    (isSquare(x, y, side) || (y >= side && isSquare(x, y - side, side))))
                    return true;
                if (from - x >= cornerArm && areCorners(x, y, side)) // over a piece
                    return true;
            }
        return false;
    }

private:
    static constexpr int cornerArm = 38; // pixels of the 4 mm

    bool isInk(int x, int y) const { return qGray(m_page.pixel(x, y)) < 215; }
    /// Or a neighbour.
    bool inked(int x, int y) const
    {
        for (int d = 0; d < 9; ++d)
            if (m_page.valid(x + d % 3 - 1, y + d / 3 - 1) && isInk(x + d % 3 - 1, y + d / 3 - 1))
                return true;
        return false;
    }
    bool areCorners(int left, int top, int side) const
    {
        const int right = left + side, bottom = top + side;
        for (int k = 0; k < cornerArm; ++k)
            for (const int y : {top, bottom})
                if (!inked(left + k, y) || !inked(right - k, y) || !inked(left, y == top ? y + k : y - k) ||
                    !inked(right, y == top ? y + k : y - k))
                    return false;
        return true;
    }
    bool isSquare(int left, int top, int side) const
    {
        if (top + side >= m_page.height() || left + side >= m_page.width())
            return false;
        int seen = 0;
        for (int k = 0; k <= side; ++k)
            seen += inked(left + k, top) && inked(left, top + k) && inked(left + side, top + k) &&
                    inked(left + k, top + side);
        return seen > side - 3;
    }

    const QImage& m_page;
};

TEST_F(Export, WritesPagesWhoseSquaresMeasure100Millimetres)
{
    for (const char* const paper : {"A4", "letter", "roll:400"}) {
        QStringList words{"--pdf", path("p.pdf"), "--paper", paper};
        const bool all = QLatin1String(paper) == QLatin1String("A4");
        if (!all) // images of more than 128 MB, as a roll would be, are not read
            words << "--piece"
                  << "Sitz links";
        ASSERT_EQ(run(words).exitCode, 0);
        for (const QString& old : QDir(path(".")).entryList({"page*.png"}))
            QFile::remove(path(old));
        output("pdftoppm", // 10 pixels for a millimetre; the other pages are made by the same lines
               {"-r", "254", "-l", "3", "-gray", "-png", path("p.pdf"), path("page")});
        const QStringList pages = QDir(path(".")).entryList({"page*.png"}, QDir::Files, QDir::Name);
        ASSERT_GE(pages.size(), all ? 3 : 1) << paper;
        for (const QString& name : pages) {
            const QImage page(path(name));
            const SquareSearch search(page);
            EXPECT_TRUE(search.finds(1000)) << paper << " " << name.toStdString() << ": 100 mm within 0.1 mm";
            EXPECT_TRUE(search.finds(254)) << paper << " " << name.toStdString() << ": an inch";
        }
    }
}

TEST_F(Export, TilesPutTogetherGiveTheCutLine)
{
    // A piece alone lies in the same place on a roll.
    ASSERT_EQ(run({"--pdf", path("p.pdf"), "--paper", "A4", "--lines", "cut", "--piece", "R\u00fccken"}).exitCode,
              0);
    ASSERT_EQ(run({"--pdf", path("whole.pdf"), "--paper", "roll:1470", "--lines", "cut", "--piece", "R\u00fccken"})
                  .exitCode,
              0);
    output("pdftoppm", {"-r", "127", "-gray", "-png", "-singlefile", path("whole.pdf"), path("whole")});
    const QImage whole(path("whole.png")); // 5 pixels for a millimetre
    ASSERT_NEAR(whole.width(), 7350, 1);
    const auto dark = [](const QImage& image, int x, int y) {
        return image.valid(x, y) && qGray(image.pixel(x, y)) < 128;
    };
    const std::string words = output("pdftotext", {"-layout", path("p.pdf"), "-"});
    int page = 0, looked = 0, missing = 0, tiles = 0;
    std::istringstream text(words);
    for (std::string one; std::getline(text, one, '\f');) {
        ++page;
        const std::size_t at = one.find("Sheet ");
        int row = 0, column = 0;
        if (at == std::string::npos || std::sscanf(one.c_str() + at, "Sheet %d/%d", &row, &column) != 2)
            continue;
        ++tiles;
        const QString number = QString::number(page);
        output("pdftoppm", {"-r", "127", "-gray", "-png", "-singlefile", "-f", number, "-l", number, path("p.pdf"),
                            path("tile")});
        const QImage tile(path("tile.png"));
        const int left = 900 * (column - 1), top = 1290 * (row - 1); // steps of 180 and 258 mm
        for (int y = 52; y < 50 + 1340 - 2; ++y)
            for (int x = 52; x < 50 + 950 - 2; ++x) {
                const int wx = x + left, wy = y + top;
                if (!dark(whole, wx, wy) || wy > whole.height() - 5 * 19)
                    continue; // the words of the roll, in its last 19 mm
                bool found = false;
                for (int d = 0; d < 9; ++d)
                    found = found || dark(tile, x + d % 3 - 1, y + d / 3 - 1);
                ++looked;
                missing += !found;
            }
    }
    EXPECT_EQ(tiles, 4) << "340 x 500 mm";
    EXPECT_GT(looked, 5000);
    EXPECT_EQ(missing, 0) << "within 0.2 mm";
}

TEST_F(Export, DrawsAPieceOnItsOwnSheetsAlone)
{
    ASSERT_EQ(run({"--pdf", path("p.pdf"), "--paper", "A4"}).exitCode, 0);
    const std::string words = output("pdftotext", {"-layout", path("p.pdf"), "-"});
    std::istringstream text(words);
    int sheets = 0, withSeat = 0;
    std::string one;
    std::getline(text, one, '\f');
    EXPECT_NE(one.find("Sitz links: sheets "), std::string::npos) << "the overview says on which it is";
    while (std::getline(text, one, '\f')) {
        if (one.find("(row ") == std::string::npos)
            continue;
        ++sheets;
        withSeat += one.find("Cut 2 and 2 mirrored") != std::string::npos;
    }
    EXPECT_GT(withSeat, 0);
    EXPECT_LT(withSeat, sheets) << "others have the other piece alone";
}

TEST_F(Export, RefusesADesignWithErrorsAndLeavesThemOutOnDemand)
{
    Json spoilt = panels();
    spoilt["elements"][1]["outline"]["points"] = {{0, 0}, {300, 400}, {300, 0}, {0, 400}}; // crosses itself
    write(QStringLiteral("panels.json"), spoilt.dump());
    const ProgramRun refused = run({"--svg", path("p.svg"), "--dxf", path("p.dxf"), "--pdf", path("p.pdf")});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(refused.err.find("error: "), std::string::npos) << refused.err;
    EXPECT_EQ(QDir(path(".")).entryList(QDir::Files), QStringList{"panels.json"}) << "nothing is written";
    const ProgramRun lenient = run({"--svg", path("p.svg"), "--lenient"});
    EXPECT_EQ(lenient.exitCode, 0);
    EXPECT_NE(lenient.err.find("left out: "), std::string::npos) << lenient.err;
    EXPECT_EQ(lenient.out.find("error"), std::string::npos);
    const std::string svg = read("p.svg");
    EXPECT_NE(svg.find("R\u00fccken"), std::string::npos);
    EXPECT_EQ(svg.find("Sitz links"), std::string::npos);
}

/// A seat of twelve metres, for a printer: thousands of sheets.
Json huge()
{
    Json design = panels();
    design["elements"] = {design["elements"][0], design["elements"][1]};
    design["elements"][1]["outline"]["points"] = {{0, 0}, {12000, 0}, {12000, 12000}, {0, 12000}};
    return design;
}

TEST_F(Export, InterruptedLeavesNothing)
{
    write(QStringLiteral("panels.json"), huge().dump());
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.setReadChannel(QProcess::StandardError);
    process.start(QString::fromStdString(test::program()),
                  {"export", m_design, "--svg", path("p.svg"), "--pdf", path("p.pdf")});
    // Wider than its fabric: that is said just before sheets are drawn.
    ASSERT_TRUE(process.waitForReadyRead(60000));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    ASSERT_TRUE(process.waitForFinished(60000));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 1);
    EXPECT_EQ(QDir(path(".")).entryList(QDir::Files | QDir::Hidden), QStringList{"panels.json"});
}

/// The pattern is ready long before the cover.
TEST_F(Export, InterruptedWhileTheCoverIsSolvedLeavesNoPattern)
{
    Json large = huge();
    large["settings"]["edge_length"] = 3;
    write(QStringLiteral("panels.json"), large.dump());
    QProcess process;
    process.setProcessEnvironment(bareEnvironment());
    process.start(QString::fromStdString(test::program()),
                  {"export", m_design, "--svg", path("p.svg"), "--stl", path("c.stl")});
    if (!process.waitForFinished(3000)) {
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        ASSERT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitCode(), 1);
        EXPECT_EQ(QDir(path(".")).entryList(QDir::Files | QDir::Hidden), QStringList{"panels.json"});
    }
}

TEST_F(Export, WritesToAPipeAloneWhatWasAskedFor)
{
    const QString command = QStringLiteral("\"%1\" export \"%2\" --svg /dev/stdout | cat > \"%3\"")
                                .arg(QString::fromStdString(test::program()), m_design, path("p.svg"));
    output(QStringLiteral("/bin/sh"), {"-c", command});
    const std::string svg = read("p.svg");
    EXPECT_EQ(svg.rfind("<?xml", 0), 0u);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n") << "and no word besides";
}

TEST_F(Export, RemovesWhatAKilledOneHasLeft)
{
    const QString left = QStringLiteral(".bolster-00000000-0123456789abcdef0123456789abcdef");
    write(left, "half a file");
    QFile file(path(left));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addDays(-2), QFileDevice::FileModificationTime));
    file.close();
    ASSERT_EQ(run({"--svg", path("p.svg")}).exitCode, 0);
    EXPECT_FALSE(QFile::exists(path(left)));
}

TEST_F(Export, ALongRollHasPagesThatPdfKnows)
{
    write(QStringLiteral("panels.json"), huge().dump());
    ASSERT_EQ(run({"--pdf", path("p.pdf"), "--paper", "roll:5000"}).exitCode, 0);
    const std::string info = output(QStringLiteral("pdfinfo"), {"-f", "2", "-l", "2", path("p.pdf")});
    double width = 0, height = 0;
    const std::size_t at = info.find("size:");
    ASSERT_NE(at, std::string::npos) << info;
    ASSERT_EQ(std::sscanf(info.c_str() + at, "size: %lf x %lf", &width, &height), 2);
    EXPECT_LE(std::max(width, height), 14400) << "no viewer shows more points";
}

TEST_F(Export, WritesHpglInsideBeforeCutLine)
{
    ASSERT_EQ(run({"--hpgl", path("p.plt"), "--piece", "Sitz links"}).exitCode, 0);
    const std::string text = read("p.plt");
    EXPECT_EQ(text.rfind("IN;\nSP2;", 0), 0u) << "what is drawn has a pen of its own";
    EXPECT_LT(text.find("LT2,2;"), text.find("SP1;")) << "the sewing line is dashed";
    // The cut line comes last: 320 mm wide, and 5 mm from the border, are 13,000 steps.
    EXPECT_NE(text.rfind("13000"), std::string::npos);
    EXPECT_LT(text.find("CI80;"), text.rfind("PD")) << "the hole of 4 mm, before";
}

TEST_F(Export, LeavesTheOldFileWhenItCannotWrite)
{
    const ProgramRun refused = run({"--svg", path("nowhere/p.svg")});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_FALSE(refused.err.empty());
    const ProgramRun both = run({"--dxf", path("p.dxf"), "--svg", path("nowhere/p.svg")});
    EXPECT_EQ(both.exitCode, 1);
    EXPECT_FALSE(QFile::exists(path("p.dxf"))) << "all of them, or none";
}

TEST_F(Export, TheSewingSheetSaysWhatIsSewn)
{
    const ProgramRun exported = run({"--sheet", path("sheet.pdf"), "--paper", "letter"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const std::string text = output(QStringLiteral("pdftotext"), {"-layout", path("sheet.pdf"), "-"});
    for (const char* words : {"Stuhl B", "Sitz links", "2 and 2 mirrored", "Leather", "Sitz links to R\u00fccken",
                              "Sewing thread", "No.", "Seams"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    const std::string info = output(QStringLiteral("pdfinfo"), {path("sheet.pdf")});
    EXPECT_NE(info.find("612 x 792"), std::string::npos) << info;
}

} // namespace
} // namespace bolster
