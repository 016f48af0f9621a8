// What the inspector shows of a frame.
#pragma once

#include "ElementForm.h"
#include "FrameParts.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class FrameForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FrameForm)

public:
    FrameForm(Document& document, const FormSources& sources, const FormWishes& wishes)
        : m_document(document)
        , m_wishes(wishes)
        , m_parts(document, sources, wishes)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    void addMaterial(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
    const FormWishes& m_wishes;
    FrameParts m_parts; ///< the rows that it makes refer to it
};

} // namespace bolster
