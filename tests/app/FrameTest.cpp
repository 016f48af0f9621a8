// Frames in the window: cushions that fit them, and parts of them that are left out.
#include "Commands.h"
#include "MeshImport.h"
#include "StatusLine.h"
#include "WindowTest.h"

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTreeWidget>

namespace bolster {
namespace {

class FrameTest : public WindowTest {
protected:
    ElementId addFrame(const std::string& obj, double scale)
    {
        const QString path = m_folder.filePath(QStringLiteral("sofa.obj"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(obj.data(), static_cast<qint64>(obj.size()));
        file.close();
        Frame frame;
        frame.scale = scale;
        frame.name = "Sofa";
        EXPECT_TRUE(window.session().addWithFile(path, {importMesh(path).mesh, nullptr}, frame).empty());
        return *window.selection().elements().begin();
    }

    /// With every face a second time, the other way round, if `twice`.
    static std::string box(double size, bool twice)
    {
        std::string text;
        for (const int k : {0, 1, 2, 3, 4, 5, 6, 7})
            text += "v " + std::to_string(k & 1 ? size : 0) + " " + std::to_string(k & 2 ? size : 0) + " " +
                    std::to_string(k & 4 ? size : 0) + "\n";
        for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
            text += std::string("f ") + face + "\n";
        if (twice)
            for (const char* face : {"2 4 3 1", "7 8 6 5", "5 6 2 1", "4 8 7 3", "3 7 5 1", "6 8 4 2"})
                text += std::string("f ") + face + "\n";
        return text;
    }

    const Cushion* cushion()
    {
        const Cushion* found = nullptr;
        window.document().design().each<Cushion>([&](ElementId, const Cushion& c) { found = &c; });
        return found;
    }

    bool says(const QString& text)
    {
        const auto labels = window.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(text); });
    }

    QTemporaryDir m_folder;
};

TEST_F(FrameTest, TheCushionOfALargeFrameHasVoxelsThatFitAndSaysSo)
{
    addFrame(box(2.7, false), 1000);
    QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(cushion());
    EXPECT_GT(cushion()->voxel, 5);
    EXPECT_TRUE(says(QStringLiteral("smallest detail is set to"))) << "in the status line";
    EXPECT_TRUE(says(QStringLiteral("This frame is large"))) << "in the inspector";
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(cushion()) << "one edit";
}

TEST_F(FrameTest, EdgesAreOfferedWhenThereAreAny)
{
    EXPECT_FALSE(window.commands()["frame.fix-edge"]->isEnabled());
    addFrame(box(500, false), 1);
    QAction* const command = window.commands()["frame.fix-edge"];
    EXPECT_TRUE(command->isEnabled());
    command->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.coverView().tool() == CoverToolKind::FixEdge; }, 30000));
    EXPECT_TRUE(command->isChecked());
    command->trigger();
    EXPECT_EQ(window.coverView().tool(), CoverToolKind::Select);
}

TEST_F(FrameTest, TheCushionOfAChairHasTheUsualVoxels)
{
    addFrame(box(0.9, false), 1000);
    QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(cushion());
    EXPECT_EQ(cushion()->voxel, 5);
    EXPECT_FALSE(says(QStringLiteral("smallest detail is set to")));
    EXPECT_FALSE(says(QStringLiteral("This frame is large")));
}

TEST_F(FrameTest, ACushionWithoutVoxelsIsAProblemAndOneOfADoubleSidedFrameIsNot)
{
    ASSERT_TRUE(open(sample(QStringLiteral("box-cushion"))));
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window)) << "what says that it is read may have had the keyboard";
    const auto problems = [&] {
        QStringList found;
        for (const Problem& problem : window.solver().status().problems)
            if (problem.field == "voxel_mm")
                found << QString::fromStdString(problem.english());
        return found;
    };
    addFrame(box(300, true), 1);
    QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(cushion());
    ASSERT_TRUE(waitUntilSolved());
    EXPECT_TRUE(problems().isEmpty()) << problems().join(u'\n').toStdString();
    ASSERT_EQ(window.solver().report().cushions.size(), 1u);
    EXPECT_GT(window.solver().report().cushions[0].voxels, 1000);

    const ElementId sheet = addFrame("v 0 0 0\nv 400 0 0\nv 400 400 0\nv 0 400 0\nf 1 2 3 4\nf 4 3 2 1\n", 1);
    window.selection().set({sheet});
    QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return problems().size() == 1; }, 60000));
    EXPECT_TRUE(problems().join(u' ').contains(QStringLiteral("no inside")));
}

TEST_F(FrameTest, APartIsHiddenInTheListAndComesBackWithUndo)
{
    const ElementId id =
        addFrame("o Seat\n" + box(500, false) + "o Pillow\nv 0 0 600\nv 100 0 600\nv 0 100 600\nf 9 10 11\n", 1);
    window.selection().set({id});
    QTreeWidget* list = nullptr;
    const auto find = [&] {
        list = nullptr;
        for (QTreeWidget* tree : window.findChildren<QTreeWidget*>())
            if (tree->accessibleName() == QStringLiteral("Parts"))
                list = tree;
        return list != nullptr;
    };
    ASSERT_TRUE(QTest::qWaitFor(find));
    ASSERT_EQ(list->topLevelItemCount(), 2);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->topLevelItem(1)).topLeft() + QPoint(10, 8));
    const auto hidden = [&] { return window.document().design().find<Frame>(id)->hiddenParts; };
    EXPECT_EQ(hidden(), std::vector<std::string>{"Pillow"});
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(hidden().empty());
}

TEST_F(FrameTest, APieceIsLeftOutWhereItIsClicked)
{
    const ElementId id =
        addFrame("o Seat\n" + box(500, false) + "o Pillow\nv 0 0 600\nv 500 0 600\nv 0 500 900\nf 9 10 11\n", 1);
    CoverView& view = window.coverView();
    window.command("view.fit-all")->trigger();
    const auto pixelOf = [&](const Vec3& place) {
        const auto pixel = view.navigation().camera().pixel(place);
        return pixel ? QPoint(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())) : QPoint();
    };
    const auto menuAt = [&](const Vec3& place) {
        EXPECT_TRUE(QTest::qWaitFor([&] { return view.hit(pixelOf(place)).kind == CoverHit::Kind::Frame; }));
        QTest::mouseClick(&view, Qt::RightButton, {}, pixelOf(place));
        QMenu* menu = nullptr;
        (void)QTest::qWaitFor([&] { return (menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())); });
        return menu;
    };
    QMenu* menu = menuAt({150, 150, 690});
    ASSERT_TRUE(menu);
    auto* hide = menu->findChild<QAction*>(QStringLiteral("hide-frame-piece"));
    ASSERT_TRUE(hide);
    hide->trigger();
    menu->close();
    const auto hidden = [&] { return window.document().design().find<Frame>(id)->hiddenParts; };
    EXPECT_EQ(hidden(), std::vector<std::string>{"Pillow"});

    menu = menuAt({250, 0, 250}); // now the seat, the first of what is shown
    ASSERT_TRUE(menu);
    hide = menu->findChild<QAction*>(QStringLiteral("hide-frame-piece"));
    ASSERT_TRUE(hide);
    hide->trigger();
    menu->close();
    EXPECT_EQ(hidden(), (std::vector<std::string>{"Seat", "Pillow"}));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(hidden(), std::vector<std::string>{"Pillow"});
}

} // namespace
} // namespace bolster
