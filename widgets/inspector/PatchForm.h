// What the inspector shows of a patch.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class PatchForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(PatchForm)

public:
    explicit PatchForm(Document& document)
        : m_document(document)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    void addSize(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
};

} // namespace bolster
