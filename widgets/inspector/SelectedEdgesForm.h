// What the inspector shows of selected edges: their lengths.
#pragma once

#include <QCoreApplication>

namespace bolster {

class Document;
class PropertyForm;
class Selection;

class SelectedEdgesForm {
    Q_DECLARE_TR_FUNCTIONS(SelectedEdgesForm)

public:
    SelectedEdgesForm(Document& document, const Selection& selection)
        : m_document(document)
        , m_selection(selection)
    {}

    void add(PropertyForm& form) const;

private:
    Document& m_document;
    const Selection& m_selection;
};

} // namespace bolster
