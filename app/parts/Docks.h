// The parts of the window and where they stand.
#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QList>

class QMainWindow;

namespace bolster {

class PaneSizes;

/// All parts are docks: pattern and cover side by side, the lists beside them. The user may move them; the
/// arrangement is kept, and reset() brings back the first one.
class Docks {
public:
    struct Parts {
        QWidget* pattern;
        QWidget* cover;
        QWidget* elements;
        QWidget* history;
        QWidget* inspector;
        QWidget* problems;
        QWidget* seams;
        QWidget* fabrics;
        QWidget* spots;
        QWidget* cutting;
        QWidget* jobs;
    };

    Docks(QMainWindow& window, const Parts& parts);

    QDockWidget* pattern;
    QDockWidget* cover;
    QDockWidget* elements;
    QDockWidget* history;
    QDockWidget* inspector;
    QDockWidget* problems;
    QDockWidget* seams;
    QDockWidget* fabrics;
    QDockWidget* spots;
    QDockWidget* cutting;
    QDockWidget* jobs; ///< a tab beside the lists while somebody works
    QList<QDockWidget*> all() const
    {
        return {pattern, cover, elements, history, inspector, problems, seams, fabrics, spots, cutting, jobs};
    }

    void reset();
    QByteArray saveSizes() const;
    void restoreSizes(const QByteArray& saved);
    /// Shows a part and brings it to the front.
    static void reveal(QDockWidget* dock);

private:
    QMainWindow& m_window;
    PaneSizes* m_sizes;
};

} // namespace bolster
