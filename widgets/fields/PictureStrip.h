// Pictures side by side on a neutral ground.
#pragma once

#include <QImage>
#include <QWidget>

#include <vector>

namespace bolster {

/// As wide as its place; pictures are square and drawn as large as they fit, as sharp as they are.
class PictureStrip : public QWidget {
    Q_OBJECT

public:
    explicit PictureStrip(QWidget* parent = nullptr);

    /// Null ones leave their place empty.
    void setPictures(std::vector<QImage> pictures);
    const std::vector<QImage>& pictures() const { return m_pictures; }
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<QImage> m_pictures;
};

} // namespace bolster
