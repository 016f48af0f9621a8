// The library of fabrics and the colourways, through the window.
#include "WindowTest.h"

#include "ColourwayEdits.h"
#include "ColourwayWindow.h"
#include "Designer.h"
#include "ElementEdits.h"
#include "FabricCommands.h"
#include "FabricLink.h"
#include "FabricPanel.h"
#include "FabricPresets.h"
#include "FabricShown.h"
#include "Inspector.h"
#include "PictureStrip.h"

#include <QComboBox>
#include <QDropEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>

namespace bolster {
namespace {

class FabricTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        Docks::reveal(window.docks().fabrics);
    }

    const Design& design() { return window.document().design(); }
    template <class T>
    std::vector<ElementId> all()
    {
        std::vector<ElementId> ids;
        design().each<T>([&](ElementId id, const T&) { ids.push_back(id); });
        return ids;
    }
    ElementId preset(int number)
    {
        const ElementId id = design().nextId();
        window.fabricCommands().add(fabricPresets()[static_cast<std::size_t>(number)]);
        return id;
    }
    bool baked()
    {
        return QTest::qWaitFor([&] { return window.fabricLink().upToDate(); }, 120000);
    }

    /// Where a patch's middle is in the pattern.
    QPoint middle(ElementId patch)
    {
        const Patch& found = *design().find<Patch>(patch);
        Vec2 sum = Vec2::Zero();
        for (const Vec2& p : found.outline.points())
            sum += toLayout(found, p);
        return patternPixel(sum / found.outline.pointCount());
    }

    /// What the library hands over when a fabric is dragged, entered and let go over a view.
    bool drop(QWidget& view, QPoint at, ElementId fabric)
    {
        QMimeData data;
        data.setData(FabricPanel::mimeType(), QByteArray::number(static_cast<int>(fabric)));
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &enter);
        QDragMoveEvent over(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &over);
        QDropEvent end(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&view, &end);
        return end.isAccepted();
    }

    /// The next input dialog gets a text, or is cancelled.
    void answerInput(const std::optional<QString>& text)
    {
        auto* timer = new QTimer(qApp);
        QObject::connect(timer, &QTimer::timeout, timer, [this, timer, text] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            if (!dialog)
                return;
            timer->stop();
            timer->deleteLater();
            if (text)
                dialog->setTextValue(*text);
            text ? dialog->accept() : dialog->reject();
            ++m_inputs;
        });
        timer->start(20);
    }
    bool inputAnswered()
    {
        return QTest::qWaitFor([&] { return std::exchange(m_inputs, 0) == 1; }, 20000);
    }
    int m_inputs = 0; ///< answered, and not asked for yet

    /// A picture with stripes, 60 x 40 pixels.
    static QString writePicture(const QString& path)
    {
        QImage image(60, 40, QImage::Format_RGB32);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x)
                image.setPixelColor(x, y, x / 10 % 2 ? QColor(20, 60, 160) : QColor(230, 220, 200));
        return image.save(path) ? path : QString();
    }
};

TEST_F(FabricTest, PresetsAreDrawnWhenTheirMenuIsSeen)
{
    QMenu* menu = window.command("fabric.new")->menu();
    const QAction* first = menu->actions().front();
    waitUntilLaidOut();
    waitForBackground();
    EXPECT_TRUE(first->icon().isNull()) << "nobody has asked for them";
    menu->popup(window.mapToGlobal(QPoint(100, 100)));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !first->icon().isNull(); }, 30000));
    menu->close();
}

TEST_F(FabricTest, PresetsAreBakedAndShownInTheLibrary)
{
    ASSERT_GE(fabricPresets().size(), 12U);
    const ElementId leather = preset(0);
    EXPECT_EQ(window.fabricPanel().fabric(), leather) << "what is new is chosen";
    ASSERT_TRUE(baked());
    const QImage picture = window.fabricLink().pictures()[leather].cushion;
    ASSERT_FALSE(picture.isNull());
    const QColor middle = picture.pixelColor(picture.width() / 2, picture.height() / 2);
    EXPECT_GT(middle.red(), middle.blue() + 30) << "cognac";
    EXPECT_TRUE(window.fabricLink().maps().at(leather)->complete());
    EXPECT_EQ(window.fabricPanel().fabrics().count(), static_cast<int>(all<Fabric>().size()));
    window.command("edit.undo")->trigger();
    EXPECT_FALSE(design().find<Fabric>(leather));
    EXPECT_EQ(window.fabricPanel().fabrics().count(), static_cast<int>(all<Fabric>().size()));
}

TEST_F(FabricTest, AFabricDroppedOnAPatchOfThePatternIsWhatItIsMadeOf)
{
    const ElementId leather = preset(0), patch = all<Patch>().front();
    ASSERT_TRUE(drop(window.patternView(), middle(patch), leather));
    EXPECT_EQ(design().find<Patch>(patch)->fabric, leather);
    window.command("edit.undo")->trigger();
    EXPECT_NE(design().find<Patch>(patch)->fabric, leather);
    EXPECT_FALSE(drop(window.patternView(), {2, 2}, leather)) << "beside everything";
}

TEST_F(FabricTest, AFabricDroppedOnTheCoverIsWhatThePatchIsMadeOf)
{
    const ElementId leather = preset(0);
    ASSERT_TRUE(waitUntilSolved());
    CoverView& view = window.coverView();
    view.navigation().setCamera(view.navigation().camera()); // it may still be on its way to the cover
    const QPoint at = view.rect().center();
    const ElementId patch = view.hit(at).element;
    ASSERT_TRUE(design().find<Patch>(patch));
    ASSERT_TRUE(drop(view, at, leather));
    EXPECT_EQ(design().find<Patch>(patch)->fabric, leather);
}

TEST_F(FabricTest, SelectedPatchesGetWhatIsChosenInTheLibrary)
{
    const ElementId weave = preset(5);
    EXPECT_FALSE(window.command("fabric.assign")->isEnabled());
    const std::vector<ElementId> patches = all<Patch>();
    window.selection().set({patches[0], patches[1]});
    EXPECT_TRUE(window.command("fabric.assign")->isEnabled());
    window.command("fabric.assign")->trigger();
    EXPECT_EQ(design().find<Patch>(patches[0])->fabric, weave);
    EXPECT_EQ(design().find<Patch>(patches[1])->fabric, weave);
    EXPECT_NE(design().find<Patch>(patches[2])->fabric, weave);
}

TEST_F(FabricTest, ColourwaysSwitchWithAClickAndChangeOnlyWhatIsSeen)
{
    const ElementId leather = preset(0), patch = all<Patch>().front();
    const ElementId own = design().find<Patch>(patch)->fabric;
    const std::size_t before = all<Colourway>().size();
    answerInput(QStringLiteral("Summer"));
    window.command("colourway.new")->trigger();
    ASSERT_TRUE(inputAnswered());
    const std::vector<ElementId> colourways = all<Colourway>();
    ASSERT_EQ(colourways.size(), before + 1);
    EXPECT_EQ(design().settings().colourway, colourways.back());
    ASSERT_TRUE(drop(window.patternView(), middle(patch), leather));
    EXPECT_EQ(design().find<Patch>(patch)->fabric, own);
    EXPECT_EQ(fabricShown(design(), patch), leather);

    QListWidget& list = window.fabricPanel().colourways();
    const int last = static_cast<int>(before) + 1;
    ASSERT_EQ(list.count(), last + 1);
    EXPECT_EQ(list.currentRow(), last);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(0)).center());
    EXPECT_EQ(design().settings().colourway, noElement);
    EXPECT_EQ(fabricShown(design(), patch), own);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(fabricShown(design(), patch), leather);
    EXPECT_EQ(list.currentRow(), last);

    window.command("colourway.compare")->trigger();
    auto* compared = window.findChild<ColourwayWindow*>();
    ASSERT_TRUE(compared);
    EXPECT_EQ(compared->choice(0).currentText(), QStringLiteral("As made"));
    EXPECT_EQ(compared->choice(1).currentText(), QStringLiteral("Summer"));
    compared->close();
    window.command("colourway.delete")->trigger();
    EXPECT_EQ(all<Colourway>().size(), before);
    EXPECT_EQ(list.count(), last);
}

TEST_F(FabricTest, AFabricInUseIsNotDeletedWithoutAsking)
{
    const ElementId leather = preset(0), patch = all<Patch>().front();
    ASSERT_TRUE(drop(window.patternView(), middle(patch), leather));
    window.selection().set({leather});
    answerInput(std::nullopt);
    window.command("edit.delete")->trigger();
    EXPECT_TRUE(inputAnswered());
    EXPECT_TRUE(design().find<Fabric>(leather));

    const ElementId velvet = preset(8);
    window.selection().set({leather});
    answerInput(QString::fromStdString(design().find<Fabric>(velvet)->name));
    window.command("fabric.delete")->trigger();
    EXPECT_TRUE(inputAnswered());
    EXPECT_FALSE(design().find<Fabric>(leather));
    EXPECT_EQ(design().find<Patch>(patch)->fabric, velvet);

    const ElementId spare = preset(3);
    window.selection().set({spare});
    window.command("fabric.delete")->trigger(); // nobody has it
    EXPECT_FALSE(design().find<Fabric>(spare));
}

TEST_F(FabricTest, APictureBecomesAFabric)
{
    QTemporaryDir folder;
    const QString path = writePicture(folder.filePath("stripes.png"));
    ASSERT_FALSE(path.isEmpty());
    const ElementId id = design().nextId();
    window.fabricCommands().choosePicture(noElement, path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return design().find<Fabric>(id) != nullptr; }, 60000));
    EXPECT_EQ(design().find<Fabric>(id)->name, "stripes");
    EXPECT_EQ(design().find<Fabric>(id)->look.kind, FabricLook::Kind::Image);
    ASSERT_TRUE(baked());
    const FabricMapsPtr maps = window.fabricLink().maps().at(id);
    EXPECT_EQ(maps->width, 60);
    EXPECT_DOUBLE_EQ(maps->widthMm, 200);
    EXPECT_TRUE(window.fabricLink().problems().empty());
}

TEST_F(FabricTest, APictureThatIsNoneIsRefusedWithTheReason)
{
    QTemporaryDir folder;
    QFile file(folder.filePath("wool.png"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("this is no picture");
    file.close();
    const std::size_t before = all<Fabric>().size();
    answer(QMessageBox::Ok);
    window.fabricCommands().choosePicture(noElement, file.fileName());
    EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 1; }, 60000));
    EXPECT_EQ(all<Fabric>().size(), before);
}

TEST_F(FabricTest, AFabricTravelsAsAFileWithItsPicture)
{
    QTemporaryDir from, to;
    const ElementId id = design().nextId();
    window.fabricCommands().choosePicture(noElement, writePicture(from.filePath("stripes.png")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return design().find<Fabric>(id) != nullptr; }, 60000));
    window.selection().set({id});
    const QString file = to.filePath("striped.json");
    window.fabricCommands().exportFabric(file);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return QFile::exists(file) && QFile::exists(to.filePath("striped.png")); }, 30000));

    const std::size_t before = all<Fabric>().size();
    window.fabricCommands().importFabrics(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return all<Fabric>().size() == before + 1; }, 60000));
    const Fabric& taken = *design().find<Fabric>(all<Fabric>().back());
    EXPECT_EQ(taken.look.scale, design().find<Fabric>(id)->look.scale);
    EXPECT_FALSE(window.session().findFile(QString::fromStdString(taken.look.file)).isEmpty());
    ASSERT_TRUE(baked());
    EXPECT_EQ(window.fabricLink().maps().at(all<Fabric>().back())->albedo,
              window.fabricLink().maps().at(id)->albedo);
}

TEST_F(FabricTest, ItsKindIsChangedInTheProperties)
{
    const ElementId plain = preset(11);
    window.selection().set({plain});
    QComboBox* kind = nullptr;
    for (QComboBox* box : window.inspector().findChildren<QComboBox*>())
        if (box->findText(QStringLiteral("Velvet")) >= 0)
            kind = box;
    ASSERT_TRUE(kind);
    kind->setFocus();
    kind->setCurrentIndex(kind->findText(QStringLiteral("Velvet")));
    emit kind->activated(kind->currentIndex());
    EXPECT_EQ(design().find<Fabric>(plain)->look.kind, FabricLook::Kind::Velvet);
    EXPECT_EQ(design().find<Fabric>(plain)->look.scale, usualLook(FabricLook::Kind::Velvet).scale);
    ASSERT_TRUE(baked());
    EXPECT_GT(window.fabricLink().maps().at(plain)->sheen, 0.5);
}

TEST_F(FabricTest, TheLibraryShowsCushionsOrBallsAsItWasLeft)
{
    const ElementId leather = preset(0);
    ASSERT_TRUE(baked());
    const QListWidgetItem& item = *window.fabricPanel().fabrics().currentItem();
    const auto icon = [&] { return item.icon().pixmap(84).toImage(); };
    auto* cushions =
        window.fabricPanel().findChild<QToolButton*>(window.command("fabric.on-cushions")->objectName());
    auto* balls = window.fabricPanel().findChild<QToolButton*>(window.command("fabric.on-balls")->objectName());
    ASSERT_TRUE(cushions && balls);
    EXPECT_TRUE(cushions->isChecked());
    EXPECT_EQ(icon().pixelColor(6, 6).alpha(), 255) << "the corner of a cushion";

    QTest::mouseClick(balls, Qt::LeftButton);
    EXPECT_FALSE(cushions->isChecked());
    EXPECT_TRUE(window.command("fabric.on-balls")->isChecked());
    EXPECT_EQ(icon().pixelColor(6, 6).alpha(), 0) << "beside a ball";
    EXPECT_EQ(icon().pixelColor(42, 42).alpha(), 255);
    EXPECT_EQ(window.fabricPanel().fabric(), leather) << "what is chosen stays";
    {
        MainWindow next;
        EXPECT_TRUE(next.command("fabric.on-balls")->isChecked());
    }
    QTest::mouseClick(cushions, Qt::LeftButton);
    EXPECT_EQ(icon().pixelColor(6, 6).alpha(), 255);
}

TEST_F(FabricTest, ItsPropertiesShowItAndFollowItsColour)
{
    const ElementId leather = preset(0);
    window.selection().set({leather});
    Docks::reveal(window.docks().inspector);
    ASSERT_TRUE(baked());
    const auto strip = [&] { return window.inspector().findChild<PictureStrip*>(); };
    const auto red = [&](std::size_t i) {
        const QImage& picture = strip()->pictures().at(i);
        return picture.isNull() ? 0 : picture.pixelColor(picture.rect().center()).red();
    };
    ASSERT_TRUE(strip());
    ASSERT_EQ(strip()->pictures().size(), 2U) << "a cushion and a ball";
    const int cushion = red(0), ball = red(1);
    EXPECT_GT(cushion, 100);
    EXPECT_GT(ball, 100);

    Fabric dark = *design().find<Fabric>(leather);
    dark.color = "#101820";
    window.document().commit(edits::replaceElement(design(), leather, makeElement(dark), {"Change"}));
    EXPECT_EQ(red(0), cushion) << "the old ones stay until it is baked";
    ASSERT_TRUE(baked());
    EXPECT_LT(red(0), cushion - 50);
    EXPECT_LT(red(1), ball - 50);

    window.selection().set({leather, preset(5)});
    EXPECT_FALSE(strip()) << "several have none";
}

} // namespace
} // namespace bolster
