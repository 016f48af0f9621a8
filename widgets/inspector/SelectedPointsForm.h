// What the inspector shows of selected control points: their coordinates.
#pragma once

#include "Selection.h"

#include <QCoreApplication>

namespace bolster {

class Document;
class PropertyForm;

class SelectedPointsForm {
    Q_DECLARE_TR_FUNCTIONS(SelectedPointsForm)

public:
    SelectedPointsForm(Document& document, const Selection& selection)
        : m_document(document)
        , m_selection(selection)
    {}

    void add(PropertyForm& form) const;

private:
    void addInPattern(PropertyForm& form, const Selection::Points& points) const;
    void addInSpace(PropertyForm& form, const Selection::Points& points) const;

    Document& m_document;
    const Selection& m_selection;
};

} // namespace bolster
