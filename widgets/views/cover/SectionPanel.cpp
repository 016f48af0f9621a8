#include "SectionPanel.h"

#include "Icons.h"
#include "Units.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int steps = 1000;     // of the slider
constexpr int panelMargin = 10; // pixels

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
        button->setAccessibleName(tip);
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
    m_slider->setAccessibleName(tr("Place of the section"));
    layout->addWidget(m_slider, 1);
    m_value->setMinimumWidth(m_value->fontMetrics().horizontalAdvance(QStringLiteral("-888 88/88\u2033")));
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(m_value);
    QToolButton* turn = addButton({}, tr("Show the other half"));
    turn->setIcon(icon(QStringLiteral("swap")));
    QToolButton* close = addButton({}, tr("Close the section"));
    close->setIcon(icon(QStringLiteral("close")));
    connect(m_slider, &QSlider::valueChanged, this, [this](int step) {
        m_offset = m_range.first + (m_range.second - m_range.first) * step / steps;
        announce();
    });
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &SectionPanel::showOffset);
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
    resize(std::min(width(), std::max(parentWidget()->width() - 2 * panelMargin, 1)), height());
    move(panelMargin, parentWidget()->height() - height() - panelMargin);
}

/// What faces the viewer is cut away.
void SectionPanel::choose(int direction)
{
    m_directions[static_cast<std::size_t>(direction)]->setChecked(true);
    const Vec3 toEye = m_camera().backward();
    m_normal = direction == 3 ? toEye : Vec3(Vec3::Unit(direction));
    m_flipped = m_normal.dot(toEye) < 0;
    m_range = sectionRange(m_box(), m_normal);
    m_offset = (m_range.first + m_range.second) / 2;
    announce();
}

void SectionPanel::flip()
{
    m_flipped = !m_flipped;
    announce();
}

void SectionPanel::setPlane(const SectionPlane& plane)
{
    if (!on())
        return;
    m_flipped = m_normal.dot(plane.normal) < 0;
    const bool turned = std::abs(m_normal.dot(plane.normal)) < 1 - 1e-12;
    m_normal = m_flipped ? Vec3(-plane.normal) : plane.normal;
    m_offset = m_flipped ? -plane.offset : plane.offset;
    m_range = sectionRange(m_box(), m_normal);
    // A plane that has been turned has none of these directions.
    if (turned) {
        QButtonGroup* group = m_directions[0]->group();
        group->setExclusive(false);
        for (std::size_t i = 0; i < m_directions.size(); ++i)
            m_directions[i]->setChecked(i < 3 && std::abs(m_normal[static_cast<Eigen::Index>(i)]) > 1 - 1e-9);
        group->setExclusive(true);
    }
    announce();
}

void SectionPanel::showOffset()
{
    const QSignalBlocker silent(m_slider);
    const double share = (m_offset - m_range.first) / (m_range.second - m_range.first);
    m_slider->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps)));
    m_value->setText(lengthText(m_offset));
}

void SectionPanel::announce()
{
    showOffset();
    emit changed(SectionPlane{m_flipped ? Vec3(-m_normal) : m_normal, m_flipped ? -m_offset : m_offset});
}

} // namespace bolster
