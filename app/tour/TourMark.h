// A frame around a part of the window that somebody is to look at.
#pragma once

#include <QPointer>
#include <QWidget>

namespace bolster {

/// Lies over the window and lets the pointer through.
class TourMark : public QWidget {
    Q_OBJECT

public:
    explicit TourMark(QWidget* window);

    /// Around `part` of the widget, all of it when empty; follows the widget. Null: around nothing.
    void pointAt(QWidget* widget, const QRect& part = {});
    /// In the window; empty when nothing is to be seen.
    QRect target() const;

signals:
    void moved();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();

    QWidget* m_window;
    QPointer<QWidget> m_widget;
    QRect m_part;
};

} // namespace bolster
