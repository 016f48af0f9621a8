// One thing that the user made.
#pragma once

#include "Colourway.h"
#include "Cushion.h"
#include "CutCorner.h"
#include "DrillHole.h"
#include "EdgeAllowance.h"
#include "Fabric.h"
#include "FancySeam.h"
#include "FixationCurve.h"
#include "FixationSeam.h"
#include "Foam.h"
#include "Frame.h"
#include "HandleCurve.h"
#include "InternalLine.h"
#include "Measurement.h"
#include "Notch.h"
#include "OutlineTrim.h"
#include "Patch.h"
#include "Quarantined.h"
#include "Scan.h"
#include "Seam.h"
#include "Settings.h"
#include "Twin.h"

#include <memory>
#include <string_view>
#include <variant>

namespace bolster {

using Element = std::variant<Settings, Fabric, Patch, Seam, FixationCurve, FixationSeam, Frame, HandleCurve,
                             FancySeam, Cushion, Foam, Scan, Colourway, OutlineTrim, EdgeAllowance, CutCorner,
                             Notch, DrillHole, InternalLine, Measurement, Quarantined>;
using ElementPtr = std::shared_ptr<const Element>;

template <class T>
ElementPtr makeElement(T value)
{
    return std::make_shared<const Element>(std::move(value));
}

/// The word of the text form: "patch", "fixation_seam" ...
const char* kindName(const Element& element);
/// Whether elements of its kind have a name of their own.
bool hasName(const Element& element);
/// The element's own name, or "" for kinds without one.
const std::string& elementName(const Element& element);
/// What people have written at it, or "" also for the settings.
const std::string& elementNote(const Element& element);
/// The same element with another note; it must be of a kind with one.
ElementPtr withNote(const Element& element, std::string note);
/// The file that the element refers to, or null for those without one.
const std::string* elementFile(const Element& element);
/// The field that names it, for problems: "file", or "look.file".
const char* elementFileField(const Element& element);
/// Whether elementFile is a mesh or a cloud, part of DesignFiles; the image of a fabric is neither.
bool hasShapeFile(const Element& element);
/// The same element with another file; it must be of a kind with one.
ElementPtr withFile(const Element& element, std::string file);
/// Stitches and piping of seams of all kinds and of outline trims, or null for other kinds.
const SeamTrim* seamTrim(const Element& element);
/// The same element with other ones; it must be of a kind with a trim.
ElementPtr withTrim(const Element& element, SeamTrim trim);
/// What a handle curve, fancy seam or internal line draws in a patch, or null for other kinds.
const PatchCurve* patchCurve(const Element& element);
/// The same, but for lines that only a cutter sees.
const PatchCurve* shapingCurve(const Element& element);
/// Seams of all kinds, outline trims, handle curves and fancy seams: what a patch takes along.
bool liesOnPatch(const Element& element);
/// The curve in outline coordinates: of a patch its outline, of handle curves and fancy seams the drawn one; or
/// null.
const BSpline2* planeCurve(const Element& element);
/// The curve in space: of a fixation curve, or the target of a handle curve; or null.
const BSpline3* spaceCurve(const Element& element);
/// The same element with another one of these curves; it must be of a kind with one.
ElementPtr withPlaneCurve(const Element& element, BSpline2 curve);
ElementPtr withSpaceCurve(const Element& element, BSpline3 curve);
/// Where the element stands in space, or null for kinds that stand nowhere.
const Placement* elementPlacement(const Element& element);
/// The same element elsewhere; it must be of a kind with a placement.
ElementPtr withPlacement(const Element& element, const Placement& placement);
/// "patch 2 \"Seat\"", as problems name it.
std::string elementLabel(ElementId id, const Element& element);
std::string elementLabel(std::string_view kind, ElementId id, std::string_view name);
/// What a person can still read in a sentence: 80 bytes of UTF-8 at most, and "\u2026".
std::string shortened(std::string_view name);

} // namespace bolster
