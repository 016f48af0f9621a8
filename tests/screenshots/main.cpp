// Opens a design in the real window, waits for its surface, and writes a picture of the window:
//   bolster_screenshot DESIGN PICTURE.png [options]
#include "Commands.h"
#include "Docks.h"
#include "MainWindow.h"
#include "PatchEdits.h"
#include "PatternView.h"
#include "Photographer.h"
#include "Theme.h"
#include "Translations.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QStandardPaths>

#include <array>

namespace bolster {
namespace {

struct Options {
    QCommandLineOption size{"size", "Of the window.", "WxH", "1400x900"};
    QCommandLineOption dark{"dark", "Dark theme."};
    QCommandLineOption mesh{"mesh", "Show the triangulation."};
    QCommandLineOption deviation{"deviation", "Show how far the cover lies from scans."};
    QCommandLineOption field{"field", "Show the forces of cushions."};
    QCommandLineOption select{"select", "Select these elements.", "ID,..."};
    QCommandLineOption close{"close-up", "Show the selection alone."};
    QCommandLineOption history{"history", "Make some edits, with a branch, and show the history."};
    QCommandLineOption language{"language", "Of the window.", "CODE", "C"};
    QCommandLineOption problems{"problems", "Show the list of problems."};
    QCommandLineOption dialog{"dialog", "Open one: figures, keys, about.", "NAME"};
};

/// A few edits with one branch, as a designer leaves them behind.
void makeHistory(Document& document)
{
    ElementId patch{};
    document.design().each<Patch>([&](ElementId id, const Patch&) { patch = patch == noElement ? id : patch; });
    const auto move = [&](int point, double x) {
        document.commit(edits::movePatchPoints(document.design(), patch, std::array{point}, Vec2(x, 0)));
    };
    move(1, 3);
    move(2, 4);
    document.commit(edits::movePatches(document.design(), std::array{patch}, Vec2(0, 20)));
    document.undo();
    document.undo();
    move(3, 2);
    document.commit(edits::turnPatches(document.design(), std::array{patch}, Vec2(0, 0), 2));
    move(4, 1);
    document.undo();
}

void arrange(MainWindow& window, const QCommandLineParser& parser, const Options& options)
{
    const QStringList size = parser.value(options.size).split('x');
    window.resize(size.value(0).toInt(), size.value(1).toInt());
    window.docks().reset();
    window.command("layer.mesh")->setChecked(parser.isSet(options.mesh));
    window.command("map.deviation")->setChecked(parser.isSet(options.deviation));
    window.command("layer.field")->setChecked(parser.isSet(options.field));
    Selection::Elements selected;
    for (const QString& id : parser.value(options.select).split(',', Qt::SkipEmptyParts))
        selected.insert(ElementId{id.toInt()});
    window.selection().set(selected);
    if (parser.isSet(options.close))
        window.patternView().navigation().fitSelection();
    if (parser.isSet(options.history)) {
        makeHistory(window.document());
        Docks::reveal(window.docks().history);
    }
}

int run(QApplication& application)
{
    const Options options;
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("DESIGN", "What to open.");
    parser.addPositionalArgument("PICTURE", "Where to write.");
    parser.addOptions({options.size, options.dark, options.mesh, options.deviation, options.field, options.select,
                       options.close, options.history, options.language, options.problems, options.dialog});
    parser.process(application);
    if (parser.positionalArguments().size() != 2)
        parser.showHelp(2);
    QLocale::setDefault(QLocale(parser.value(options.language)));
    installTranslations(application, QLocale());
    applyTheme(application, parser.isSet(options.dark) ? Theme::Dark : Theme::Light);

    MainWindow window;
    window.show();
    bool opened = false;
    QObject::connect(&window.session(), &DesignSession::opened, &window, [&] { opened = true; });
    window.open(parser.positionalArguments().at(0));
    if (!waitFor([&] { return opened; }, 30000))
        return 1;
    arrange(window, parser, options);
    const auto done = [&] {
        using State = SolverStatus::State;
        const State state = window.solver().status().state;
        return window.solver().upToDate() && state != State::Preparing && state != State::Moving;
    };
    waitFor(done, 60000);
    waitFor([&] { return window.solver().status().resting; }, window.solver().surface() ? 20000 : 0);
    if (parser.isSet(options.close))
        window.patternView().navigation().fitSelection();
    else
        window.patternView().navigation().fitAll();
    const QString dialog = parser.value(options.dialog);
    for (const auto& [name, action] :
         {std::pair("figures", window.command("surface.figures")), std::pair("keys", window.command("help.keys")),
          std::pair("about", window.command("help.about"))})
        if (dialog == name)
            action->trigger();
    if (parser.isSet(options.problems))
        Docks::reveal(window.docks().problems);
    waitFor([] { return false; }, 8000); // the fine picture comes when nothing moves any more
    const QRect place = window.geometry();
    const QPixmap picture = window.screen()->grabWindow(0, place.x(), place.y(), place.width(), place.height());
    window.document().markSaved();
    return picture.save(parser.positionalArguments().at(1)) ? 0 : 1;
}

} // namespace
} // namespace bolster

int main(int argc, char* argv[])
{
    QStandardPaths::setTestModeEnabled(true); // the user's own settings and unsaved work are none of ours
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("BolsterScreenshots");
    QCoreApplication::setApplicationName("Bolster");
    return bolster::run(application);
}
