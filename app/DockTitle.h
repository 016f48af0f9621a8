// The title of a dock: flat, in the colours of the theme.
#pragma once

#include <QWidget>

class QDockWidget;
class QLabel;

namespace bolster {

class DockTitle : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget* dock);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLabel* m_label;
};

} // namespace bolster
