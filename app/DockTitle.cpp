#include "DockTitle.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace bolster {

DockTitle::DockTitle(QDockWidget* dock)
    : QWidget(dock)
    , m_label(new QLabel(dock->windowTitle(), this))
{
    QFont font = m_label->font();
    font.setWeight(QFont::DemiBold);
    m_label->setFont(font);

    const auto button = [this](const QString& name, const QString& tip) {
        auto* result = new QToolButton(this);
        result->setIcon(icon(name));
        result->setIconSize({12, 12});
        result->setAutoRaise(true);
        result->setToolTip(tip);
        result->setFocusPolicy(Qt::NoFocus);
        return result;
    };
    QToolButton* floating = button(QStringLiteral("float"), tr("Take out of the window, or put back"));
    QToolButton* close = button(QStringLiteral("close"), tr("Close; the Window menu brings it back"));
    connect(floating, &QToolButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
    connect(close, &QToolButton::clicked, dock, &QWidget::close);
    connect(dock, &QWidget::windowTitleChanged, m_label, &QLabel::setText);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 3, 4, 3);
    layout->setSpacing(0);
    layout->addWidget(m_label, 1);
    layout->addWidget(floating);
    layout->addWidget(close);
}

void DockTitle::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor line = mixed(palette().color(QPalette::Window), palette().color(QPalette::Text), 0.13);
    painter.setPen(line);
    painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

} // namespace bolster
