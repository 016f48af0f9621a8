#include "FeelWindow.h"

#include "Document.h"
#include "SolverLink.h"
#include "TestPaths.h"

#include <QTest>

namespace bolster {

FeelHome::FeelHome()
{
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("XDG_CONFIG_HOME", m_home.filePath("config").toLocal8Bit());
    qputenv("XDG_DATA_HOME", m_home.filePath("data").toLocal8Bit());
    QCoreApplication::setOrganizationName(QStringLiteral("BolsterTests"));
    QCoreApplication::setApplicationName(QStringLiteral("Bolster"));
}

std::unique_ptr<MainWindow> openCarSeat(bool settled, int mostMs)
{
    auto window = std::make_unique<MainWindow>();
    window->resize(1500, 900);
    window->show();
    window->activateWindow();
    if (!QTest::qWaitForWindowExposed(window.get()))
        return nullptr;
    window->open(QString::fromStdString(test::samplesFolder() + "/car-seat/car-seat.json"));
    const bool ready = QTest::qWaitFor(
        [&] {
            return window->solver().upToDate() && window->solver().surface() &&
                   (!settled || window->solver().status().state == SolverStatus::State::Settled);
        },
        mostMs);
    QTest::qWait(800); // the view flies there
    return ready ? std::move(window) : nullptr;
}

bool equalsItsReplay(Document& document)
{
    const History& history = document.history();
    const NodeId last = history.current();
    const Design result = document.design();
    const std::vector<NodeId> path = history.pathTo(last);
    document.jumpTo(0);
    Design replayed = document.design();
    for (const NodeId node : path)
        replayed = replayed.with(history.node(node).edit);
    document.jumpTo(last);
    return replayed == result && document.design() == result && !document.gestureRunning();
}

} // namespace bolster
