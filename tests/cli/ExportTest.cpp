// Patterns as files, read by programs of others: ezdxf, poppler, librsvg.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>

#include <algorithm>
#include <cmath>
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

TEST_F(Export, WritesPagesWhoseSquaresMeasure100Millimetres)
{
    ASSERT_EQ(run({"--pdf", path("p.pdf"), "--paper", "A4"}).exitCode, 0);
    // 10 pixels for a millimetre: the square's lines are found by their runs.
    output("pdftoppm", {"-r", "254", "-gray", "-png", path("p.pdf"), path("page")});
    const QStringList pages = QDir(path(".")).entryList({"page*.png"}, QDir::Files, QDir::Name);
    ASSERT_GE(pages.size(), 5) << "an overview and sheets";
    for (const QString& name : pages) {
        const QImage page(path(name));
        EXPECT_NEAR(page.width(), 2100, 1);
        EXPECT_NEAR(page.height(), 2970, 1);
        // Its corners: 15 mm from the left of the room and 15 mm above its lower end.
        const auto inked = [&](double x, double y) {
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (qGray(page.pixel(std::lround(10 * x) + dx, std::lround(10 * y) + dy)) < 215)
                        return true;
            return false;
        };
        const double left = 10 + 15, bottom = 297 - 10 - 9 - 15;
        int seen = 0;
        for (int k = 1; k < 100; ++k)
            seen += inked(left + k, bottom) && inked(left + k, bottom - 100) && inked(left, bottom - k) &&
                    inked(left + 100, bottom - k);
        EXPECT_GE(seen, 97) << name.toStdString() << ": 100 mm within 0.1 mm";
    }
}

TEST_F(Export, TilesPutTogetherGiveTheCutLine)
{
    // As wide as seven columns of A4: the pieces lie in the same places.
    ASSERT_EQ(run({"--pdf", path("p.pdf"), "--paper", "A4", "--lines", "cut"}).exitCode, 0);
    ASSERT_EQ(run({"--pdf", path("whole.pdf"), "--paper", "roll:1470", "--lines", "cut"}).exitCode, 0);
    output("pdftoppm", {"-r", "127", "-gray", "-png", "-singlefile", path("whole.pdf"), path("whole")});
    const QImage whole(path("whole.png")); // 5 pixels for a millimetre
    ASSERT_NEAR(whole.width(), 7350, 1);
    const auto dark = [](const QImage& image, int x, int y) {
        return image.valid(x, y) && qGray(image.pixel(x, y)) < 128;
    };
    const std::string words = output("pdftotext", {"-layout", path("p.pdf"), "-"});
    int page = 0, looked = 0, missing = 0;
    std::istringstream text(words);
    for (std::string one; std::getline(text, one, '\f');) {
        ++page;
        const std::size_t at = one.find("Row ");
        int row = 0, column = 0;
        if (at == std::string::npos || std::sscanf(one.c_str() + at, "Row %d, column %d", &row, &column) != 2)
            continue;
        const QString number = QString::number(page);
        output("pdftoppm", {"-r", "127", "-gray", "-png", "-singlefile", "-f", number, "-l", number, path("p.pdf"),
                            path("tile")});
        const QImage tile(path("tile.png"));
        const int left = 900 * (column - 1), top = 1290 * (row - 1); // steps of 180 and 258 mm
        for (int y = 52; y < 50 + 1340 - 2; ++y)
            for (int x = 52; x < 50 + 950 - 2; ++x) {
                const int wx = x + left, wy = y + top;
                if (!dark(whole, wx, wy) || wy > whole.height() - 60 || (wx < 800 && wy > whole.height() - 720))
                    continue; // the squares and words of the roll
                bool found = false;
                for (int d = 0; d < 9; ++d)
                    found = found || dark(tile, x + d % 3 - 1, y + d / 3 - 1);
                ++looked;
                missing += !found;
            }
    }
    EXPECT_GT(looked, 5000);
    EXPECT_EQ(missing, 0) << "within 0.2 mm";
}

TEST_F(Export, WritesHpglInsideBeforeCutLine)
{
    ASSERT_EQ(run({"--hpgl", path("p.plt"), "--piece", "Sitz links"}).exitCode, 0);
    const std::string text = read("p.plt");
    EXPECT_EQ(text.rfind("IN;SP1;", 0), 0u);
    // The cut line comes last: 320 mm wide, and 5 mm from the border, are 13,000 steps.
    EXPECT_NE(text.rfind("13000"), std::string::npos);
    EXPECT_LT(text.find("CI80;"), text.rfind("PD")) << "the hole of 4 mm, before";
}

TEST_F(Export, LeavesTheOldFileWhenItCannotWrite)
{
    const ProgramRun refused = run({"--svg", path("nowhere/p.svg")});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_FALSE(refused.err.empty());
}

TEST_F(Export, TheSewingSheetSaysWhatIsSewn)
{
    const ProgramRun exported = run({"--sheet", path("sheet.pdf"), "--paper", "letter"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    const std::string text = output(QStringLiteral("pdftotext"), {"-layout", path("sheet.pdf"), "-"});
    for (const char* words :
         {"Stuhl B", "Sitz links", "2 and 2 mirrored", "Leather", "Sitz links to R\u00fccken", "Sewing thread"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    const std::string info = output(QStringLiteral("pdfinfo"), {path("sheet.pdf")});
    EXPECT_NE(info.find("612 x 792"), std::string::npos) << info;
}

} // namespace
} // namespace bolster
