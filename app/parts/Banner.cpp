#include "Banner.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include <utility>

namespace bolster {

namespace {

QColor signColor(Banner::Kind kind, const QPalette& palette)
{
    const ViewColors colors = ViewColors::of(palette);
    return kind == Banner::Kind::Problem ? colors.error : colors.accent;
}

} // namespace

Banner::Banner(QWidget* parent)
    : QWidget(parent)
    , m_sign(new QLabel(this))
    , m_text(new QLabel(this))
    , m_buttons(new QHBoxLayout)
    , m_close(new QToolButton(this))
{
    m_close->setIcon(icon(QStringLiteral("close")));
    m_close->setIconSize({14, 14});
    m_close->setAutoRaise(true);
    m_close->setToolTip(tr("Close"));
    m_close->setAccessibleName(m_close->toolTip());
    connect(m_close, &QToolButton::clicked, this, &Banner::dismiss);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 8, 6);
    layout->setSpacing(8);
    layout->addWidget(m_sign);
    layout->addWidget(m_text, 1);
    layout->addLayout(m_buttons);
    layout->addWidget(m_close);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText); // names may be in it
    m_text->setMinimumWidth(1);           // they may be longer than the window is wide
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

int Banner::announce(Kind kind, const QString& text, const QList<Button>& buttons)
{
    m_announced = Content{kind, text, {}, buttons};
    showNext();
    return ++m_number;
}

void Banner::warn(const QString& text, const QString& why, const QList<Button>& buttons)
{
    m_warning = Content{Kind::Problem, text, why, buttons};
    showNext();
}

void Banner::endWarning()
{
    if (!std::exchange(m_warning, std::nullopt))
        return;
    showNext();
}

void Banner::showNext()
{
    if (const auto& next = m_warning ? m_warning : m_announced) {
        present(*next);
        return;
    }
    m_shown = false;
    emit toggled(false);
}

void Banner::present(const Content& content)
{
    m_kind = content.kind;
    const QString name = m_kind == Kind::Problem ? QStringLiteral("error") : QStringLiteral("info");
    m_sign->setPixmap(icon(name, signColor(m_kind, palette())).pixmap(QSize(18, 18), devicePixelRatioF()));
    m_text->setText(content.text);
    m_text->setAccessibleDescription(content.why);
    m_text->setToolTip(content.why);
    m_close->setVisible(!m_warning);
    while (QLayoutItem* item = m_buttons->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    for (const Button& button : content.buttons) {
        auto* push = new QPushButton(button.text, this);
        push->setAutoDefault(true); // Enter presses it
        connect(push, &QPushButton::clicked, this, [this, pressed = button.pressed] {
            if (!m_warning)
                dismiss();
            pressed();
        });
        m_buttons->addWidget(push);
    }
    m_shown = true;
    updateGeometry();
    update();
    emit toggled(true);
}

QString Banner::text() const
{
    return m_text->text();
}

QSize Banner::sizeHint() const
{
    const int width = isVisible() ? this->width() : window()->width(); // a tool bar has margins
    return {width, layout()->heightForWidth(width)};
}

void Banner::resizeEvent(QResizeEvent*)
{
    if (height() != sizeHint().height())
        updateGeometry();
}

void Banner::dismiss()
{
    m_announced.reset();
    showNext();
}

void Banner::withdraw(int number)
{
    if (m_announced && number == m_number)
        dismiss();
}

void Banner::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor sign = signColor(m_kind, palette());
    painter.fillRect(rect(), mixed(palette().color(QPalette::Base), sign, 0.14));
    painter.fillRect(QRect(0, 0, 3, height()), sign);
}

} // namespace bolster
