// What the inspector shows of a fabric: its look, then how it behaves.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class FabricForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(FabricForm)

public:
    FabricForm(Document& document, const FormSources& sources, const FormWishes& wishes)
        : m_document(document)
        , m_sources(sources)
        , m_wishes(wishes)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;
    std::vector<int> rowsDependOn(const Ids& ids) const override;

private:
    void addPictures(PropertyForm& form, ElementId id) const;
    void addLook(PropertyForm& form, const Ids& ids) const;
    void addSecondColor(PropertyForm& form, const Ids& ids, const QString& label) const;
    void addKind(PropertyForm& form, const Ids& ids) const;

    Document& m_document;
    const FormSources& m_sources;
    const FormWishes& m_wishes;
};

} // namespace bolster
