// What the inspector shows of the elements of one kind.
#pragma once

#include "DesignFiles.h"
#include "FabricPictures.h"
#include "PropertyForm.h"
#include "ScanFigures.h"

#include <functional>
#include <map>
#include <vector>

namespace bolster {

class ElementForm {
public:
    using Ids = std::vector<ElementId>; ///< of the kind, at least one

    ElementForm() = default;
    virtual ~ElementForm() = default;
    ElementForm(const ElementForm&) = delete;
    ElementForm& operator=(const ElementForm&) = delete;

    /// The properties of all of them, each in one row.
    virtual void add(PropertyForm& form, const Ids& ids) const = 0;
    /// Numbers that decide which rows there are: with others the form is made anew while somebody types in it, too.
    virtual std::vector<int> rowsDependOn(const Ids&) const { return {}; }
};

/// What is known of elements beside the design, as it came last.
struct FormSources {
    DesignFiles files;
    std::map<ElementId, ScanFigures> scanFigures;
    std::map<ElementId, FabricPictures> fabricPictures;
    std::map<ElementId, double> coverLengths; ///< of measurements on the cover, mm
};

/// What the user wants of a scan beyond its numbers.
enum class ScanWish { Align, FitPlacement, CutAway, KeepOnly, KeepAroundCover, ShowAll };

/// What forms ask of the window.
struct FormWishes {
    std::function<void(ElementId)> chooseFile;
    std::function<void(ElementId, ScanWish)> workOnScan;
    /// None of them: nothing is pointed at any more.
    std::function<void(ElementId frame, const std::vector<int>& pieces)> pointAtPieces;
};

} // namespace bolster
