// Starts long work, shows how far it is, and stops it.
#pragma once

#include <QWidget>

class QProgressBar;
class QPushButton;

namespace bolster {

class RunRow : public QWidget {
    Q_OBJECT

public:
    /// `text` of the button that starts it.
    explicit RunRow(QString text, QWidget* parent = nullptr);

    bool running() const { return m_running; }
    void setRunning(bool running);
    /// 0 to 1.
    void setShare(double share);

signals:
    void started();
    void stopped();

private:
    QString m_text;
    QProgressBar* m_bar;
    QPushButton* m_button;
    bool m_running = false;
};

} // namespace bolster
