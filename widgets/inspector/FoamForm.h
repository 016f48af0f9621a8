// What the inspector shows of foam.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class FoamForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FoamForm)

public:
    explicit FoamForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
