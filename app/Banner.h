// A line above the views that says something without stopping anybody.
#pragma once

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QLabel;

namespace bolster {

class Banner : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Problem, Information };
    struct Button {
        QString text;
        std::function<void()> pressed; ///< the banner closes first
    };

    explicit Banner(QWidget* parent = nullptr);

    /// Replaces what is shown.
    void announce(Kind kind, const QString& text, const QList<Button>& buttons);
    QString text() const;

signals:
    /// It appeared or was closed.
    void toggled(bool visible);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void dismiss();

    Kind m_kind = Kind::Information;
    QLabel* m_sign;
    QLabel* m_text;
    QHBoxLayout* m_buttons;
};

} // namespace bolster
