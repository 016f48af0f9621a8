#include "WindowTest.h"

#include "FabricLink.h"
#include "MapLink.h"
#include "RenderDialog.h"

#include <QComboBox>
#include <QImage>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QSpinBox>

#include <cmath>

namespace bolster {
namespace {

class PicturesTest : public WindowTest {
protected:
    bool measured()
    {
        return QTest::qWaitFor([&] { return window.maps().map() != nullptr; }, 30000);
    }
    RenderDialog::Subject subject()
    {
        return {window.solver().surface(),
                window.document().design(),
                window.session().files(),
                window.fabricLink().baker(),
                window.fabricLink().bakedByNow(),
                window.session().title(),
                window.coverView().navigation().camera()};
    }
    static void setSize(const RenderDialog& dialog, int width, int height)
    {
        const QList<QSpinBox*> boxes = dialog.findChildren<QSpinBox*>();
        ASSERT_GE(boxes.size(), 2);
        boxes[0]->setValue(width);
        boxes[1]->setValue(height);
    }

    QTemporaryDir m_folder;
};

TEST_F(PicturesTest, AMapShowsItsNumbersAndWorstSpots)
{
    ASSERT_TRUE(open(sample("car-seat")));
    ASSERT_TRUE(waitUntilSolved());
    map(CoverMap::Kind::Strain)->trigger();
    ASSERT_TRUE(measured());
    const ShownMapPtr shown = window.maps().map();
    EXPECT_EQ(shown->values.size(), window.solver().surface()->positions.size());
    ASSERT_FALSE(window.maps().spots().empty());
    const MapLink::Spot& worst = window.maps().spots().front();
    EXPECT_TRUE(worst.text.contains(u'%')) << worst.text.toStdString();
    EXPECT_TRUE(MapLink::reading(*shown, worst.place).contains(u'%'));

    auto* spots = window.menuBar()->findChild<QMenu*>(QStringLiteral("map.worst"));
    ASSERT_TRUE(spots);
    emit spots->aboutToShow();
    EXPECT_EQ(spots->actions().size(), static_cast<qsizetype>(window.maps().spots().size()));
    spots->actions().front()->trigger();

    map(CoverMap::Kind::Curvature)->trigger();
    EXPECT_FALSE(map(CoverMap::Kind::Strain)->isChecked()) << "one map at a time";
    ASSERT_TRUE(measured());
    EXPECT_TRUE(window.maps().spots().empty());
    map(CoverMap::Kind::Curvature)->trigger();
    EXPECT_FALSE(window.maps().map()) << "and none on wish";
}

TEST_F(PicturesTest, RenderShowsAPreviewAndWritesTheFile)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    RenderDialog dialog(subject());
    QSignalSpy previews(&dialog, &RenderDialog::previewed);
    dialog.show();
    ASSERT_TRUE(previews.wait(30000));
    setSize(dialog, 64, 64);
    QSignalSpy ends(&dialog, &RenderDialog::rendered);
    const QString path = m_folder.filePath(QStringLiteral("picture.png"));
    dialog.renderTo(path);
    ASSERT_TRUE(ends.wait(60000));
    EXPECT_EQ(ends.front().front().toString(), QString());
    EXPECT_EQ(QImage(path).size(), QSize(64, 64));

    dialog.renderTo(m_folder.filePath(QStringLiteral("picture.jpg")));
    EXPECT_NE(ends.back().front().toString(), QString()) << "a kind of file that is not written";
    ends.clear();
    dialog.renderTo(m_folder.filePath(QStringLiteral("missing/picture.png")));
    ASSERT_TRUE(ends.wait(60000));
    EXPECT_NE(ends.back().front().toString(), QString()) << "a folder that is not there";
}

TEST_F(PicturesTest, RenderGoesAroundTheCoverAndPutsColourwaysOnASheet)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    Design design = window.document().design();
    for (const char* const name : {"Black", "Cognac"})
        design = design.with({{}, {{design.nextId(), nullptr, makeElement(Colourway{name, {}})}}});
    RenderDialog::Subject all = subject();
    all.design = design;
    RenderDialog dialog(std::move(all));
    dialog.show();
    const QList<QSpinBox*> boxes = dialog.findChildren<QSpinBox*>();
    ASSERT_EQ(boxes.size(), 3);
    setSize(dialog, 64, 48);
    boxes[2]->setValue(3);
    QSignalSpy ends(&dialog, &RenderDialog::rendered);
    dialog.renderTo(m_folder.filePath(QStringLiteral("turn.png")));
    ASSERT_TRUE(ends.wait(60000));
    EXPECT_EQ(ends.back().front().toString(), QString());
    for (const char* const name : {"turn-001.png", "turn-002.png", "turn-003.png"})
        EXPECT_EQ(QImage(m_folder.filePath(QLatin1String(name))).size(), QSize(64, 48)) << name;

    auto* shown = dialog.findChild<QComboBox*>(QStringLiteral("shown"));
    ASSERT_TRUE(shown);
    const int sheet = shown->findText(QStringLiteral("All colourways on a sheet"));
    ASSERT_GE(sheet, 0);
    shown->setCurrentIndex(sheet);
    dialog.renderTo(m_folder.filePath(QStringLiteral("sheet.png")));
    ASSERT_TRUE(ends.wait(60000));
    EXPECT_EQ(ends.back().front().toString(), QString());
    EXPECT_EQ(QImage(m_folder.filePath(QStringLiteral("sheet.png"))).width(), 128);
}

TEST_F(PicturesTest, ARenderCanBeCancelled)
{
    ASSERT_TRUE(open(sample("trapezoid")));
    ASSERT_TRUE(waitUntilSolved());
    RenderDialog dialog(subject());
    dialog.show();
    setSize(dialog, 5000, 5000);
    const QString path = m_folder.filePath(QStringLiteral("large.png"));
    dialog.renderTo(path);
    EXPECT_TRUE(dialog.rendering());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.rendering());
    EXPECT_TRUE(dialog.isVisible()) << "the first Escape ends the picture, not the dialog";
    setSize(dialog, 64, 64);
    QSignalSpy next(&dialog, &RenderDialog::rendered);
    dialog.renderTo(m_folder.filePath(QStringLiteral("small.png"))); // begins when the large one has ended
    ASSERT_TRUE(next.wait(60000));
    EXPECT_FALSE(QFile::exists(path));
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
}

} // namespace
} // namespace bolster
