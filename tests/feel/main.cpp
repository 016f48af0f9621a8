// Replays gestures on the sample car seat and says how it feels.
#include "FeelRecorder.h"
#include "FeelWindow.h"

#include "Document.h"

#include <QCommandLineParser>
#include <QFile>
#include <QTextStream>

#include <algorithm>
#include <cstdio>

namespace {

using namespace bolster;

double percentile(std::vector<double> values, double share)
{
    if (values.empty())
        return 0;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void print(const char* what, const std::vector<double>& values, double wanted)
{
    std::printf("%-52s p50 %7.1f ms   p95 %7.1f ms   wanted %4.0f ms   %zu times\n", what, percentile(values, 0.5),
                percentile(values, 0.95), wanted, values.size());
}

void print(const char* what, const WatchedApplication::Longest& longest, double wanted)
{
    std::printf("%-52s %11.1f ms   computing %.1f ms   wanted %4.0f ms   %s\n", what, longest.wall, longest.cpu,
                wanted, longest.what.c_str());
}

void print(const FeelFigures& figures)
{
    print("pointer to repainted pattern", figures.toPattern, 50);
    print("pointer to new surface, fixation points", figures.toSurfaceFixation, 120);
    print("pointer to new surface, outline points", figures.toSurfaceOutline, 150);
    print("longest block but painting, while something moves", figures.block, 30);
    print("longest painting, while something moves", figures.paint, 60);
    std::printf("%d events, %d moves whose surface did not come:", figures.events, figures.unseen);
    for (const auto& [kind, count] : figures.gestures)
        std::printf(" %d x %s", count, qPrintable(kind));
    std::printf("\n");
}

FeelScript readScript(const QString& path)
{
    FeelScript script;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        std::fprintf(stderr, "bolster_feel: \"%s\" cannot be read\n", qPrintable(path));
    while (!file.atEnd())
        if (const std::optional<FeelEvent> event = FeelEvent::read(QString::fromUtf8(file.readLine()).trimmed()))
            script.push_back(*event);
    return script;
}

bool writeScript(const QString& path, const FeelScript& script)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return false;
    QTextStream text(&file);
    for (const FeelEvent& event : script)
        text << event.line() << '\n';
    return true;
}

} // namespace

int main(int argc, char* argv[])
{
    const FeelHome home;
    FeelApplication application(argc, argv);
    QCommandLineParser options;
    options.addHelpOption();
    options.addPositionalArgument("recording", "replays this file instead of making gestures up", "[recording]");
    options.addOption({"gestures", "how many to make up", "count", "300"});
    options.addOption({"seed", "which ones", "number", "1"});
    options.addOption({"record", "writes them to this file", "file"});
    options.process(application);

    const std::unique_ptr<MainWindow> window = openCarSeat(true, 180000);
    if (!window) {
        std::fprintf(stderr, "bolster_feel: the car seat did not settle\n");
        return 1;
    }
    FeelPlayer player(application, *window);
    FeelRecorder recorder(*window, player, options.value("seed").toUInt());
    if (!options.positionalArguments().isEmpty()) {
        for (const FeelEvent& event : readScript(options.positionalArguments().front()))
            player.play(event);
        player.finishGesture();
    } else {
        recorder.makeGestures(options.value("gestures").toInt());
    }
    if (options.isSet("record") && !writeScript(options.value("record"), recorder.script()))
        std::fprintf(stderr, "bolster_feel: the recording cannot be written\n");

    print(player.figures());
    const bool good = equalsItsReplay(window->document());
    std::printf("the design %s its replay\n", good ? "equals" : "DIFFERS FROM");
    window->document().markSaved(); // no question on the way out
    window->close();
    return good ? 0 : 1;
}
