// Makes the inspector's form of what is selected.
#pragma once

#include "ElementForm.h"
#include "ElementText.h"
#include "SelectedEdgesForm.h"
#include "SelectedPointsForm.h"
#include "TwinForm.h"

#include <QCoreApplication>

#include <map>
#include <memory>
#include <vector>

namespace bolster {

class ProblemSet;

class InspectorForms {
    Q_DECLARE_TR_FUNCTIONS(InspectorForms)

public:
    InspectorForms(Document& document, const Selection& selection, const ProblemSet& problems, FormWishes wishes);

    FormSources& sources() { return m_sources; }

    std::unique_ptr<PropertyForm> make() const;
    /// What decides which rows the form has, beside the selection and the files.
    std::vector<int> basis() const;

private:
    using Ids = ElementForm::Ids;
    using Kinds = std::map<ElementKind, Ids>;

    template <class T, class Form, class... Needs>
    void use(Needs&... needs);
    Kinds selectedKinds() const;
    /// Of each kind its properties, those of all its elements in one field.
    void addSeveral(PropertyForm& form) const;
    void addElement(PropertyForm& form, ElementId id) const;
    void addKind(PropertyForm& form, const ElementKind& kind, const Ids& ids) const;
    void addNote(PropertyForm& form, ElementId id) const;

    Document& m_document;
    const Selection& m_selection;
    const ProblemSet& m_problems;
    FormSources m_sources;
    const FormWishes m_wishes;
    std::map<ElementKind, std::unique_ptr<ElementForm>> m_forms;
    SelectedPointsForm m_points;
    SelectedEdgesForm m_edges;
    TwinForm m_twin;
};

} // namespace bolster
