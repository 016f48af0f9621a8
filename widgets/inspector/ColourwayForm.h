// What the inspector shows of a colourway.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class ColourwayForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(ColourwayForm)

public:
    explicit ColourwayForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    Document& m_document;
};

} // namespace bolster
