// `bolster import-pattern`, as a script calls it.
#include "../model/TestFiles.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include "DesignJson.h"

#include <gtest/gtest.h>

#include <QFile>

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
    EXPECT_NEAR(largest, 300 * 25.4, 1e-6);
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

} // namespace
} // namespace bolster
