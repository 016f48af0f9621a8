// How large the parts of the window are meant to be, whatever room there is just now.
#pragma once

#include <QByteArray>
#include <QHash>
#include <QList>
#include <QObject>
#include <QRect>
#include <QSet>

class QDockWidget;
class QMainWindow;

namespace bolster {

/// Shown, and not behind another dock: those lie outside of the window.
bool isInFront(const QDockWidget& dock);

/// Docks forget: what a small window takes from one of them, a large one gives to another. Here the sizes are kept
/// that somebody chose; each time the window gets another size, the views share what room there is in their
/// proportion, and lists and fields keep their width.
class PaneSizes : public QObject {
    Q_OBJECT

public:
    /// `views` are those of the docks that share the room; the window outlives this.
    PaneSizes(QMainWindow& window, QList<QDockWidget*> docks, QList<QDockWidget*> views);

    /// What is seen is what is wanted.
    void take();
    /// The docks get the sizes that are wanted, as far as there is room.
    void apply();
    QByteArray save() const;
    void restore(const QByteArray& saved);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QSet<QDockWidget*> shown() const;
    QRect placeOf(QDockWidget* dock) const;
    int wantedWidth(QDockWidget* dock) const;
    void takeIfOthersAreShown();
    QList<QSize> leastSizes() const;
    void applyIfLeastSizesChanged();

    QMainWindow& m_window;
    QList<QDockWidget*> m_docks;
    QList<QDockWidget*> m_views;
    QHash<QDockWidget*, QRect> m_wanted; ///< where each was when it had its size
    QSize m_room;                        ///< that the window had then
    QSet<QDockWidget*> m_shown;          ///< at that time, or when they were restored
    QList<QSize> m_least;                ///< that they needed when they got their sizes last
    bool m_applying = false;
};

} // namespace bolster
