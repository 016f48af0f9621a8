// The programs that are shipped are built so that a mistake in them is hard to use: read from the files themselves.
#include "Sanitizer.h"
#include "TestPaths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>

#include <map>

namespace bolster::test {
namespace {

std::string readElf(const QString& program)
{
    QProcess process;
    process.start("readelf", {"--wide", "--file-header", "--program-headers", "--dynamic", "--dyn-syms", program});
    EXPECT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitCode(), 0);
    return process.readAllStandardOutput().toStdString();
}

QStringList shippedPrograms()
{
    const QDir build(QFileInfo(QString::fromStdString(program())).absolutePath() + "/..");
    return {QString::fromStdString(program()),
            build.filePath("model/image/bolster-image"),
            build.filePath("model/assembly/bolster-cad"),
            build.filePath("model/assembly/bolster-scene"),
            build.filePath("model/project/bolster-salvage"),
            build.filePath("app/cli/bolster-bench")};
}

TEST(Hardening, ShippedProgramsAreHardened)
{
    for (const QString& program : shippedPrograms()) {
        ASSERT_TRUE(QFileInfo(program).isExecutable()) << program.toStdString();
        const std::string elf = readElf(program);
        const auto has = [&](const char* words) { return elf.find(words) != std::string::npos; };
        const std::string name = QFileInfo(program).fileName().toStdString();
        EXPECT_TRUE(has("DYN (Position-Independent Executable file)")) << name;
        EXPECT_TRUE(has("GNU_RELRO")) << name;
        EXPECT_TRUE(has("BIND_NOW") && has("Flags: NOW")) << name;
        EXPECT_FALSE(has("RWE")) << name << " has memory that can be written and run";
#if !defined(BOLSTER_ADDRESS_SANITIZER) && defined(NDEBUG)
        EXPECT_TRUE(has("__stack_chk_fail")) << name;
#endif
    }
}

TEST(Hardening, OnlyTheModuleBringsOpenImageIO)
{
    const QDir build(QFileInfo(QString::fromStdString(program())).absolutePath() + "/..");
    const char* const brought = "[libOpenImageIO.so";
    EXPECT_EQ(readElf(QString::fromStdString(program())).find(brought), std::string::npos)
        << "each start would wait for more than two hundred libraries";
    const std::string module = readElf(build.filePath("solver/look/painting/bolster-imaging.so"));
    EXPECT_NE(module.find(brought), std::string::npos);
    EXPECT_NE(module.find("GNU_RELRO"), std::string::npos);
}

#if !defined(BOLSTER_ADDRESS_SANITIZER) && defined(NDEBUG)
/// Few of our calls need a check, so it does not show in the programs: the commands that compiled them tell.
TEST(Hardening, EverythingShippedIsCompiledWithChecks)
{
    QFile file(QFileInfo(QString::fromStdString(program())).absolutePath() + "/../compile_commands.json");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    std::map<std::string, int> seen;
    for (const auto& entry : nlohmann::json::parse(file.readAll().toStdString())) {
        const std::string command = entry["command"];
        for (const char* part :
             {"bolster_document",     "bolster_readers",  "bolster_exchange",      "bolster_storage",
              "bolster_project",      "bolster_image",    "bolster_image_decoder", "bolster_cad_reader",
              "bolster_scene_reader", "bolster_confined", "bolster_assembly",      "bolster_salvager",
              "bolster_cli",          "bolster_terminal", "bolster_bench_program", "bolster_kinds",
              "bolster_schema",       "bolster_edits",    "bolster_live",          "bolster_widgets_views",
              "bolster_app",          "bolster"}) {
            if (command.find(std::string("/").append(part).append(".dir/")) == std::string::npos)
                continue;
            ++seen[part];
            EXPECT_NE(command.find("-fstack-protector-strong"), std::string::npos) << part;
            EXPECT_NE(command.find("-D_FORTIFY_SOURCE=2"), std::string::npos) << part;
            EXPECT_NE(command.find("-D_GLIBCXX_ASSERTIONS"), std::string::npos) << part;
        }
    }
    EXPECT_EQ(seen.size(), 22u);
}
#endif

} // namespace
} // namespace bolster::test
