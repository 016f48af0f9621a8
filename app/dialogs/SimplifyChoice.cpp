#include "SimplifyChoice.h"

#include "NumberBox.h"

#include <QCheckBox>
#include <QHBoxLayout>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double fewestKept = 100;
constexpr double usuallyKept = 100'000;
constexpr std::size_t usuallySimplified = 1'000'000, alwaysSimplified = 3'000'000;

} // namespace

SimplifyChoice::SimplifyChoice(std::size_t triangles, QWidget* parent)
    : QWidget(parent)
    , m_on(new QCheckBox(tr("&Simplify to about"), this))
    , m_triangles(new NumberBox({tr(" triangles"), 0, fewestKept, static_cast<double>(triangles), 10'000}, this))
{
    m_triangles->display(std::min(usuallyKept, std::floor(static_cast<double>(triangles) / 4)));
    m_triangles->setAccessibleName(tr("Triangles"));
    m_triangles->setEnabled(false);
    m_on->setToolTip(tr("Writes the parts that are wanted into an OBJ file of the design's own; the file that was "
                        "chosen stays as it is"));
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_on);
    layout->addWidget(m_triangles, 1);
    connect(m_on, &QCheckBox::toggled, m_triangles, &QWidget::setEnabled);
    // A cover touches a frame; with millions of triangles everything that is done to it takes minutes and
    // gigabytes.
    m_on->setChecked(triangles > usuallySimplified);
    if (triangles > alwaysSimplified) {
        m_on->setEnabled(false);
        m_triangles->setMaximum(static_cast<double>(alwaysSimplified));
    }
}

std::optional<std::size_t> SimplifyChoice::wanted() const
{
    if (!m_on->isChecked())
        return std::nullopt;
    return static_cast<std::size_t>(std::lround(m_triangles->value()));
}

} // namespace bolster
