// What the inspector shows of the whole design.
#pragma once

#include "ElementForm.h"
#include "InspectorSubject.h"

#include <QCoreApplication>

namespace bolster {

class SettingsForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(SettingsForm)

public:
    explicit SettingsForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    static void addSymmetry(PropertyForm& form, const InspectorSubject<Settings>& settings);

    Document& m_document;
};

} // namespace bolster
