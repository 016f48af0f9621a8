// What the inspector shows of a cushion.
#pragma once

#include "ElementForm.h"
#include "FrameParts.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class CushionForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(CushionForm)

public:
    CushionForm(Document& document, const FormSources& sources, const FormWishes& wishes)
        : m_document(document)
        , m_parts(document, sources, wishes)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;
    std::vector<int> rowsDependOn(const Ids& ids) const override;

private:
    void addCoverChoice(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
    FrameParts m_parts; ///< the rows that it makes refer to it
};

} // namespace bolster
