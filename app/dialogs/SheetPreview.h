// What will be on the sheets of a pattern, small.
#pragma once

#include "LatestJob.h"
#include "SheetPlan.h"

#include <QImage>
#include <QPalette>
#include <QWidget>

#include <memory>
#include <utility>

namespace bolster {

/// Drawn beside the GUI thread: thousands of pieces take a while.
class SheetPreview : public QWidget {
    Q_OBJECT

public:
    explicit SheetPreview(QWidget* parent = nullptr);

    struct Shown {
        std::shared_ptr<const CutPattern> pattern;
        std::shared_ptr<const SheetPlan> plan; ///< of formats without pages the table alone
        CutLayers layers;
    };
    void show(Shown shown);
    /// The picture is of what is shown, as large as this is.
    bool isDrawn() const { return m_drawn; }

    QSize sizeHint() const override { return {560, 440}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Order {
        Shown shown;
        QSize pixels;
        double ratio = 1; ///< pixels of the screen for each
        QPalette palette;
        int revision = 0;
    };
    static QImage drawn(const Order& order, const std::stop_token& stop);
    bool isEmpty() const { return !m_shown.pattern || m_shown.plan->table.pieces.empty(); }
    void draw();

    Shown m_shown;
    QImage m_picture;
    int m_revision = 0; ///< of what is wanted
    bool m_drawn = false;
    LatestJob<Order, std::pair<int, QImage>> m_job; ///< last: it uses the others
};

} // namespace bolster
