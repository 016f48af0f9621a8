// What the inspector shows of a scan.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class ScanForm : public ElementForm {
    Q_DECLARE_TR_FUNCTIONS(ScanForm)

public:
    ScanForm(Document& document, const FormSources& sources, const FormWishes& wishes)
        : m_document(document)
        , m_sources(sources)
        , m_wishes(wishes)
    {}

    void add(PropertyForm& form, const Ids& ids) const override;

private:
    /// How many points of its file there are.
    void addContents(PropertyForm& form, ElementId id) const;
    void addReport(PropertyForm& form, ElementId id) const;
    void addCuts(PropertyForm& form, ElementId id) const;

    Document& m_document;
    const FormSources& m_sources;
    const FormWishes& m_wishes;
};

} // namespace bolster
