// What the inspector shows for curves drawn in patches.
#include "InspectorForms.h"

#include "ArcLength.h"
#include "InspectorSubject.h"
#include "OrientationFields.h"
#include "Units.h"

namespace bolster {

namespace {

// What the sliders cover; the boxes beside them take more.
constexpr double widestSlider = 60;
constexpr double deepestSlider = 20;

template <int Dim>
QString lengthOf(const BSpline<Dim>& curve)
{
    return curve.empty() ? QString() : lengthText(ArcLength<Dim>(curve).total());
}

} // namespace

void InspectorForms::addHandleCurve(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<HandleCurve> handle(m_document, ids, form);
    handle.name(tr("Name"));
    handle.info(tr("Patch"),
                [](const Design& design, const HandleCurve& h) { return displayName(design, h.patch); });
    handle.info(tr("In the pattern"), [](const Design&, const HandleCurve& h) { return lengthOf(h.curve); });
    handle.info(tr("In space"), [](const Design&, const HandleCurve& h) {
        return h.hasTarget() ? lengthOf(h.target) : tr("free");
    });
    handle.choice(tr("Match"), matchNames(), &HandleCurve::match,
                  QT_TRANSLATE_NOOP("Message", "Change how %1 is matched"));
    OrientationFields::add(form, handle);
}

void InspectorForms::addFancySeam(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<FancySeam> seam(m_document, ids, form);
    seam.name(tr("Name"));
    seam.info(tr("Patch"), [](const Design& design, const FancySeam& s) { return displayName(design, s.patch); });
    seam.slider(tr("Width"), {QStringLiteral(" mm"), 2, 0.1, 1000, 1}, 1, widestSlider, &FancySeam::width,
                QT_TRANSLATE_NOOP("Message", "Change the width of %1"));
    seam.slider(tr("Depth"), {QStringLiteral(" mm"), 2, -1000, 1000, 0.5}, -deepestSlider, deepestSlider,
                &FancySeam::depth, QT_TRANSLATE_NOOP("Message", "Change the depth of %1"));
    seam.choice(tr("Profile"),
                {tr("Round \u2013 a soft groove"), tr("Sharp \u2013 a crease"), tr("Welt \u2013 between creases")},
                &FancySeam::profile, QT_TRANSLATE_NOOP("Message", "Change the profile of %1"));
    seam.info(tr("Length"), [](const Design&, const FancySeam& s) { return lengthOf(s.curve); });
    form.addNote([seam] {
        return seam.shared([](const FancySeam& s) { return s.depth < 0; }) == true ? tr("It stands out: a welt.")
                                                                                   : QString();
    });
}

} // namespace bolster
