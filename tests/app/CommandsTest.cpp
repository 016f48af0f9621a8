// The table of commands: ids for good, and what was kept under those of before.
#include "WindowTest.h"

#include "CommandList.h"
#include "TestPaths.h"

#include <QFile>
#include <QMenuBar>
#include <QSettings>

namespace bolster {
namespace {

class CommandsTest : public WindowTest {
protected:
    void TearDown() override
    {
        QSettings().remove(QStringLiteral("shortcuts"));
        WindowTest::TearDown();
    }
};

/// All that had an id made of its English text, and its id since.
const std::pair<const char*, const char*> formerIds[] = {
    {"about-bolster", "help.about"},
    {"arrange-automatically", "layout.arrange"},
    {"as-the-system", "view.theme-system"},
    {"assign-to-selection", "fabric.assign"},
    {"attach-to-fixation-curve", "tool.attach"},
    {"back", "view.from-back"},
    {"bottom", "view.from-bottom"},
    {"bottom-edges", "layout.align-bottom"},
    {"box-of-foam", "insert.foam-box"},
    {"c0-an-edge", "seam.continuity-c0"},
    {"c1-smooth-texture-too", "seam.continuity-c1"},
    {"centres-in-a-column", "layout.align-column"},
    {"centres-in-a-row", "layout.align-row"},
    {"checker", "layer.checker"},
    {"choose-another-file", "scan.replace"},
    {"compare-colourways", "colourway.compare"},
    {"control-points", "layer.points"},
    {"copy", "edit.copy"},
    {"create-fixation-curve", "fixation.create"},
    {"cushion", "insert.cushion"},
    {"cushioning", "layer.field"},
    {"cut", "edit.cut"},
    {"cut-away", "scan.cut"},
    {"cylinder-of-foam", "insert.foam-cylinder"},
    {"dark", "view.theme-dark"},
    {"delete", "edit.delete"},
    {"delete-colourway", "colourway.delete"},
    {"delete-fabric", "fabric.delete"},
    {"deviation-from-the-scan", "map.deviation"},
    {"distance-to-the-frame", "map.thickness"},
    {"draw-ellipse", "tool.ellipse"},
    {"draw-fancy-seam", "tool.fancy-seam"},
    {"draw-fixation-curve", "tool.draw-fixation"},
    {"draw-handle-curve", "tool.handle-curve"},
    {"draw-outline", "tool.outline"},
    {"draw-rectangle", "tool.rectangle"},
    {"duplicate", "edit.duplicate"},
    {"duplicate-fabric", "fabric.duplicate"},
    {"edge-length", "shape.edge-length"},
    {"edit-shortcuts", "help.edit-shortcuts"},
    {"export-fabric", "fabric.export"},
    {"export-picture", "file.export-picture"},
    {"export-surface", "file.export-surface"},
    {"fabric-properties", "fabric.edit"},
    {"fancy-seams", "layer.fancy-seams"},
    {"figures", "surface.figures"},
    {"find-a-command", "help.find-command"},
    {"fixation-curves", "layer.curves"},
    {"flip", "seam.flip"},
    {"frame", "layer.frames"},
    {"from-a-picture", "fabric.new-from-picture"},
    {"front", "view.from-front"},
    {"g1-rounded", "seam.continuity-g1"},
    {"grid", "layer.grid"},
    {"ground", "layer.ground"},
    {"guides", "draw.guides"},
    {"handle-curves", "layer.handles"},
    {"hide-selected", "view.hide"},
    {"horizontally", "layout.distribute-horizontally"},
    {"import-fabrics", "fabric.import"},
    {"import-frame", "file.import-frame"},
    {"import-scan", "file.import-scan"},
    {"isolate-selected", "view.isolate"},
    {"keep-around-the-cover", "scan.keep-around-cover"},
    {"keep-only", "scan.keep"},
    {"keys-and-mouse", "help.keys"},
    {"labels", "layer.labels"},
    {"largest-strain", "map.strain"},
    {"left", "view.from-left"},
    {"left-edges", "layout.align-left"},
    {"light", "view.theme-light"},
    {"link-as-twins", "twin.link"},
    {"link-the-views", "view.link"},
    {"make-corner", "shape.make-corner"},
    {"make-equally-long", "shape.equal-lengths"},
    {"make-mirror-twin", "twin.make"},
    {"make-smooth", "shape.make-smooth"},
    {"match-by-length", "seam.match-length"},
    {"match-by-parameter", "seam.match-parameter"},
    {"mean-curvature", "map.curvature"},
    {"measure", "tool.measure"},
    {"merge-along-seam", "shape.merge-patches"},
    {"mirror-horizontally", "layout.mirror-horizontally"},
    {"mirror-image-of-the-selection", "layer.twins"},
    {"mirror-vertically", "layout.mirror-vertically"},
    {"move", "background.move"},
    {"name-this-branch", "edit.name-branch"},
    {"new", "file.new"},
    {"new-colourway", "colourway.new"},
    {"next-part-of-the-window", "window.next-part"},
    {"on-balls", "fabric.on-balls"},
    {"on-cushions", "fabric.on-cushions"},
    {"opacity-100", "background.opacity-100"},
    {"opacity-30", "background.opacity-30"},
    {"opacity-60", "background.opacity-60"},
    {"open", "file.open"},
    {"open-picture", "background.open"},
    {"own-colours-of-scans", "layer.scan-colors"},
    {"pairs-of-cover-and-scan", "layer.scan-pairs"},
    {"paste", "edit.paste"},
    {"pause", "surface.pause"},
    {"perspective", "view.perspective"},
    {"picture-on-the-fabric", "fabric.picture"},
    {"place-on-the-cover", "scan.place"},
    {"previous-part-of-the-window", "window.previous-part"},
    {"quit", "file.quit"},
    {"re-link-points-to-the-twin", "twin.relink-points"},
    {"redo", "edit.redo"},
    {"release-points-from-the-twin", "twin.release-points"},
    {"remove", "background.remove"},
    {"remove-all-cuts", "scan.remove-cuts"},
    {"remove-all-guides", "draw.remove-guides"},
    {"rename", "edit.rename"},
    {"rename-colourway", "colourway.rename"},
    {"rename-fabric", "fabric.rename"},
    {"render-picture", "file.render-picture"},
    {"reset-layout", "window.reset-layout"},
    {"revert-to-saved", "file.revert"},
    {"right", "view.from-right"},
    {"right-edges", "layout.align-right"},
    {"rulers", "draw.rulers"},
    {"save", "file.save"},
    {"save-as", "file.save-as"},
    {"save-view", "view.save"},
    {"scale-by-two-points", "background.scale"},
    {"scans", "layer.scans"},
    {"seams-and-fixations", "layer.seams"},
    {"section", "view.section"},
    {"select-all-patches", "edit.select-all"},
    {"select-and-move", "tool.select"},
    {"select-nothing", "edit.select-nothing"},
    {"select-with-a-loop", "draw.lasso"},
    {"sew", "tool.sew"},
    {"shear", "map.shear"},
    {"show", "background.show"},
    {"show-all", "view.fit-all"},
    {"show-cover", "window.show-cover"},
    {"show-elements", "window.show-elements"},
    {"show-fabrics", "window.show-fabrics"},
    {"show-hidden-again", "view.show-hidden"},
    {"show-history", "window.show-history"},
    {"show-inspector", "window.show-inspector"},
    {"show-pattern", "window.show-pattern"},
    {"show-problems", "window.show-problems"},
    {"show-seam-list", "seam.list"},
    {"show-seams", "window.show-seams"},
    {"show-selection", "view.fit-selection"},
    {"show-spots", "window.show-spots"},
    {"show-worst-spots-as-a-list", "map.spot-list"},
    {"snapping", "draw.snapping"},
    {"sphere-of-foam", "insert.foam-sphere"},
    {"split-patch", "tool.split"},
    {"stitch-or-pipe-a-seam", "tool.trim"},
    {"straighten", "shape.straighten"},
    {"strain-across-the-grain", "map.across"},
    {"strain-along-the-grain", "map.along"},
    {"swap-sides", "seam.swap-sides"},
    {"symmetry", "twin.symmetry"},
    {"symmetry-axis-and-plane", "layer.symmetry"},
    {"three-quarter", "view.from-three-quarter"},
    {"top", "view.from-top"},
    {"top-edges", "layout.align-top"},
    {"triangulation", "layer.mesh"},
    {"turn-90-to-the-left", "layout.turn-left"},
    {"turn-90-to-the-right", "layout.turn-right"},
    {"undo", "edit.undo"},
    {"unlink-twins", "twin.unlink"},
    {"vertically", "layout.distribute-vertically"},
    {"with-everything", "file.copy-everything"},
    {"without-history", "file.copy-without-history"},
    {"without-history-and-scans", "file.copy-without-scans"},
};

TEST_F(CommandsTest, KeysKeptUnderFormerIdsAreCarriedOverOnce)
{
    QSettings settings;
    int n = 0;
    for (const auto& [former, now] : formerIds)
        settings.setValue(QStringLiteral("shortcuts/") + former, QStringLiteral("Ctrl+Alt+F%1").arg(1 + n++ % 30));
    MainWindow again;
    n = 0;
    for (const auto& [former, now] : formerIds) {
        const QString keys = QStringLiteral("Ctrl+Alt+F%1").arg(1 + n++ % 30);
        EXPECT_EQ(again.command(now)->shortcut(), QKeySequence(keys)) << former;
        EXPECT_EQ(settings.value(QStringLiteral("shortcuts/") + now).toString(), keys) << now;
        EXPECT_FALSE(settings.contains(QStringLiteral("shortcuts/") + former)) << former;
    }
    settings.setValue(QStringLiteral("shortcuts/flip"), QStringLiteral("Alt+Y"));
    MainWindow third;
    EXPECT_EQ(third.command("seam.flip")->shortcut(), again.command("seam.flip")->shortcut())
        << "what the user has chosen since stays";
}

TEST_F(CommandsTest, NoneThatIsAskedForIsMissing)
{
    const QList<QAction*> listed = window.commands().all();
    for (QAction* action : window.commands().findChildren<QAction*>(Qt::FindDirectChildrenOnly)) {
        EXPECT_TRUE(listed.contains(action)) << action->objectName().toStdString();
        EXPECT_TRUE(action->objectName().contains(u'.')) << action->objectName().toStdString();
    }
}

/// Each command that has keys, menu by menu.
QString keysDocument(const QMenuBar& menus)
{
    QString text = QStringLiteral("# Keys\n\n"
                                  "Every command has keys of your choice: Help > Edit shortcuts. These are those "
                                  "that it has at first. The id "
                                  "is what the\nsettings know it by.\n\n"
                                  "| command | menu | keys | id |\n|---|---|---|---|\n");
    for (const MenuEntry& entry : commandsOf(menus)) {
        const QList<QKeySequence> keys = entry.action->shortcuts();
        if (keys.isEmpty() || !entry.action->objectName().contains(u'.'))
            continue;
        text += QStringLiteral("| %1 | %2 | %3 | `%4` |\n")
                    .arg(entry.text, entry.path, QKeySequence::listToString(keys, QKeySequence::PortableText),
                         entry.action->objectName());
    }
    return text;
}

/// BOLSTER_WRITE_KEYS=1 writes it anew.
TEST_F(CommandsTest, TheDocumentOfKeysIsTheCommittedOne)
{
    QFile file(QString::fromStdString(test::sourceFolder()) + QStringLiteral("/docs/keys.md"));
    const QByteArray now = keysDocument(*window.menuBar()).toUtf8();
    if (qEnvironmentVariableIsSet("BOLSTER_WRITE_KEYS")) {
        ASSERT_TRUE(file.open(QFile::WriteOnly));
        file.write(now);
        return;
    }
    ASSERT_TRUE(file.open(QFile::ReadOnly));
    EXPECT_EQ(file.readAll().toStdString(), now.toStdString())
        << "run this test with BOLSTER_WRITE_KEYS=1 and look at what differs";
}

} // namespace
} // namespace bolster
