// The title of a dock: flat, in the colours of the theme.
#pragma once

#include <QWidget>

class QDockWidget;
class QLabel;

namespace bolster {

/// Behind a tab that says the same there is no title.
class DockTitle : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget* dock);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void updateAll();
    void updateTabbed();
    bool hasTab() const;

    QDockWidget* m_dock;
    QLabel* m_label;
    bool m_tabbed = false;
    bool m_active = false; ///< the keyboard is in this part
};

} // namespace bolster
