#include "SectionPanel.h"

#include "Icons.h"
#include "Units.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

namespace bolster {

namespace {

constexpr int steps = 1000; // of the slider
constexpr int margin = 10;  // pixels

} // namespace

SectionPanel::SectionPanel(QWidget* parent)
    : QFrame(parent)
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_value(new QLabel(this))
{
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(new QLabel(tr("Section"), this));
    auto* group = new QButtonGroup(this);
    const std::array<std::pair<QString, QString>, 4> names = {
        {{QStringLiteral("X"), tr("Cut across the x axis")},
         {QStringLiteral("Y"), tr("Cut across the y axis")},
         {QStringLiteral("Z"), tr("Cut across the z axis")},
         {tr("View"), tr("Cut parallel to the picture, as it is seen now")}}};
    const auto addButton = [&](const QString& text, const QString& tip) {
        auto* button = new QToolButton(this);
        button->setText(text);
        button->setToolTip(tip);
        button->setAutoRaise(true);
        layout->addWidget(button);
        return button;
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        m_directions[i] = addButton(names[i].first, names[i].second);
        m_directions[i]->setCheckable(true);
        group->addButton(m_directions[i]);
        connect(m_directions[i], &QToolButton::clicked, this, [this, i] { choose(static_cast<int>(i)); });
    }
    m_slider->setRange(0, steps);
    m_slider->setMinimumWidth(150);
    m_slider->setToolTip(tr("Moves the plane"));
    layout->addWidget(m_slider, 1);
    m_value->setMinimumWidth(m_value->fontMetrics().horizontalAdvance(QStringLiteral("-8888.8 mm")));
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(m_value);
    QToolButton* turn = addButton({}, tr("Show the other half"));
    turn->setIcon(icon(QStringLiteral("swap")));
    QToolButton* close = addButton({}, tr("Close the section"));
    close->setIcon(icon(QStringLiteral("close")));
    connect(m_slider, &QSlider::valueChanged, this, &SectionPanel::announce);
    connect(turn, &QToolButton::clicked, this, &SectionPanel::flip);
    connect(close, &QToolButton::clicked, this, &SectionPanel::closed);
    hide();
}

void SectionPanel::setScene(std::function<Box3()> box, std::function<Camera()> camera)
{
    m_box = std::move(box);
    m_camera = std::move(camera);
}

void SectionPanel::setOn(bool on)
{
    if (on == this->on())
        return;
    setVisible(on);
    if (!on) {
        emit changed(std::nullopt);
        return;
    }
    place();
    raise();
    choose(0);
}

void SectionPanel::place()
{
    adjustSize();
    resize(std::min(width(), std::max(parentWidget()->width() - 2 * margin, 1)), height());
    move(margin, parentWidget()->height() - height() - margin);
}

/// What faces the viewer is cut away.
void SectionPanel::choose(int direction)
{
    m_directions[static_cast<std::size_t>(direction)]->setChecked(true);
    const Vec3 toEye = m_camera().backward();
    m_normal = direction == 3 ? toEye : Vec3(Vec3::Unit(direction));
    m_flipped = m_normal.dot(toEye) < 0;
    m_range = sectionRange(m_box(), m_normal);
    const QSignalBlocker silent(m_slider);
    m_slider->setValue(steps / 2);
    announce();
}

void SectionPanel::flip()
{
    m_flipped = !m_flipped;
    announce();
}

double SectionPanel::offset() const
{
    return m_range.first + (m_range.second - m_range.first) * m_slider->value() / steps;
}

void SectionPanel::announce()
{
    m_value->setText(lengthText(offset()));
    emit changed(SectionPlane{m_flipped ? Vec3(-m_normal) : m_normal, m_flipped ? -offset() : offset()});
}

} // namespace bolster
