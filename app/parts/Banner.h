// A line above the views that says something without stopping anybody.
#pragma once

#include <QWidget>

#include <functional>
#include <optional>

class QHBoxLayout;
class QLabel;
class QToolButton;

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

    /// Replaces what is shown. Returns its number, for withdraw.
    int announce(Kind kind, const QString& text, const QList<Button>& buttons);
    void dismiss();
    /// A problem that nobody can close as long as it is there: all others wait until it ends. `why` is its tool
    /// tip.
    void warn(const QString& text, const QString& why, const QList<Button>& buttons);
    void endWarning();
    /// What it said is not so any more; does nothing when it says something else by now.
    void withdraw(int number);
    QString text() const;
    bool shown() const { return m_shown; }
    /// As high as the text needs in the width of the window.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

signals:
    /// It has something to say, or was closed. Whoever placed it shows and hides it: a tool bar wants that itself.
    void toggled(bool shown);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Content {
        Kind kind = Kind::Information;
        QString text;
        QString why = {};
        QList<Button> buttons = {};
    };

    void present(const Content& content);
    void showNext();

    Kind m_kind = Kind::Information;
    bool m_shown = false;
    int m_number = 0;
    std::optional<Content> m_warning;
    std::optional<Content> m_announced;
    QLabel* m_sign;
    QLabel* m_text;
    QHBoxLayout* m_buttons;
    QToolButton* m_close;
};

} // namespace bolster
