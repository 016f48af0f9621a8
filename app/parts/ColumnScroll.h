// A page that scrolls up and down.
#pragma once

#include <QScrollArea>

namespace bolster {

/// Never to the side: it is at least as wide as what is in it, whatever the language and the size of the letters.
class ColumnScroll : public QScrollArea {
    Q_OBJECT

public:
    explicit ColumnScroll(QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace bolster
