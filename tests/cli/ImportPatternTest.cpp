// `bolster import-pattern`, as a script calls it.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include "DesignJson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QFile>
#include <QProcess>

namespace bolster {
namespace {

class ImportPattern : public TestFiles {
protected:
    ProgramRun run(const QStringList& words) const
    {
        return callCommandLine(QStringList{"import-pattern"} + words);
    }

    Design made(const QString& name) const
    {
        QFile file(path(name.toUtf8().constData()));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return readDesign(file.readAll().toStdString()).design;
    }

    static int patches(const Design& design)
    {
        int count = 0;
        design.each<Patch>([&](ElementId, const Patch&) { ++count; });
        return count;
    }

    QString svg() const
    {
        return write(QStringLiteral("two.svg"),
                     R"(<svg xmlns="http://www.w3.org/2000/svg" width="900mm" height="400mm" viewBox="0 0 900 400">
        <path d="M10 10 H310 V210 H10 Z"/><path d="M20 20 H300 V200 H20 Z"/><path d="M400 10 H700 V210 H400 V14"/></svg>)");
    }
};

TEST_F(ImportPattern, MakesADesignOfAFile)
{
    const ProgramRun imported = run({svg(), path("two.json")});
    EXPECT_EQ(imported.exitCode, 0) << imported.err;
    EXPECT_NE(imported.out.find("1 piece"), std::string::npos) << imported.out;
    EXPECT_NE(imported.err.find("4.0 mm apart"), std::string::npos) << imported.err;
    const Design design = made(QStringLiteral("two.json"));
    EXPECT_EQ(patches(design), 1);
    design.each<Patch>([](ElementId, const Patch& patch) {
        EXPECT_NEAR(patch.outline.signedArea(), 280 * 180, 1e-6);
        EXPECT_NEAR(patch.allowance->width, 10, 1e-6);
    });
    EXPECT_EQ(run({svg(), path("two.json")}).exitCode, 1) << "it is there already";
}

TEST_F(ImportPattern, TakesUnitLayersAndGaps)
{
    EXPECT_EQ(run({svg(), path("in.json"), "--unit", "in", "--layers", "cut", "--close", "200"}).exitCode, 0);
    const Design design = made(QStringLiteral("in.json"));
    EXPECT_EQ(patches(design), 2);
    double largest = 0;
    design.each<Patch>([&](ElementId, const Patch& patch) {
        largest = std::max(largest, patch.outline.boundingBox().sizes().x());
    });
    EXPECT_NEAR(largest, 300 * 25.4, 1e-6) << "whatever the file says";
    EXPECT_EQ(run({svg(), path("x.json"), "--unit", "feet"}).exitCode, 2);
    const ProgramRun size = run({svg(), path("x.json"), "--size", "XL"});
    EXPECT_EQ(size.exitCode, 2);
    EXPECT_NE(size.err.find("XL"), std::string::npos);
}

TEST_F(ImportPattern, SaysWhatItCannotRead)
{
    EXPECT_EQ(run({write(QStringLiteral("a.dxf"), "nonsense\n1\n"), path("a.json")}).exitCode, 2);
    EXPECT_EQ(
        run({write(QStringLiteral("b.svg"), "<svg xmlns='http://www.w3.org/2000/svg'/>"), path("b.json")}).exitCode,
        2);
    EXPECT_FALSE(QFile::exists(path("b.json")));
    EXPECT_EQ(run({path("missing.dxf"), path("c.json")}).exitCode, 2);
    EXPECT_EQ(run({write(QStringLiteral("c.pdf"), "%PDF"), path("c.json")}).exitCode, 2);
}

TEST_F(ImportPattern, SaysWhatTheNumbersOfAPictureAre)
{
    const QString file =
        write(QStringLiteral("px.svg"), R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2000 2000">
        <path d="M10 10 H1010 V510 H10 Z"/></svg>)");
    const ProgramRun guessed = run({file, path("px.json")});
    EXPECT_NE(guessed.out.find("265 x 132 mm"), std::string::npos) << guessed.out;
    EXPECT_NE(guessed.out.find("pixels of 1/96 inch"), std::string::npos) << guessed.out;
    EXPECT_NE(run({file, path("mm.json"), "--unit", "mm"}).out.find("1000 x 500 mm"), std::string::npos);
}

TEST_F(ImportPattern, CountsAndMeasuresWhatIsTaken)
{
    const QString file = write(QStringLiteral("bad.svg"),
                               R"(<svg xmlns="http://www.w3.org/2000/svg" width="900mm" viewBox="0 0 900 900">
        <path d="M10 10 H310 V210 H10 Z"/><path d="M0 300 L800 800 V300 L0 800 Z"/></svg>)");
    const ProgramRun imported = run({file, path("bad.json")});
    EXPECT_EQ(imported.exitCode, 0);
    EXPECT_NE(imported.out.find("1 piece of 2"), std::string::npos) << imported.out;
    EXPECT_NE(imported.out.find("largest piece: 300 x 200 mm"), std::string::npos) << imported.out;
    EXPECT_NE(imported.err.find("crosses itself"), std::string::npos) << imported.err;
    EXPECT_EQ(callCommandLine({"check", path("bad.json")}).exitCode, 0);
}

TEST_F(ImportPattern, NamesLayersOfWhatIsLeftOut)
{
    const QString file = write(QStringLiteral("out.svg"),
                               R"(<svg xmlns="http://www.w3.org/2000/svg" width="900mm" viewBox="0 0 900 900">
        <g id="cut"><path d="M10 10 H310 V210 H10 Z"/></g><g id="stitch"><path d="M500 500 H600 V600 Z"/></g></svg>)");
    const ProgramRun imported = run({file, path("out.json")});
    EXPECT_NE(imported.err.find("1 shape on layer \"stitch\", in no piece"), std::string::npos) << imported.err;
}

TEST_F(ImportPattern, CountsLinesThatLieTwice)
{
    const QString file = write(QStringLiteral("twice.svg"),
                               R"(<svg xmlns="http://www.w3.org/2000/svg" width="900mm" viewBox="0 0 900 900">
        <path d="M10 10 H310 V210 H10 Z"/><path d="M10 10 H310 V210 H10 Z"/><path d="M10 10 H310 V210 H10 Z"/></svg>)");
    const ProgramRun imported = run({file, path("twice.json")});
    EXPECT_NE(imported.err.find("2 lines lay twice on themselves and are taken once"), std::string::npos)
        << imported.err;
}

TEST_F(ImportPattern, ReadsWhatOthersWrite)
{
    const QString tool = QString::fromStdString(test::sourceFolder()) + "/tests/cli/write_drawing.py";
    for (const char* version : {"R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"})
        for (const char* form : {"text", "binary"}) {
            SCOPED_TRACE(std::string(version) + " " + form);
            const QString name = QStringLiteral("%1-%2").arg(version, form);
            QProcess process;
            process.start("/usr/bin/python3", {tool, version, path((name + ".dxf").toUtf8().constData()), form});
            ASSERT_TRUE(process.waitForFinished(60000));
            ASSERT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
            const auto truth = nlohmann::json::parse(process.readAllStandardOutput().toStdString());
            const ProgramRun imported =
                run({path((name + ".dxf").toUtf8().constData()), path((name + ".json").toUtf8().constData())});
            EXPECT_EQ(imported.exitCode, 0);
            EXPECT_EQ(imported.err, "");
            const Design design = made(name + ".json");
            double area = 0;
            std::set<std::string> names;
            design.each<Patch>([&](ElementId, const Patch& patch) {
                area += std::abs(patch.outline.signedArea());
                names.insert(patch.name);
            });
            EXPECT_EQ(patches(design), truth["pieces"].get<int>());
            EXPECT_NEAR(area, truth["area"].get<double>(), 2e-4 * truth["area"].get<double>());
            EXPECT_TRUE(names.contains("R\u00fccken"));
            EXPECT_EQ(names.contains("Sitz \u03a9"), std::string(version) != "R12");
        }
}

} // namespace
} // namespace bolster
