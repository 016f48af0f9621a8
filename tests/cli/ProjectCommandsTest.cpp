// bolster dump, import, history, verify, salvage, and solve and check of both forms.
#include "../model/TestFiles.h"
#include "DesignJson.h"
#include "ElementEdits.h"
#include "Journal.h"
#include "ProgramRun.h"
#include "TestPaths.h"

#include <nlohmann/json.hpp>

#include <QBuffer>
#include <QColor>
#include <QDir>
#include <QFileInfo>
#include <QImage>

namespace bolster {
namespace {

using Json = nlohmann::json;

const char* const samples[] = {"box-cushion", "car-seat", "armchair"};

QString sample(const char* name)
{
    return QString::fromStdString(test::samplesFolder()) + "/" + name + "/" + name + ".json";
}

class ProjectCommands : public TestFiles {
protected:
    std::string dumped(const QString& file) const
    {
        const ProgramRun run = callCommandLine({"dump", file});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return run.out;
    }

    /// A project of a small design with one edit and an undo.
    QString project(const std::map<NodeId, std::string>& pictures = {}) const
    {
        const QString own = path("journal" + QString::number(QDir(m_folder.path()).count()));
        Design design = readDesign(R"({"format": "bolster-design", "version": 1, "elements": [
            {"id": 1, "kind": "fabric", "name": "Leather"}]})")
                            .design;
        const Journal::Opened opened = Journal::create(own, design);
        History history = opened.project.history;
        for (const char* name : {"Wool", "Silk"}) {
            const Edit edit = edits::renameElement(design, ElementId{1}, name);
            history.append(edit);
            design = design.with(edit);
        }
        design = *history.moveTo(1, design);
        EXPECT_TRUE(opened.journal->record(history, design).empty());
        EXPECT_TRUE(opened.journal->setNames(1, "Cheap one", "Fabrics").empty());
        for (const auto& [node, png] : pictures)
            EXPECT_TRUE(opened.journal->setThumbnail(node, png).empty());
        EXPECT_TRUE(opened.journal->save(path("a.bolster")).empty());
        return path("a.bolster");
    }

    static std::string png(int width, int height, const QColor& color)
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QImage image(width, height, QImage::Format_RGBA8888);
        image.fill(color);
        EXPECT_TRUE(image.save(&buffer, "PNG"));
        return bytes.toStdString();
    }
};

TEST_F(ProjectCommands, DumpImportDumpIsTheSameToTheByte)
{
    for (const char* name : samples) {
        const QString file = path(QString(name) + ".bolster");
        ASSERT_EQ(callCommandLine({"import", sample(name), file}).exitCode, 0) << name;
        QDir().mkdir(path(name));
        const ProgramRun first = callCommandLine({"dump", file, "--assets", path(name)});
        ASSERT_EQ(first.exitCode, 0) << first.err;
        EXPECT_EQ(first.out, dumped(sample(name))) << "a text is dumped canonically, too";
        const QString text = write(QString(name) + "/again.json", first.out);
        const QString again = path(QString(name) + "-again.bolster");
        ASSERT_EQ(callCommandLine({"import", text, again}).exitCode, 0);
        EXPECT_EQ(dumped(again), first.out);
        EXPECT_EQ(openProject(again).assets.size(), openProject(file).assets.size());
        EXPECT_EQ(callCommandLine({"verify", again}).exitCode, 0);
    }
}

TEST_F(ProjectCommands, SolveAndCheckTakeBothForms)
{
    const QString text = sample("armchair");
    const QString file = path("armchair.bolster");
    ASSERT_EQ(callCommandLine({"import", text, file}).exitCode, 0);
    const ProgramRun ofText = callCommandLine({"check", text});
    const ProgramRun ofProject = callCommandLine({"check", file});
    EXPECT_EQ(ofProject.exitCode, ofText.exitCode);
    EXPECT_EQ(ofProject.out, ofText.out);
    EXPECT_EQ(ofProject.err, ofText.err);
    for (const QString& form : {text, file})
        ASSERT_EQ(callCommandLine(
                      {"solve", form, "--tolerance", "0.01", "--obj", form == text ? path("t.obj") : path("p.obj")})
                      .exitCode,
                  0);
    EXPECT_EQ(read("t.obj"), read("p.obj"));
}

TEST_F(ProjectCommands, MissingFilesAreReportedAndTheRestImported)
{
    const QString text = write("a.json", R"({"format": "bolster-design", "version": 1, "elements": [
        {"id": 7, "kind": "frame", "name": "Chair", "file": "none.obj"}, {"id": 8, "kind": "sofa"}]})");
    const ProgramRun run = callCommandLine({"import", text, path("a.bolster")});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_NE(run.err.find("there is no file \"none.obj\""), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("the kind \"sofa\" is unknown"), std::string::npos) << run.err;
    EXPECT_EQ(dumped(path("a.bolster")), dumped(text));
    EXPECT_EQ(callCommandLine({"check", path("a.bolster")}).exitCode, 2);
}

TEST_F(ProjectCommands, ImportNeverReplacesAFile)
{
    write("a.bolster", "precious");
    const ProgramRun run = callCommandLine({"import", sample("box-cushion"), path("a.bolster")});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(read("a.bolster"), "precious");
    EXPECT_EQ(callCommandLine({"import", path("none.json"), path("b.bolster")}).exitCode, 2);
    EXPECT_EQ(callCommandLine({"import", write("bad.json", "{"), path("b.bolster")}).exitCode, 2);
    EXPECT_EQ(callCommandLine({"import", sample("box-cushion"), path("none/b.bolster")}).exitCode, 1);
    EXPECT_FALSE(QFileInfo::exists(path("b.bolster")));
}

TEST_F(ProjectCommands, ListsTheHistoryAndDumpsIt)
{
    const QString file = project();
    const ProgramRun run = callCommandLine({"history", file});
    EXPECT_EQ(run.exitCode, 0);
    const QStringList lines = QString::fromStdString(run.out).split('\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 3);
    EXPECT_TRUE(lines[0].startsWith("  0 - ") && lines[0].endsWith("(begin)")) << run.out;
    EXPECT_TRUE(lines[1].startsWith("* 1 0 ") && lines[1].endsWith(" [Fabrics] \"Cheap one\"")) << run.out;
    EXPECT_TRUE(lines[2].startsWith("  2 1 ")) << run.out;

    const Json dump = Json::parse(callCommandLine({"dump", file, "--history"}).out);
    EXPECT_EQ(dump["format"], "bolster-history");
    EXPECT_EQ(dump["current"], 1);
    ASSERT_EQ(dump["nodes"].size(), 3u);
    EXPECT_EQ(dump["nodes"][2]["changes"], Json::parse(R"([[1, "name", "Wool", "Silk"]])"));
    EXPECT_EQ(dump["nodes"][1]["name"], "Cheap one");
    EXPECT_EQ(dump["nodes"][1]["branch"], "Fabrics");
    EXPECT_FALSE(dump["nodes"][2].contains("branch"));
    EXPECT_EQ(dump["design"]["elements"][0]["name"], "Wool");
    EXPECT_EQ(lines[1].section(' ', 4, 4).toStdString(),
              dump["nodes"][1]["design_hash"].get<std::string>().substr(0, 12));
}

TEST_F(ProjectCommands, VerifySeesDamage)
{
    const QString file = project();
    EXPECT_EQ(callCommandLine({"verify", file}).out, "sound: 2 edits, 0 files\n");
    std::string bytes = read("a.bolster");
    const std::size_t place = bytes.find("Silk");
    ASSERT_NE(place, std::string::npos);
    bytes[place] = 'M';
    for (const QString& bad : {write("b.bolster", bytes), write("c.bolster", "no project"), path("none")}) {
        EXPECT_EQ(callCommandLine({"verify", bad}).exitCode, 2);
        EXPECT_EQ(callCommandLine({"history", bad}).exitCode, 2);
        EXPECT_EQ(callCommandLine({"dump", bad}).exitCode, 2);
        EXPECT_EQ(callCommandLine({"check", bad}).exitCode, 2);
        EXPECT_EQ(callCommandLine({"solve", bad}).exitCode, 2);
    }
}

TEST_F(ProjectCommands, EachExplainsItselfAndItsWrongUse)
{
    for (const char* command : {"dump", "import", "history", "verify", "thumbnail"}) {
        EXPECT_TRUE(callCommandLine({command, "--help"}).out.starts_with(std::string("Usage: bolster ") + command));
        EXPECT_EQ(callCommandLine({command}).exitCode, 2);
        EXPECT_EQ(callCommandLine({command, "a", "b", "c"}).exitCode, 2);
        EXPECT_EQ(callCommandLine({command, "a", "--frobnicate"}).exitCode, 2);
    }
    EXPECT_EQ(callCommandLine({"dump", sample("box-cushion"), "--history"}).exitCode, 2);
}

TEST_F(ProjectCommands, ThumbnailCopiesThePictureOfTheCurrentVersion)
{
    // Version 1 is the current one; 2 is another branch's.
    const QString file =
        project({{0, png(40, 30, Qt::green)}, {1, png(192, 144, Qt::red)}, {2, png(40, 30, Qt::blue)}});
    const std::string before = read("a.bolster");
    const QString out = path("out.png");
    ASSERT_EQ(runProgram({"thumbnail", file, out}).exitCode, 0);
    EXPECT_EQ(QImage(out).size(), QSize(192, 144)) << "a smaller one stays as it is";
    EXPECT_EQ(QImage(out).pixelColor(96, 72), QColor(Qt::red));
    ASSERT_EQ(runProgram({"thumbnail", "--size", "64", "--", file, out}).exitCode, 0);
    EXPECT_EQ(QImage(out).size(), QSize(64, 48));
    EXPECT_EQ(read("a.bolster"), before);
}

TEST_F(ProjectCommands, ThumbnailDrawsNothing)
{
    const QString out = path("out.png");
    const auto refused = [&](const QString& file, int code, const char* words) {
        const ProgramRun run = runProgram({"thumbnail", file, out});
        EXPECT_EQ(run.exitCode, code) << run.err;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
        EXPECT_FALSE(QFileInfo::exists(out));
    };
    refused(project({{2, png(40, 30, Qt::blue)}}), 1, "has no picture");
    refused(project({{1, "no picture"}}), 1, "the picture in");
    std::string bomb = png(8, 8, Qt::blue);
    bomb[16] = bomb[20] = 0x7f; // its head promises two thousand million pixels each way
    refused(project({{1, bomb}}), 1, "the picture in");
    refused(write("text.bolster", "no project"), 2, "no Bolster project");
    refused(path("none"), 2, "none");
    const std::string whole = read("a.bolster");
    refused(write("cut.bolster", whole.substr(0, whole.size() / 2)), 2, "damaged");
    EXPECT_EQ(runProgram({"thumbnail", path("a.bolster"), path("a.bolster")}).exitCode, 2);
    EXPECT_EQ(read("a.bolster"), whole);
}

} // namespace
} // namespace bolster
