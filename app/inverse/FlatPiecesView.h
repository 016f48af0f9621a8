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

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    int scaleHeight() const;
    QTransform fitting() const;
    QPolygonF borderOf(const QTransform& fit, std::size_t piece) const;
    void paintScale(QPainter& painter) const;
    void paintPiece(QPainter& painter, const QTransform& fit, std::size_t piece) const;

    std::shared_ptr<const FormMade> m_made;
    double m_limit = 0.08;
};

} // namespace bolster
