// Scale, position and rotation of an element in the inspector.
#pragma once

#include "FrameAngles.h"
#include "InspectorSubject.h"
#include "Units.h"

namespace bolster {

// What the fields take; what is a good value, DesignCheck says.
inline const NumberBox::Range lengthRange{millimetreSuffix, 3, -1e7, 1e7, 1};
inline const NumberBox::Range angleRange{QStringLiteral("\u00b0"), 3, -360, 360, 5};

template <class T>
void addPlacementFields(PropertyForm& form, const InspectorSubject<T>& subject)
{
    if constexpr (std::is_same_v<T, Foam>)
        subject.unitless(&T::scale); // of a shape there is no file with units
    else
        subject.field(&T::scale);
    subject.field(&T::position);
    const DescribedField turned = InspectorSubject<T>::fieldAt(&T::rotation);
    form.addNumbers(
        turned.label(), angleRange, 3,
        [subject](int i) {
            return subject.shared([i](const T& t) { return anglesOf(t.rotation)[static_cast<std::size_t>(i)]; });
        },
        [subject, verb = turned.field.verb](int i, double value) {
            subject.change(verb, [&](T& t) {
                FrameAngles angles = anglesOf(t.rotation);
                angles[static_cast<std::size_t>(i)] = value;
                t.rotation = rotationOf(angles);
            });
        });
}

} // namespace bolster
