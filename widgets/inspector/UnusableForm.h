// What the inspector shows of an element that cannot be read.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class UnusableForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(UnusableForm)

public:
    explicit UnusableForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
