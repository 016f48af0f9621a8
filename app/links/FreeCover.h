// A cover that nothing holds yet: where it floats means nothing, so the window looks after it.
#pragma once

#include <QObject>

#include <cstdint>

namespace bolster {

class Document;
class SolverLink;
class CoverView;

/// Takes such a cover into the picture when it is not all in it, until somebody moves the view: it may have come to
/// lie far away.
class FreeCover : public QObject {
    Q_OBJECT

public:
    FreeCover(Document& document, SolverLink& solver, CoverView& view, QObject* parent);

    /// Another design was opened. `placed`: the view was chosen before, as if it had been moved.
    void begin(bool placed);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void look();

    Document& m_document;
    SolverLink& m_solver;
    CoverView& m_view;
    std::uint64_t m_shown = 0; ///< revision of the design
    bool m_moved = false;      ///< by hand
};

} // namespace bolster
