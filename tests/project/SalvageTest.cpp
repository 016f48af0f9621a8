// Of a damaged project everything is saved whose hashes are right, and what is lost is said.
#include "Salvage.h"
#include "CraftedProject.h"
#include "DesignHash.h"
#include "TestProject.h"

#include <sqlite3.h>

#include <algorithm>

namespace bolster::test {
namespace {

class SalvageTest : public TestFiles {
protected:
    void make(int steps)
    {
        m_document.reset(smallDesign());
        const auto opened = Journal::create(path("journal"), m_document.committed());
        Hands hands(11);
        History last = m_document.history();
        for (int i = 0; i < steps; ++i) {
            m_document.commit(hands.edit(m_document.design()));
            if (i % 50 == 49)
                m_document.jumpTo(static_cast<NodeId>(hands.pick(m_document.history().count())));
            if (i % 200 == 199)
                expectFine(opened.journal->record(m_document.history(), m_document.committed()));
        }
        expectFine(opened.journal->record(m_document.history(), m_document.committed()));
        write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        for (std::string name : {"chair.obj", "second.obj"})
            expectFine(opened.journal->addAsset(name, path("chair.obj")));
        expectFine(opened.journal->setNames(3, "Three", "Third way"));
        expectFine(opened.journal->save(path("a.bolster")));
        m_bytes = read("a.bolster");
    }

    void change(const std::string& sql)
    {
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(path("a.bolster").toUtf8(), &database), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database);
        sqlite3_close(database);
    }

    OpenedProject salvaged(std::vector<std::string>* notes = nullptr)
    {
        QFile::remove(path("out.bolster"));
        const Salvaged result = salvageProject(path("a.bolster"), path("out.bolster"));
        EXPECT_EQ(result.problem.english(), "");
        if (notes)
            for (const Message& note : result.notes)
                notes->push_back(note.english());
        return openProject(path("out.bolster"), ProjectCheck::Everything);
    }

    Document m_document;
    std::string m_bytes;
};

TEST_F(SalvageTest, OfASoundProjectEverythingIsSaved)
{
    make(120);
    std::vector<std::string> notes;
    const OpenedProject project = salvaged(&notes);
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_EQ(notes,
              std::vector<std::string>{std::to_string(m_document.history().count()) + " versions were saved"});
    EXPECT_EQ(writeDesign(project.design), writeDesign(m_document.committed()));
    EXPECT_EQ(project.history.count(), m_document.history().count());
    EXPECT_EQ(project.assets.size(), 2u);
    EXPECT_EQ(project.history.node(3).name, "Three");
    EXPECT_EQ(project.history.node(3).branch, "Third way");
}

TEST_F(SalvageTest, ADatabaseOfAnotherProgramIsNotCalledDamaged)
{
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path("other.bolster").toUtf8(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, "CREATE TABLE t(a); INSERT INTO t VALUES(1)", nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(database);
    const Salvaged result = salvageProject(path("other.bolster"), path("out.bolster"));
    EXPECT_EQ(result.problem.english(), "\"" + path("other.bolster").toStdString() + "\" is no Bolster project");
}

/// What was saved stands in it twice.
TEST_F(SalvageTest, NoSingleBitTakesWhatWasSaved)
{
    make(14);
    const std::string saved = writeDesign(m_document.committed());
    constexpr std::size_t page = 8192;
    for (std::size_t at = page / 2; at < m_bytes.size(); at += page) {
        for (const std::size_t place : {at, at + page / 2 - 100}) {
            std::string bytes = m_bytes;
            bytes[place] = static_cast<char>(bytes[place] ^ 1);
            write("a.bolster", bytes);
            const OpenedProject project = salvaged();
            EXPECT_EQ(project.problem.english(), "");
            EXPECT_EQ(writeDesign(project.design), saved) << "a bit in byte " << place;
        }
    }
}

TEST_F(SalvageTest, ADamagedEditCostsItAndWhatFollowsFromIt)
{
    make(120);
    const NodeId bad = 30;
    change("UPDATE node SET verb = 'x' WHERE id = 30");
    std::vector<std::string> notes;
    const OpenedProject project = salvaged(&notes);
    ASSERT_EQ(project.problem.english(), "");
    int sound = 0;
    for (NodeId id = 0; id < m_document.history().count(); ++id) {
        const auto way = m_document.history().pathTo(id);
        sound += std::find(way.begin(), way.end(), bad) == way.end();
    }
    const auto current = m_document.history().pathTo(m_document.history().current());
    const bool currentFollows = std::find(current.begin(), current.end(), bad) != current.end();
    ASSERT_TRUE(currentFollows);
    EXPECT_EQ(project.history.count(), sound + 1) << "what was saved stands there a second time";
    EXPECT_EQ(writeDesign(project.design), writeDesign(m_document.committed()));
    EXPECT_LT(sound, m_document.history().count());
    EXPECT_GT(sound, bad) << "other branches are there";
    ASSERT_GE(notes.size(), 2u);
    EXPECT_TRUE(notes[1].starts_with("lost: versions 30 to ")) << notes[1];
}

TEST_F(SalvageTest, AfterAGapTheKeptVersionsAndWhatFollowsThemAreThere)
{
    m_document.reset(smallDesign());
    auto opened = Journal::create(path("journal"), m_document.committed());
    Hands hands(12);
    while (m_document.history().count() < 1'300)
        m_document.commit(hands.edit(m_document.design()));
    expectFine(opened.journal->record(m_document.history(), m_document.committed()));
    expectFine(opened.journal->save(path("a.bolster")));
    for (const char* damage : {"DELETE FROM node WHERE id = 500", "DELETE FROM node WHERE id = 0"}) {
        change(damage);
        std::vector<std::string> notes;
        const OpenedProject project = salvaged(&notes);
        ASSERT_EQ(project.problem.english(), "");
        EXPECT_EQ(writeDesign(project.design), writeDesign(m_document.committed()));
        EXPECT_GE(project.history.count(), 300);
        EXPECT_NE(notes.back().find("was saved without the edits before it"), std::string::npos);
    }
}

TEST_F(SalvageTest, LostFilesAndNamesAreSaid)
{
    make(20);
    change("UPDATE asset SET name = 'other' WHERE name = 'second.obj'; UPDATE label SET version = 'x'");
    std::vector<std::string> notes;
    const OpenedProject project = salvaged(&notes);
    EXPECT_EQ(project.assets.size(), 1u);
    EXPECT_EQ(notes.size(), 3u);
    change("UPDATE chunk SET data = x'00'");
    EXPECT_EQ(salvaged().assets.size(), 0u);
    EXPECT_EQ(salvaged().history.count(), m_document.history().count());
}

TEST_F(SalvageTest, WhateverPagesAreLostTheResultIsSound)
{
    make(300);
    std::mt19937 random(1);
    const int wanted = rounds("BOLSTER_SALVAGES", 30);
    int saved = 0;
    for (int i = 0; i < wanted; ++i) {
        std::string bytes = m_bytes;
        for (int bad = 0; bad <= i % 3; ++bad) {
            const std::size_t page = 8192 * (random() % (bytes.size() / 8192));
            for (std::size_t at = page; at < page + 8192; ++at)
                bytes[at] = static_cast<char>(i % 2 == 0 ? 0 : random());
        }
        QFile::remove(path("bad.bolster"));
        QFile::remove(path("out.bolster"));
        const Salvaged result = salvageProject(write("bad.bolster", bytes), path("out.bolster"));
        EXPECT_EQ(result.problem.empty(), QFileInfo::exists(path("out.bolster")));
        EXPECT_EQ(read("bad.bolster"), bytes);
        if (!result.problem.empty())
            continue;
        ++saved;
        ASSERT_EQ(openProject(path("out.bolster"), ProjectCheck::Everything).problem.english(), "") << i;
    }
    std::printf("something was saved in %d of %d cases\n", saved, wanted);
    EXPECT_GT(saved, wanted / 2);
}

TEST_F(SalvageTest, ADamagedHeadCostsNothing)
{
    make(20);
    for (const std::size_t place : {0, 16, 18, 20, 28, 32, 44, 56, 60, 68, 92}) {
        std::string bytes = m_bytes;
        bytes[place] = static_cast<char>(bytes[place] ^ 0x55);
        QFile::remove(path("a.bolster"));
        write("a.bolster", bytes);
        EXPECT_EQ(salvaged().history.count(), m_document.history().count()) << place;
    }
}

TEST_F(SalvageTest, ADamagedListOfTablesCostsNothing)
{
    make(20);
    std::vector<std::size_t> places = {100, 103, 104, 105, 106, 108, 109, 110};
    for (const char* const word :
         {"TABLE thumbnail", "TABLE node", "tablenode", "run INTEGER", "png BLOB", "tablestate"})
        places.push_back(m_bytes.find(word) + 4);
    for (const std::size_t place : places) {
        ASSERT_LT(place, 8192u);
        std::string bytes = m_bytes;
        bytes[place] = static_cast<char>(bytes[place] ^ 0x02);
        QFile::remove(path("a.bolster"));
        write("a.bolster", bytes);
        EXPECT_EQ(salvaged().history.count(), m_document.history().count()) << place;
    }
}

TEST_F(SalvageTest, SaysWhenNothingCanBeSavedAndReplacesNothing)
{
    for (const std::string& bytes : {std::string(), std::string("hello"), std::string(100'000, 'x')}) {
        const Salvaged result = salvageProject(write("x", bytes), path("out.bolster"));
        EXPECT_FALSE(result.problem.empty());
        EXPECT_FALSE(result.readable);
        EXPECT_FALSE(QFileInfo::exists(path("out.bolster")));
    }
    make(3);
    write("precious", "1");
    EXPECT_FALSE(salvageProject(path("a.bolster"), path("precious")).problem.empty());
    EXPECT_EQ(read("precious"), "1");
}

TEST_F(SalvageTest, TablesThatAreNotOursAreNotAskedAndTheRestIsSaved)
{
    make(60);
    struct Case {
        const char* sql;
        const char* table;
        bool sound; // whether all versions can be saved nevertheless
    };
    for (const Case& foreign :
         {Case{"DROP TABLE label; CREATE TABLE label(node INTEGER PRIMARY KEY)", "label", true},
          Case{"ALTER TABLE label ADD COLUMN more ANY", "label", true},
          Case{"ALTER TABLE asset ADD COLUMN more ANY", "asset", true},
          Case{"DROP TABLE snapshot; CREATE TABLE snapshot(node INTEGER PRIMARY KEY)", "snapshot", true},
          Case{"DROP TABLE snapshot; CREATE VIEW snapshot AS SELECT 1 AS rowid, zeroblob(900000000)", "snapshot",
               true},
          Case{"ALTER TABLE label ADD COLUMN big BLOB AS (zeroblob(1000000000))", "label", true},
          Case{"DROP TABLE state", "state", true},
          Case{"CREATE TRIGGER t AFTER INSERT ON node BEGIN SELECT 1; END; CREATE TABLE more(a)", nullptr, true},
          Case{"ALTER TABLE node ADD COLUMN big BLOB AS (zeroblob(1000000000))", "node", false},
          Case{"DROP TABLE node; CREATE TABLE node(id INTEGER PRIMARY KEY)", "node", false}}) {
        QFile::remove(path("a.bolster"));
        write("a.bolster", m_bytes);
        change(foreign.sql);
        QFile::remove(path("out.bolster"));
        const Salvaged result = salvageProject(path("a.bolster"), path("out.bolster"));
        if (!result.problem.empty()) { // there is a snapshot or none, by chance
            EXPECT_FALSE(foreign.sound) << foreign.sql << result.problem.english();
            EXPECT_NE(result.problem.english().find("a.bolster"), std::string::npos) << result.problem.english();
            continue;
        }
        const OpenedProject project = openProject(path("out.bolster"), ProjectCheck::Everything);
        ASSERT_EQ(project.problem.english(), "") << foreign.sql;
        if (foreign.sound) {
            EXPECT_EQ(project.history.count(), m_document.history().count()) << foreign.sql;
        }
        const bool said = std::any_of(result.notes.begin(), result.notes.end(), [&](const Message& note) {
            return foreign.table && note.english().starts_with("lost: the table \"" + std::string(foreign.table));
        });
        EXPECT_EQ(said, foreign.table != nullptr) << foreign.sql;
    }
}

TEST_F(SalvageTest, AnEditThatLeadsElsewhereCostsItAndWhatFollowsFromIt)
{
    std::vector<Design> designs = {smallDesign()};
    {
        CraftedProject crafted(path("a.bolster"));
        crafted.node(-1, Design(), designs[0]);
        for (int i = 1; i <= 5; ++i) {
            const NodeId parent = i == 5 ? 2 : i - 1; // a branch that has nothing to do with the bad one
            const Design from = designs[static_cast<std::size_t>(parent)];
            designs.push_back(from.with(edits::renameElement(from, ElementId{2}, "Name " + std::to_string(i))));
            const std::string patch = packChanges(fieldChanges(editBetween(from, designs.back(), {})));
            crafted.node(parent, patch, i == 3 ? Hash{} : hashOf(designs.back()));
        }
    }
    std::vector<std::string> notes;
    const OpenedProject project = salvaged(&notes);
    ASSERT_EQ(project.problem.english(), "");
    EXPECT_EQ(project.history.count(), 4) << "0, 1, 2 and 5";
    EXPECT_EQ(writeDesign(project.design), writeDesign(designs[5]));
    const std::vector<std::string> wanted = {
        "4 versions were saved", "lost: versions 3 to 4",
        "the edit of version 3 does not lead to the design that was kept with it"};
    EXPECT_EQ(notes, wanted);
}

TEST_F(SalvageTest, MessagesNameTheFileOfTheUser)
{
    make(3);
    change("DELETE FROM node; DELETE FROM snapshot");
    const Salvaged nothing = salvageProject(path("a.bolster"), path("out.bolster"));
    EXPECT_EQ(nothing.problem.english(), "nothing in \"" + path("a.bolster").toStdString() + "\" can be saved");
    const Salvaged folder = salvageProject(path("a.bolster"), path("none/out.bolster"));
    EXPECT_NE(folder.problem.english().find("none/out.bolster"), std::string::npos) << folder.problem.english();
    EXPECT_EQ(QDir(m_folder.path()).entryList({".bolster-*"}, QDir::Files | QDir::Hidden).size(), 0);
}

TEST_F(SalvageTest, WhatNeedsTooMuchEndsInItsOwnProcess)
{
    std::string many = cborList(30'000'000);
    for (int i = 0; i < 12'000'000; ++i)
        many.append("\x84\x01\x60\xf6\xf6", 5);
    const std::string bomb = packed(many);
    {
        CraftedProject crafted(path("a.bolster"));
        crafted.node(-1, Design(), smallDesign());
        crafted.node(0, bomb, {});
        crafted.snapshot(0, bomb);
    }
    const OpenedProject project = salvaged();
    EXPECT_EQ(project.problem.english(), "");
    EXPECT_EQ(project.history.count(), 1);
    EXPECT_EQ(writeDesign(project.design), writeDesign(smallDesign()));
}

} // namespace
} // namespace bolster::test
