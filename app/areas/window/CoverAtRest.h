// Whatever leaves the window shows the surface that follows from the design, never what a drag has left.
#pragma once

#include <QCoreApplication>
#include <QObject>

#include <functional>

namespace bolster {

class Document;
class SolverLink;
class StatusLine;

class CoverAtRest : public QObject {
    Q_DECLARE_TR_FUNCTIONS(CoverAtRest)

public:
    CoverAtRest(Document& document, SolverLink& solver, StatusLine& status);

    /// Calls it as soon as the cover is at rest; says why it has to wait, or why that will not be.
    void then(const std::function<void()>& act);

private:
    Document& m_document;
    SolverLink& m_solver;
    StatusLine& m_status;
};

} // namespace bolster
