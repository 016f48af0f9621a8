// What the inspector shows for each kind of element.
#pragma once

#include "DesignFiles.h"
#include "ElementText.h"
#include "FabricPictures.h"
#include "PropertyForm.h"
#include "ScanFigures.h"
#include "Selection.h"

#include <QCoreApplication>

#include <functional>
#include <map>
#include <memory>

namespace bolster {

class Document;
class ProblemSet;

/// What the user wants of a scan beyond its numbers.
enum class ScanWish { FitPlacement, CutAway, KeepOnly, KeepAroundCover, ShowAll };

/// Makes the form for the present selection.
class InspectorForms {
    Q_DECLARE_TR_FUNCTIONS(InspectorForms)

public:
    /// None of them: nothing is pointed at any more.
    using PointAtPieces = std::function<void(ElementId frame, const std::vector<int>& pieces)>;

    InspectorForms(Document& document, Selection& selection, ProblemSet& problems,
                   std::function<void(ElementId)> chooseFile, std::function<void(ElementId, ScanWish)> scanWish,
                   PointAtPieces pointAtPieces);

    /// As measured last.
    void setScanFigures(std::map<ElementId, ScanFigures> figures) { m_scanFigures = std::move(figures); }
    /// As drawn last.
    void setFabricPictures(std::map<ElementId, FabricPictures> pictures) { m_fabricPictures = std::move(pictures); }
    void setFiles(DesignFiles files) { m_files = std::move(files); }
    const DesignFiles& files() const { return m_files; }

    std::unique_ptr<PropertyForm> make() const;
    /// What decides which rows the form has, beside the selection and the files.
    struct Basis {
        std::vector<FabricLook::Kind> fabricKinds; ///< of the selected fabrics
        std::vector<ElementId> frames;             ///< of the selected cushions
        friend bool operator==(const Basis&, const Basis&) = default;
    };
    Basis basis() const;

private:
    using Ids = std::vector<ElementId>; ///< of one kind, at least one

    /// Of each kind its properties, those of all its elements in one field.
    void addSeveral(PropertyForm& form) const;
    void addElement(PropertyForm& form, ElementId id) const;
    void addKind(PropertyForm& form, ElementKind kind, const Ids& ids) const;
    void addSettings(PropertyForm& form) const;
    void addFabric(PropertyForm& form, const Ids& ids) const;
    void addFabricPictures(PropertyForm& form, ElementId id) const;
    void addFabricLook(PropertyForm& form, const Ids& ids) const;
    void addFabricKind(PropertyForm& form, const Ids& ids) const;
    void addPatch(PropertyForm& form, const Ids& ids) const;
    void addSeam(PropertyForm& form, const Ids& ids) const;
    void addFixationCurve(PropertyForm& form, const Ids& ids) const;
    void addCurveChoice(PropertyForm& form, const Ids& ids) const;
    void addFixationSeam(PropertyForm& form, const Ids& ids) const;
    void addHandleCurve(PropertyForm& form, const Ids& ids) const;
    void addFancySeam(PropertyForm& form, const Ids& ids) const;
    void addOutlineTrim(PropertyForm& form, const Ids& ids) const;
    /// Stitches and piping of seams of any kind.
    template <class T>
    void addTrim(PropertyForm& form, const Ids& ids) const;
    void addColourway(PropertyForm& form, const Ids& ids) const;
    void addFrame(PropertyForm& form, const Ids& ids) const;
    void addFrameMaterial(PropertyForm& form, const Ids& ids) const;
    void addCushion(PropertyForm& form, const Ids& ids) const;
    void addFoam(PropertyForm& form, const Ids& ids) const;
    /// What its file consists of, each part with a mark that shows it.
    void addFrameParts(PropertyForm& form, ElementId id) const;
    /// Those that a cushion may take, each with a mark if it does.
    void addCushionParts(PropertyForm& form, const Ids& ids) const;
    void addVoxelNote(PropertyForm& form, ElementId id) const;
    void addFrameChoice(PropertyForm& form, const Ids& cushions) const;
    void addCoverChoice(PropertyForm& form, const Ids& cushions) const;
    void addScan(PropertyForm& form, const Ids& ids) const;
    void addTwin(PropertyForm& form, ElementId id) const;
    void addMirroredSewing(PropertyForm& form, ElementId id) const;
    void addSymmetry(PropertyForm& form) const;
    void addUnusable(PropertyForm& form, const Ids& ids) const;
    /// The coordinates of the selected control points.
    void addSelectedPoints(PropertyForm& form) const;
    /// The lengths of the selected edges.
    void addSelectedEdges(PropertyForm& form) const;
    void addPatchSize(PropertyForm& form, const Ids& ids) const;
    void addPatternPoints(PropertyForm& form, const Selection::Points& points) const;
    void addSpacePoints(PropertyForm& form, const Selection::Points& points) const;
    void addFabricChoice(PropertyForm& form, const Ids& patches) const;
    /// How many points of its file there are.
    void addScanSize(PropertyForm& form, ElementId id) const;
    void addScanReport(PropertyForm& form, ElementId id) const;
    void addScanCuts(PropertyForm& form, ElementId id) const;

    Document& m_document;
    Selection& m_selection;
    ProblemSet& m_problems;
    std::function<void(ElementId)> m_chooseFile;
    std::function<void(ElementId, ScanWish)> m_scanWish;
    PointAtPieces m_pointAtPieces;
    std::map<ElementId, ScanFigures> m_scanFigures;
    std::map<ElementId, FabricPictures> m_fabricPictures;
    DesignFiles m_files;
};

} // namespace bolster
