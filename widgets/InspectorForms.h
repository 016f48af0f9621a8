// What the inspector shows for each kind of element.
#pragma once

#include "ElementId.h"
#include "PropertyForm.h"

#include <QCoreApplication>

#include <functional>
#include <memory>

namespace bolster {

class Document;
class ProblemSet;
class Selection;

/// Makes the form for the present selection.
class InspectorForms {
    Q_DECLARE_TR_FUNCTIONS(InspectorForms)

public:
    InspectorForms(Document& document, Selection& selection, ProblemSet& problems,
                   std::function<void(ElementId)> chooseFile);

    std::unique_ptr<PropertyForm> make() const;

private:
    void addSeveral(PropertyForm& form) const;
    void addElement(PropertyForm& form, ElementId id) const;
    void addSettings(PropertyForm& form) const;
    void addFabric(PropertyForm& form, ElementId id) const;
    void addPatch(PropertyForm& form, ElementId id) const;
    void addSeam(PropertyForm& form, ElementId id) const;
    void addFixationCurve(PropertyForm& form, ElementId id) const;
    void addFixationSeam(PropertyForm& form, ElementId id) const;
    void addFrame(PropertyForm& form, ElementId id) const;
    void addScan(PropertyForm& form, ElementId id) const;
    void addUnusable(PropertyForm& form, ElementId id) const;
    void addPatchPoint(PropertyForm& form, ElementId id, int point) const;
    void addCurvePoint(PropertyForm& form, ElementId id, int point) const;
    void addFabricChoice(PropertyForm& form, ElementId patch) const;
    static QStringList matchNames();

    Document& m_document;
    Selection& m_selection;
    ProblemSet& m_problems;
    std::function<void(ElementId)> m_chooseFile;
};

} // namespace bolster
