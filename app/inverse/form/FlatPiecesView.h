// Pieces of a form, laid flat side by side, in the colours of their strain.
#pragma once

#include "FormPatternJob.h"

#include <QPolygonF>
#include <QWidget>

namespace bolster {

class FlatPiecesView : public QWidget {
    Q_OBJECT

public:
    explicit FlatPiecesView(QWidget* parent = nullptr);

    /// `limit`: of strain, 1: the end of the colours.
    void show(std::shared_ptr<const FormMade> made, double limit);
    QSize sizeHint() const override { return {520, 420}; }
    /// Under the pointer; nothing where there is none.
    std::optional<std::size_t> hovered() const { return m_hovered; }

signals:
    void hoveredChanged();

protected:
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<std::size_t> pieceAt(const QPointF& pixel) const;
    void hover(std::optional<std::size_t> piece);
    int scaleHeight() const;
    QTransform fitting() const;
    QPolygonF borderOf(const QTransform& fit, std::size_t piece) const;
    void paintScale(QPainter& painter) const;
    void paintPiece(QPainter& painter, const QTransform& fit, std::size_t piece) const;

    std::shared_ptr<const FormMade> m_made;
    double m_limit = 0.08;
    std::optional<std::size_t> m_hovered;
};

} // namespace bolster
