// Of a damaged project everything is saved whose hashes are right, and what is lost is said.
#include "Salvage.h"
#include "DesignHash.h"
#include "TestProject.h"

#include <sqlite3.h>

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
    EXPECT_EQ(project.history.count(), sound);
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

} // namespace
} // namespace bolster::test
