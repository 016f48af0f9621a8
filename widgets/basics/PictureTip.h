// A tool tip that may show a picture.
#pragma once

#include <QLabel>

namespace bolster {

/// Goes as soon as the pointer moves on.
class PictureTip : public QLabel {
    Q_OBJECT

public:
    explicit PictureTip(QWidget* owner);

    /// `html` comes from the program; what it quotes is escaped. Nothing to show: it goes.
    void showAt(const QPoint& pointer, const QString& html);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace bolster
