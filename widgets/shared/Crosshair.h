// A cross-hair over a view: where the other view's pointer is.
#pragma once

#include <QWidget>

#include <optional>

namespace bolster {

/// Lies above its parent without taking the pointer, so that the parent need not be drawn again.
class Crosshair : public QWidget {
    Q_OBJECT

public:
    explicit Crosshair(QWidget* parent);

    /// In pixels of the parent; nothing hides it. What is seen through something else is faint.
    void showAt(const std::optional<QPointF>& pixel, bool faint = false);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_faint = false;
    QPointF m_rest; ///< of the place, less than a pixel
};

} // namespace bolster
