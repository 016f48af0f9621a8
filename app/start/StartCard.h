// Something to begin with on the start page: a picture or an icon, what it is, and a few words.
#pragma once

#include <QAbstractButton>
#include <QImage>

class QToolButton;

namespace bolster {

/// Reached by Tab and arrows, pressed by Enter or Space. As large as its font and
/// its words ask for.
class StartCard : public QAbstractButton {
    Q_OBJECT

public:
    enum class Shape {
        Picture, ///< above the words
        Action   ///< an icon beside the words
    };

    /// `icon` stands for the picture until there is one.
    StartCard(Shape shape, const QString& icon, const QString& title, const QString& words, QWidget* parent);

    void setPicture(const QImage& picture);
    bool hasPicture() const { return !m_picture.isNull(); }
    /// It is not there any more: grey, with other words. Pressing it still says so.
    void setMissing(const QString& words);
    bool missing() const { return m_missing; }
    /// A cross in its corner, or Delete, takes it out of the list.
    void setRemovable(const QString& tip);
    const QString& words() const { return m_words; }
    /// There is room for every word.
    bool showsAll() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void removeWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    int em() const { return fontMetrics().height(); }
    QRect pictureRect() const;
    QRect wordsRect() const;
    void paintPicture(QPainter& painter) const;
    void paintWords(QPainter& painter) const;
    void updateCross();
    void updateAccessibleName();

    Shape m_shape;
    QString m_icon;
    QString m_words;
    QImage m_picture;
    bool m_missing = false;
    QToolButton* m_cross = nullptr;
};

} // namespace bolster
