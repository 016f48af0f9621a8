// Projects of all versions of the format that there ever were.
#include "Database.h"
#include "ProjectFuzz.h"
#include "TestPaths.h"
#include "TestProject.h"

#include <QDir>

namespace bolster::test {
namespace {

using Versions = TestFiles;

const QString corpus = QString::fromStdString(test::dataFolder()) + "/projects/v1/";

/// What must never change about a project: every version of the design, and all that the history says.
std::string everything(const OpenedProject& project)
{
    std::string text = historyText(project.history) + "\n" + writeDesign(project.design);
    for (NodeId node = 0; node < project.history.count(); ++node)
        text += hexText(hashOf(writeDesign(project.history.designAt(node, project.design).value()))) + "\n";
    for (const auto& [name, blob] : project.assets)
        text += name + "\n";
    return text;
}

TEST_F(Versions, ProjectsOfVersion1OpenForEver)
{
    const QStringList files = QDir(corpus).entryList({"*.bolster"});
    EXPECT_FALSE(files.isEmpty());
    for (const QString& file : files) {
        const OpenedProject project = openProject(corpus + file, ProjectCheck::Everything);
        ASSERT_EQ(project.problem.english(), "") << file.toStdString();
        const std::string wanted = readWholeFile(corpus + file + ".txt", 10'000'000).bytes;
        EXPECT_EQ(everything(project), wanted) << file.toStdString();
        expectFine(extractAllAssets(project, path("assets")));
        EXPECT_EQ(read("assets/chair.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        EXPECT_TRUE(openDesignOrProject(corpus + file).readable);
        EXPECT_TRUE(Journal::begin(corpus + file, path("journal")).journal) << "work can go on";
    }
}

/// Made the file above, once: BOLSTER_WRITE_CORPUS names the folder. BOLSTER_CORPUS_STEPS=4 made that of the
/// fuzzer.
TEST_F(Versions, WritesACorpusFileWhenAsked)
{
    const QString folder = qEnvironmentVariable("BOLSTER_WRITE_CORPUS");
    if (folder.isEmpty())
        GTEST_SKIP();
    Document document;
    document.reset(smallDesign());
    Journal::Opened opened = Journal::create(path("journal"), document.committed());
    document.reset(opened.project.design, opened.project.history);
    write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("room.xyz", "1 2 3\n4 5 6\n");
    for (std::string name : {"chair.obj", "scans/room.xyz"})
        expectFine(opened.journal->addAsset(name, path(QString::fromStdString(name).section('/', -1))));
    Hands hands(2026);
    const int steps = rounds("BOLSTER_CORPUS_STEPS", 220);
    for (int step = 0; step < steps; ++step) {
        hands.step(document);
        expectFine(opened.journal->record(document.history(), document.committed()));
        if (step == 100) {
            expectFine(opened.journal->setThumbnail(3, "no picture"));
            expectFine(opened.journal->save(path("a.bolster")));
            opened = {};
            opened = Journal::open(path("journal"));
            document.reset(opened.project.design, opened.project.history);
        }
    }
    expectFine(opened.journal->setNames(std::min(7, document.history().count() - 1), "Für den Kunden", "Leder"));
    expectFine(opened.journal->save(folder + "/small.bolster"));
    const OpenedProject project = openProject(folder + "/small.bolster", ProjectCheck::Everything);
    expectFine(replaceWholeFile(folder + "/small.bolster.txt", everything(project)));
}

TEST_F(Versions, ReadersTakeAnyBytes)
{
    std::mt19937 random(1);
    const std::string edit = encodeChanges(fieldChanges(editBetween(Design(), smallDesign(), {})));
    ASSERT_TRUE(fuzzChanges(edit));
    int edits = 0;
    const auto mutate = [&](std::string bytes, int most) {
        for (int change = static_cast<int>(random()) % most; change >= 0; --change)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        return bytes;
    };
    for (int i = 0; i < 20'000; ++i)
        edits += fuzzChanges(mutate(edit, 4));
    EXPECT_GT(edits, 1'000);
    Document document;
    document.reset(smallDesign());
    expectFine(Journal::create(path("journal"), document.committed()).journal->save(path("a.bolster")));
    const std::string project = read("a.bolster");
    for (int i = 0; i < 100; ++i)
        fuzzProject(path("fuzzed" + QString::number(i)), mutate(project, 200));
}

} // namespace
} // namespace bolster::test
