// What the inspector shows of the whole design.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class SettingsForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(SettingsForm)

public:
    explicit SettingsForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    void addSymmetry(PropertyForm& form) const;

    Document& m_document;
};

} // namespace bolster
