#include "VersionCommands.h"

#include "CompareWindow.h"
#include "DesignSession.h"
#include "GiveMemoryBack.h"
#include "HistoryModel.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Thumbnails.h"

namespace bolster {

VersionCommands::VersionCommands(DesignSession& session, SolverLink& solver, FabricLink& fabrics,
                                 CoverView& coverView, HistoryPanel& history, QWidget& window)
    : m_session(session)
    , m_solver(solver)
    , m_fabrics(fabrics)
    , m_window(window)
    , m_thumbnails(std::make_unique<Thumbnails>(session, solver, coverView))
{
    HistoryModel& model = history.view().history();
    model.setPictures([this](NodeId node) { return m_thumbnails->picture(node); });
    connect(m_thumbnails.get(), &Thumbnails::made, &model, &HistoryModel::pictureMade);
    connect(&history.view(), &HistoryView::compareWanted, this, &VersionCommands::compareWith);
}

VersionCommands::~VersionCommands() = default;

void VersionCommands::compareWith(NodeId node)
{
    auto* window = m_window.findChild<CompareWindow*>();
    if (!window) {
        const auto filesOf = [session = &m_session](const Design& design) { return session->filesOf(design); };
        window = new CompareWindow(m_session.document(), filesOf, m_fabrics, m_solver, &m_window);
        connect(&m_session, &DesignSession::fileRead, window, &CompareWindow::updateFiles);
        connect(&m_session, &DesignSession::opened, window, &QWidget::close);
        connect(window, &QObject::destroyed, this, &giveMemoryBack);
    }
    if (window->compareWith(node)) {
        window->show();
        window->raise();
        window->activateWindow();
    }
}

} // namespace bolster
