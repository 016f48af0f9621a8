#include "ProgramThatDies.h"

#include "Commands.h"
#include "ElementEdits.h"
#include "MainWindow.h"

#include <QProcess>
#include <QTest>

#include <csignal>

namespace bolster::ProgramThatDies {

namespace {

constexpr char variable[] = "BOLSTER_TEST_DIES";

} // namespace

bool run(const QString& design, int edits, int undone, int editsThen)
{
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(
        variable,
        QStringList{design, QString::number(edits), QString::number(undone), QString::number(editsThen)}.join(
            '\n'));
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationFilePath(), {});
    return program.waitForFinished(120000) && program.exitStatus() == QProcess::CrashExit;
}

QStringList wanted()
{
    const QString what = qEnvironmentVariable(variable);
    return what.isEmpty() ? QStringList() : what.split('\n');
}

int workAndDie(const QStringList& wanted)
{
    MainWindow window;
    window.show();
    bool opened = false;
    QObject::connect(&window.session(), &DesignSession::opened, [&] { opened = true; });
    window.open(wanted.at(0));
    if (!QTest::qWaitFor([&] { return opened; }, 60000))
        return 1;
    const auto edit = [&](int times) {
        for (int i = 0; i < times; ++i) {
            Settings settings = window.document().design().settings();
            settings.edgeLength += 1;
            window.document().commit(edits::changeSettings(window.document().design(), settings));
        }
    };
    edit(wanted.at(1).toInt());
    for (int i = 0; i < wanted.at(2).toInt(); ++i)
        window.command("edit.undo")->trigger();
    edit(wanted.at(3).toInt());
    raise(SIGKILL);
    return 1;
}

} // namespace bolster::ProgramThatDies
