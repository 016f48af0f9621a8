// What the inspector shows for each kind of element.
#pragma once

#include "ElementId.h"
#include "PropertyForm.h"
#include "ScanFigures.h"

#include <QCoreApplication>

#include <functional>
#include <map>
#include <memory>

namespace bolster {

class Document;
class ProblemSet;
class Selection;

/// What the user wants of a scan beyond its numbers.
enum class ScanWish { FitPlacement, CutAway, KeepOnly, KeepAroundCover, ShowAll };

/// Makes the form for the present selection.
class InspectorForms {
    Q_DECLARE_TR_FUNCTIONS(InspectorForms)

public:
    InspectorForms(Document& document, Selection& selection, ProblemSet& problems,
                   std::function<void(ElementId)> chooseFile, std::function<void(ElementId, ScanWish)> scanWish);

    /// As measured last.
    void setScanFigures(std::map<ElementId, ScanFigures> figures) { m_scanFigures = std::move(figures); }

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
    void addHandleCurve(PropertyForm& form, ElementId id) const;
    void addFancySeam(PropertyForm& form, ElementId id) const;
    void addFrame(PropertyForm& form, ElementId id) const;
    void addCushion(PropertyForm& form, ElementId id) const;
    void addFoam(PropertyForm& form, ElementId id) const;
    void addFrameChoice(PropertyForm& form, ElementId cushion) const;
    void addCoverChoice(PropertyForm& form, ElementId cushion) const;
    void addScan(PropertyForm& form, ElementId id) const;
    void addTwin(PropertyForm& form, ElementId id) const;
    void addSymmetry(PropertyForm& form) const;
    void addUnusable(PropertyForm& form, ElementId id) const;
    /// The coordinates of the only selected control point.
    void addSelectedPoint(PropertyForm& form, ElementId id) const;
    void addPatchPoint(PropertyForm& form, ElementId id, int point) const;
    void addCurvePoint(PropertyForm& form, ElementId id, int point) const;
    void addFabricChoice(PropertyForm& form, ElementId patch) const;
    void addScanReport(PropertyForm& form, ElementId id) const;
    void addScanCuts(PropertyForm& form, ElementId id) const;
    static QStringList matchNames();

    Document& m_document;
    Selection& m_selection;
    ProblemSet& m_problems;
    std::function<void(ElementId)> m_chooseFile;
    std::function<void(ElementId, ScanWish)> m_scanWish;
    std::map<ElementId, ScanFigures> m_scanFigures;
};

} // namespace bolster
