// Leads a pattern to the cutter and one from elsewhere into the workbench, and writes a picture of each step:
//   bolster_cutting_pictures SAMPLES FOLDER
#include "Commands.h"
#include "DesignSession.h"
#include "Docks.h"
#include "DxfWriter.h"
#include "ExportPatternDialog.h"
#include "ImportPatternDialog.h"
#include "PatternView.h"
#include "Photographer.h"
#include "SeamProposalsWindow.h"
#include "SheetPreview.h"

#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <cstdio>

namespace bolster {
namespace {

/// The first child of this type for which the condition holds, when there is one.
template <class Widget, class Condition>
Widget* waitForChild(MainWindow& window, Condition condition)
{
    Widget* found = nullptr;
    waitFor(
        [&] {
            found = window.findChild<Widget*>();
            return found && found->isVisible() && condition(*found);
        },
        60000);
    return found;
}

QString dxfOf(const Design& design, const QDir& folder)
{
    const QString path = folder.filePath(QStringLiteral("car-seat.dxf"));
    const std::string text = dxfText(cutPattern(design, {}), {});
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), static_cast<qint64>(text.size())) < 0)
        std::fputs("the DXF cannot be written\n", stderr);
    return path;
}

void pictureOfPattern(MainWindow& window, Photographer& camera)
{
    window.command("layer.cutting")->setChecked(true);
    window.patternView().navigation().fitAll();
    waitFor([] { return false; }, 2500);
    QWidget& view = window.patternView();
    camera.take(QStringLiteral("pattern"), QRect(view.mapToGlobal(QPoint()), view.size()));
}

void pictureOfExport(MainWindow& window, Photographer& camera)
{
    window.command("file.export-pattern")->trigger();
    auto* dialog = waitForChild<ExportPatternDialog>(window, [](auto& shown) {
        auto* preview = shown.template findChild<SheetPreview*>();
        return shown.pattern() && preview && preview->isDrawn();
    });
    waitFor([] { return false; }, 1000);
    camera.take(QStringLiteral("export"), dialog->geometry());
    dialog->reject();
}

void pictureOfImport(MainWindow& window, Photographer& camera, const QString& dxf)
{
    window.command("file.import-pattern")->trigger();
    auto* files = waitForChild<QFileDialog>(window, [](auto&) { return true; });
    files->findChild<QLineEdit*>()->setText(dxf);
    QTest::keyClick(files->findChild<QLineEdit*>(), Qt::Key_Return);
    auto* dialog = waitForChild<ImportPatternDialog>(window, [](auto& shown) { return shown.pattern(); });
    waitFor([] { return false; }, 1000);
    camera.take(QStringLiteral("import"), dialog->geometry());
    QTest::keyClick(dialog, Qt::Key_Return);
}

void pictureOfProposals(MainWindow& window, Photographer& camera)
{
    window.patternView().navigation().fitAll();
    window.command("seam.propose")->trigger();
    auto* proposals = waitForChild<SeamProposalsWindow>(window, [](auto& shown) {
        auto* list = shown.template findChild<QTreeWidget*>();
        return list && list->topLevelItemCount() > 0;
    });
    proposals->move(window.geometry().topRight() + QPoint(-proposals->width() - 10, 60));
    for (int row = 0; row < 6; ++row)
        QTest::keyClick(proposals->findChild<QTreeWidget*>(), Qt::Key_Down);
    camera.take(QStringLiteral("proposals"));
    proposals->close();
}

int run(const QDir& samples, const QDir& folder)
{
    const QTemporaryDir own;
    MainWindow window;
    window.resize(1120, 740);
    window.show();
    waitFor([] { return false; }, 1000);
    window.activateWindow();
    bool opened = false;
    QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
    window.open(samples.filePath(QStringLiteral("car-seat/car-seat.json")));
    waitFor([&] { return opened; }, 30000);
    Photographer camera(window, folder, QStringLiteral("cutting"));
    pictureOfPattern(window, camera);
    pictureOfExport(window, camera);
    const QString dxf = dxfOf(window.document().design(), QDir(own.path()));
    window.document().markSaved();
    window.command("file.new")->trigger();
    waitFor([] { return false; }, 1000);
    pictureOfImport(window, camera, dxf);
    waitFor([&] { return !window.selection().elements().empty(); }, 30000);
    pictureOfProposals(window, camera);
    window.document().markSaved();
    return camera.good() ? 0 : 1;
}

} // namespace
} // namespace bolster

int main(int argc, char* argv[])
{
    return bolster::photograph(argc, argv, "SAMPLES FOLDER", [](const QStringList& given) {
        return bolster::run(QDir(given.at(0)), QDir(given.at(1)));
    });
}
