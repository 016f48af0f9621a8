// Whatever happens to the bytes of a project file: it is noticed, or nothing that the project says has changed.
#include "TestProject.h"

#include <sqlite3.h>

namespace bolster::test {
namespace {

class DamageTest : public TestFiles {
protected:
    void SetUp() override
    {
        Document document;
        document.reset(smallDesign());
        const auto opened = Journal::create(path("journal"), document.committed());
        Hands hands(5);
        for (int i = 0; i < 40; ++i) {
            hands.step(document);
            expectFine(opened.journal->record(document.history(), document.committed()));
        }
        write("chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + std::string(20'000, '#'));
        std::string name = "chair.obj";
        expectFine(opened.journal->addAsset(name, path("chair.obj")));
        expectFine(opened.journal->setNames(2, "Two"));
        expectFine(opened.journal->save(path("a.bolster")));
        m_bytes = read("a.bolster");
        m_content = content(path("a.bolster"));
        ASSERT_NE(m_content, "");
    }

    /// All that the project says, or "" when it is refused.
    std::string content(const QString& file) const
    {
        const OpenedProject project = openProject(file, ProjectCheck::Everything);
        if (!project.problem.empty()) {
            EXPECT_NE(project.problem.english().find(file.toStdString()), std::string::npos)
                << project.problem.english();
            return {};
        }
        std::string text =
            writeDesign(project.design) + historyText(project.history) + std::to_string(project.saved.value_or(-1));
        for (const ProjectNode& node : project.nodes)
            text += hexText(node.designHash) + hexText(node.rowHash) + std::to_string(node.run) +
                    std::string(node.uid.begin(), node.uid.end());
        for (const auto& [name, blob] : project.assets)
            text += name;
        for (NodeId node = 0; node < project.history.count(); ++node)
            text += writeDesign(project.history.designAt(node, project.design).value());
        EXPECT_TRUE(extractAssets(project, project.design, m_quick.path()).empty());
        return text + readWholeFile(m_quick.filePath("chair.obj"), 1'000'000).bytes;
    }

    /// A new file each time: one that is cut and written again some file systems write to the disk at once.
    QString rewrite(const QString& name, std::string_view bytes) const
    {
        QFile::remove(path(name));
        return write(name, bytes);
    }

    QTemporaryDir m_quick{quickFolder()};
    std::string m_bytes;
    std::string m_content;
};

TEST_F(DamageTest, FlippedBitsAreNoticedOrChangeNothing)
{
    std::mt19937 random(1);
    int noticed = 0;
    const int wanted = rounds("BOLSTER_BIT_FLIPS", 2'000);
    QFile file(path("a.bolster"));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite | QIODevice::Unbuffered));
    const auto put = [&](std::size_t place, char byte) {
        ASSERT_TRUE(file.seek(static_cast<qint64>(place)) && file.putChar(byte));
    };
    for (int i = 0; i < wanted; ++i) {
        const std::size_t place = random() % m_bytes.size();
        put(place, static_cast<char>(m_bytes[place] ^ (1 << random() % 8)));
        const std::string found = content(file.fileName());
        noticed += found.empty();
        ASSERT_TRUE(found.empty() || found == m_content) << "byte " << place;
        put(place, m_bytes[place]);
    }
    std::printf("%d of %d flipped bits noticed, the others changed nothing\n", noticed, wanted);
    EXPECT_GT(noticed, wanted / 10);
}

TEST_F(DamageTest, EveryColumnOfEveryRowCounts)
{
    sqlite3* database = nullptr;
    const auto run = [&](const std::string& sql, std::vector<std::string>* rows = nullptr) {
        const auto row = [](void* list, int, char** values, char**) {
            static_cast<std::vector<std::string>*>(list)->emplace_back(values[0] ? values[0] : "");
            return 0;
        };
        ASSERT_EQ(sqlite3_exec(database, sql.c_str(), rows ? +row : nullptr, rows, nullptr), SQLITE_OK) << sql;
    };
    int changed = 0;
    for (const std::string table :
         {"project", "node", "label", "redo", "save_point", "asset", "blob", "chunk", "state"}) {
        std::vector<std::string> columns, keys;
        ASSERT_EQ(sqlite3_open(path("a.bolster").toUtf8(), &database), SQLITE_OK);
        run("SELECT name FROM pragma_table_info('" + table + "')", &columns);
        run("SELECT rowid FROM " + table, &keys);
        sqlite3_close(database);
        ASSERT_FALSE(columns.empty());
        EXPECT_TRUE(!keys.empty() || table == "redo");
        for (const std::string& key : keys) {
            for (const std::string& column : columns) {
                rewrite("changed.bolster", m_bytes);
                ASSERT_EQ(sqlite3_open(path("changed.bolster").toUtf8(), &database), SQLITE_OK);
                run("PRAGMA synchronous = OFF; UPDATE " + table + " SET " + column + " = CASE typeof(" + column +
                    ") WHEN 'integer' THEN " + column + " + 1000 WHEN 'text' THEN " + column +
                    " || 'x' WHEN 'blob' THEN CAST(" + column + " || x'00' AS BLOB) ELSE CASE '" + column +
                    "' WHEN 'parent' THEN 0 WHEN 'base' THEN zeroblob(32) "
                    "ELSE 'x' END END WHERE rowid = " +
                    key);
                sqlite3_close(database);
                EXPECT_EQ(content(path("changed.bolster")), "") << table << " " << key << " " << column;
                ++changed;
            }
            rewrite("changed.bolster", m_bytes);
            ASSERT_EQ(sqlite3_open(path("changed.bolster").toUtf8(), &database), SQLITE_OK);
            run("PRAGMA synchronous = OFF; DELETE FROM " + table + " WHERE rowid = " + key);
            sqlite3_close(database);
            EXPECT_EQ(content(path("changed.bolster")), "") << table << " without " << key;
        }
    }
    EXPECT_GT(changed, 250);
}

TEST_F(DamageTest, ForeignTablesAndViewsAreRefused)
{
    for (const char* sql :
         {"CREATE TABLE more(a)", "CREATE VIEW v AS SELECT 1", "CREATE INDEX i ON node(verb)",
          "CREATE TRIGGER t AFTER INSERT ON node BEGIN SELECT 1; END", "DROP TABLE thumbnail",
          "ALTER TABLE label ADD COLUMN more ANY", "DROP TABLE node; CREATE VIEW node AS SELECT 1"}) {
        rewrite("changed.bolster", m_bytes);
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(path("changed.bolster").toUtf8(), &database), SQLITE_OK);
        ASSERT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(database);
        EXPECT_EQ(content(path("changed.bolster")), "") << sql;
    }
}

TEST_F(DamageTest, WhateverLiesBesideTheFileIsNotLookedAt)
{
    write("a.bolster-journal", m_bytes);
    write("a.bolster-wal", m_bytes);
    EXPECT_EQ(content(path("a.bolster")), m_content);
    EXPECT_EQ(read("a.bolster"), m_bytes);
    EXPECT_EQ(read("a.bolster-wal"), m_bytes);
}

TEST_F(DamageTest, CutFilesAreNoticed)
{
    for (std::size_t length = 0; length < m_bytes.size(); length += 2048)
        EXPECT_EQ(content(rewrite("cut.bolster", m_bytes.substr(0, length))), "") << length;
    EXPECT_EQ(content(rewrite("long.bolster", m_bytes + m_bytes)), "");
}

} // namespace
} // namespace bolster::test
