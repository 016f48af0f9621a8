#include "DesignFile.h"
#include "DesignJson.h"
#include "TestFiles.h"

#include <QDir>

namespace bolster {
namespace {

const char* const triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string designWithFrame(const std::string& file, const std::string& scale = "100")
{
    return R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [)"
           R"({"id": 7, "kind": "frame", "name": "Armchair", "scale": )" +
           scale + R"(, "file": ")" + file + R"("}]})";
}

class DesignFileTest : public TestFiles {
protected:
    /// Opens a design with this frame and returns the problems of the frame's file.
    std::vector<std::string> frameProblems(const std::string& file, const std::string& scale = "100")
    {
        const OpenedDesign opened = openDesign(write("design.json", designWithFrame(file, scale)));
        EXPECT_TRUE(opened.readable);
        EXPECT_TRUE(opened.files.meshes.empty());
        std::vector<std::string> found;
        for (const Problem& problem : opened.problems)
            if (problem.element == ElementId{7} && problem.field == "file")
                found.push_back(problem.english());
        return found;
    }
};

TEST_F(DesignFileTest, SavesAndOpensTheSameDesign)
{
    const Design design =
        Design().with({{},
                       {{settingsId, nullptr, makeElement(Settings{7.5})},
                        {ElementId{1}, nullptr, makeElement(Fabric{.name = "Leather \"thick\""})}}});
    ASSERT_TRUE(saveDesign(design, path("a.json")).empty());
    const OpenedDesign opened = openDesign(path("a.json"));
    EXPECT_TRUE(opened.readable);
    EXPECT_TRUE(opened.problems.empty());
    EXPECT_TRUE(opened.design == design);
    EXPECT_EQ(read("a.json"), writeDesign(design));
}

TEST_F(DesignFileTest, ReadsTheFramesBesideTheDesign)
{
    write("chair.obj", triangle);
    QDir(m_folder.path()).mkdir("frames");
    write("frames/chair.obj", triangle);
    for (const char* file : {"chair.obj", "frames/chair.obj", "./chair.obj"}) {
        const OpenedDesign opened = openDesign(write("design.json", designWithFrame(file)));
        EXPECT_TRUE(opened.problems.empty()) << opened.problems.front().english();
        ASSERT_EQ(opened.files.meshes.count(ElementId{7}), 1u);
        EXPECT_EQ(opened.files.meshes.at(ElementId{7})->triangles.size(), 1u);
    }
}

TEST_F(DesignFileTest, LooksForFramesOfACopyBesideTheOriginal)
{
    QDir(m_folder.path()).mkdir("original");
    write("original/chair.obj", triangle);
    const OpenedDesign opened = openDesign(write("copy.json", designWithFrame("chair.obj")), path("original"));
    EXPECT_TRUE(opened.problems.empty());
    EXPECT_EQ(opened.files.meshes.size(), 1u);
}

TEST_F(DesignFileTest, FramesMayNotLeaveTheFolder)
{
    QDir(m_folder.path()).mkdir("inside");
    write("outside.obj", triangle);
    ASSERT_TRUE(QFile::link(path("outside.obj"), path("inside/link.obj")));
    ASSERT_TRUE(QFile::link(path("."), path("inside/up")));
    for (const QString& file : {QString("../outside.obj"), path("outside.obj"), QString("link.obj"),
                                QString("up/outside.obj"), QString("../inside/../outside.obj")}) {
        const OpenedDesign opened = openDesign(write("inside/design.json", designWithFrame(file.toStdString())));
        EXPECT_TRUE(opened.files.meshes.empty()) << file.toStdString();
        EXPECT_TRUE(hasErrors(opened.problems)) << file.toStdString();
    }
}

TEST_F(DesignFileTest, AMissingOrBrokenFrameIsAProblemOfItsFileAndLeavesTheRestUsable)
{
    const auto missing = frameProblems("chair.obj");
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_NE(missing[0].find("there is no file \"chair.obj\""), std::string::npos) << missing[0];
    EXPECT_NE(missing[0].find("Armchair"), std::string::npos);

    write("chair.obj", "v 0 0 0\nf 1 2 3\n");
    const auto broken = frameProblems("chair.obj");
    ASSERT_EQ(broken.size(), 1u);
    EXPECT_NE(broken[0].find("chair.obj:2"), std::string::npos) << broken[0];

    write("chair.obj", triangle);
    const auto huge = frameProblems("chair.obj", "9999999999");
    EXPECT_LE(huge.size(), 1u);
    write("chair.txt", triangle);
    EXPECT_EQ(frameProblems("chair.txt").size(), 1u);
}

TEST_F(DesignFileTest, ReadsScansAsPoints)
{
    const std::string text = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [)"
                             R"({"id": 7, "kind": "scan", "name": "Room", "file": "room.xyz"},)"
                             R"({"id": 8, "kind": "scan", "name": "None", "file": "none.ply"}]})";
    write("room.xyz", "1 2 3\n4 5 6\n");
    const OpenedDesign opened = openDesign(write("design.json", text));
    EXPECT_TRUE(opened.readable);
    ASSERT_EQ(opened.files.clouds.count(ElementId{7}), 1u);
    EXPECT_EQ(opened.files.clouds.at(ElementId{7})->points.size(), 2u);
    ASSERT_EQ(opened.problems.size(), 1u);
    EXPECT_EQ(opened.problems[0].element, ElementId{8});
    EXPECT_NE(opened.problems[0].english().find("there is no file \"none.ply\""), std::string::npos);
}

TEST_F(DesignFileTest, WhatCannotBeReadAtAllIsAProblemToo)
{
    for (const QString& file : {path("none.json"), m_folder.path(), write("bad.json", "{\"format\": "),
                                write("other.json", "[1, 2]"), write("empty.json", "")}) {
        const OpenedDesign opened = openDesign(file);
        EXPECT_FALSE(opened.readable);
        EXPECT_TRUE(hasErrors(opened.problems)) << file.toStdString();
    }
}

TEST_F(DesignFileTest, SavingReportsAndKeepsTheOldFile)
{
    EXPECT_FALSE(saveDesign(Design(), path("none/a.json")).empty());
    EXPECT_FALSE(saveDesign(Design(), m_folder.path()).empty());
}

} // namespace
} // namespace bolster
