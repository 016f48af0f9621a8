// A small panel of the window that says what there is to try, and lets one go on.
#pragma once

#include <QFrame>
#include <QMenu>
#include <QPointer>

class QLabel;
class QPushButton;

namespace bolster {

class TourPanel : public QFrame {
    Q_OBJECT

public:
    explicit TourPanel(QWidget* window);

    /// `step` of `steps`, from 1 on.
    void say(int step, int steps, const QString& title, const QString& text);
    /// The step is done: what comes of it, until one goes on.
    void praise(const QString& text);
    void sayTheEnd(const QString& title, const QString& text);
    /// Beside a place in the window, or in a corner of it when that fills most of the window; never over the menu
    /// bar or an open menu.
    void placeBeside(const QRect& target);
    QString title() const;

signals:
    void nextWanted();
    void backWanted();
    void leaveWanted();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();
    QRect room() const;
    QPoint besideMenus(QPoint at) const;

    QLabel* m_count;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_leave;
    QRect m_target;
    QList<QPointer<QMenu>> m_menus; ///< that are open
};

} // namespace bolster
