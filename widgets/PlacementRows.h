// Scale, position and rotation of an element that places a file.
#pragma once

#include "FrameAngles.h"
#include "InspectorSubject.h"

#include <QCoreApplication>

namespace bolster {

class PlacementRows {
    Q_DECLARE_TR_FUNCTIONS(InspectorForms)

public:
    // What the fields take; what is a good value, DesignCheck says.
    static NumberBox::Range lengthRange() { return {QStringLiteral(" mm"), 3, -1e7, 1e7, 1}; }
    static NumberBox::Range angleRange() { return {QStringLiteral("\u00b0"), 3, -360, 360, 5}; }

    template <class T>
    static void add(const InspectorSubject<T>& subject, PropertyForm& form)
    {
        subject.number(tr("Scale"), {tr(" mm per unit"), 6, 1e-6, 1e6, 0.1}, &T::scale,
                       QT_TRANSLATE_NOOP("Message", "Scale %1"));
        subject.numbers(
            tr("Position"), lengthRange(), 3, [](T& t, int i) -> double& { return t.position[i]; },
            QT_TRANSLATE_NOOP("Message", "Move %1"));
        form.addNumbers(
            tr("Rotation"), angleRange(), 3,
            [subject](int i) { return anglesOf(subject.now().rotation)[static_cast<std::size_t>(i)]; },
            [subject](int i, double value) {
                subject.change(QT_TRANSLATE_NOOP("Message", "Turn %1"), [&](T& t) {
                    FrameAngles angles = anglesOf(t.rotation);
                    angles[static_cast<std::size_t>(i)] = value;
                    t.rotation = rotationOf(angles);
                });
            });
    }
};

} // namespace bolster
