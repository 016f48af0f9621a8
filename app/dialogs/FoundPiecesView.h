// The pieces that were found in a file, small, as they lie in it.
#pragma once

#include "FoundPieces.h"

#include <QWidget>

#include <memory>
#include <set>

namespace bolster {

class FoundPiecesView : public QWidget {
    Q_OBJECT

public:
    explicit FoundPiecesView(QWidget* parent = nullptr);

    /// Those that are not chosen are pale; `marked` is the one that the user looks at, -1: none.
    void show(std::shared_ptr<const FoundPattern> pattern, std::set<std::size_t> chosen, int marked);

    QSize sizeHint() const override { return {560, 440}; }

signals:
    /// A click on a piece.
    void pressed(int piece);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    QTransform placed() const;
    void layOut();

    std::shared_ptr<const FoundPattern> m_pattern;
    std::vector<Vec2> m_offsets; ///< of pieces, so that they don't lie on each other
    Box2 m_box;
    std::set<std::size_t> m_chosen;
    int m_marked = -1;
};

} // namespace bolster
