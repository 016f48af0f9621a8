#include "ElementReader.h"

#include <algorithm>
#include <cmath>

namespace bolster::json {

namespace {

constexpr std::size_t mostScanCuts = 1000;
constexpr std::size_t mostScanPlanes = 100;

template <int Dim>
std::vector<Eigen::Matrix<double, Dim, 1>> pointsIn(Fields& fields)
{
    std::vector<Eigen::Matrix<double, Dim, 1>> points;
    const Value* list = fields.required("points");
    const std::string field = fields.fieldOf("points");
    if (list && !list->isArray())
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of points in square brackets")});
    else if (list && list->size() > mostCurvePoints)
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "a curve has at most %1 points"),
                                    {std::to_string(mostCurvePoints)}});
    else if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            points.push_back(
                vectorIn<Dim>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate));
        });
    return points;
}

// Calls visit(item, its field) for each item of an optional list.
template <class Visit>
void eachOptional(Fields& fields, std::string_view key, Visit visit)
{
    const Value* list = fields.optional(key);
    const std::string field = fields.fieldOf(key);
    if (list && !list->isArray())
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of numbers in square brackets")});
    if (list && list->isArray())
        list->eachItem(
            [&](std::size_t i, const Value& item) { visit(item, field + "[" + std::to_string(i) + "]"); });
}

std::vector<double> knotsIn(Fields& fields)
{
    std::vector<double> knots;
    eachOptional(fields, "knots", [&](const Value& item, const std::string& field) {
        knots.push_back(numberIn(item, field, fields.report(), largestCoordinate));
    });
    return knots;
}

std::vector<int> cornersIn(Fields& fields, int pointCount)
{
    std::vector<int> corners;
    eachOptional(fields, "corners", [&](const Value& item, const std::string& field) {
        corners.push_back(integerIn(item, field, fields.report(), 0, std::max(pointCount - 1, 0)));
    });
    return corners;
}

// An empty list of knots or corners is a mistake, not a wish for the default.
void refuseEmpty(Fields& fields, std::string_view key)
{
    const Value* list = fields.optional(key);
    if (list && list->isArray() && list->size() == 0)
        fields.report().add(fields.fieldOf(key), {QT_TRANSLATE_NOOP("Message", "the list is empty; leave it out")});
}

/// A curve, empty when something is wrong with it.
template <int Dim>
BSpline<Dim> readCurve(Fields& parent, std::string_view key)
{
    const Value* object = parent.required(key);
    Report& report = parent.report();
    if (!object)
        return {};
    if (!object->isObject()) {
        report.add(parent.fieldOf(key),
                   {QT_TRANSLATE_NOOP("Message", "must be a curve in braces, with degree, closed "
                                                 "and points")});
        return {};
    }
    const std::size_t before = report.count();
    const auto sound = [&] { return report.count() == before; };
    Fields fields(*object, parent.fieldOf(key) + ".", report);
    const Value* degreeValue = fields.required("degree");
    const int degree = degreeValue ? integerIn(*degreeValue, fields.fieldOf("degree"), report, 1, 3) : 1;
    const bool closed = fields.flag("closed");
    const auto points = pointsIn<Dim>(fields);
    const std::vector<double> knots = knotsIn(fields);
    const std::vector<int> corners = cornersIn(fields, static_cast<int>(points.size()));
    refuseEmpty(fields, "knots");
    refuseEmpty(fields, "corners");
    if (fields.has("knots") && fields.has("corners"))
        report.add(fields.fieldOf("corners"), {QT_TRANSLATE_NOOP("Message", "a curve has either corners or knots; "
                                                                            "remove one of them")});
    fields.finish();

    using Curve = BSpline<Dim>;
    const auto require = [&](std::string_view field, const std::optional<Message>& wrong) {
        if (wrong)
            report.add(fields.fieldOf(field), *wrong);
    };
    if (sound())
        require("points", Curve::problem(degree, closed, points));
    if (sound() && !knots.empty())
        require("knots", Curve::problem(degree, closed, points, knots));
    if (sound() && !corners.empty())
        require("corners", Curve::cornerProblem(degree, closed, static_cast<int>(points.size()), corners));
    if (!sound())
        return {};
    return corners.empty() ? Curve(degree, closed, points, knots) : Curve::withCorners(points, corners);
}

std::string readColor(Fields& fields, std::string_view key, const std::string& fallback)
{
    std::string color = fields.text(key, fallback);
    for (char& c : color)
        c = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
    return color;
}

/// The object under a key, if there is one; else, or if it is none, null.
const Value* optionalObject(Fields& fields, std::string_view key)
{
    const Value* object = fields.optional(key);
    if (object && !object->isObject()) {
        fields.report().add(fields.fieldOf(key), {QT_TRANSLATE_NOOP("Message", "must be an object in braces")});
        return nullptr;
    }
    return object;
}

FabricLook readLook(Fields& parent)
{
    const Value* object = optionalObject(parent, "look");
    if (!object)
        return {};
    Fields fields(*object, parent.fieldOf("look") + ".", parent.report());
    FabricLook look = usualLook(static_cast<FabricLook::Kind>(fields.choice(
        "kind", {"plain", "checker", "smooth_leather", "grained_leather", "woven", "velvet", "image"})));
    look.secondColor = readColor(fields, "second_color", look.secondColor);
    look.roughness = fields.number("roughness", look.roughness);
    look.scale = fields.number("scale_mm", look.scale);
    look.rotation = fields.number("rotation", look.rotation);
    look.relief = fields.number("relief", look.relief);
    look.file = fields.text("file", look.file);
    fields.finish();
    return look;
}

StretchLimits readLimits(Fields& parent)
{
    StretchLimits limits;
    const Value* object = optionalObject(parent, "limits");
    if (!object)
        return limits;
    Fields fields(*object, parent.fieldOf("limits") + ".", parent.report());
    limits.along = fields.number("along", limits.along);
    limits.across = fields.number("across", limits.across);
    limits.shear = fields.number("shear", limits.shear);
    fields.finish();
    return limits;
}

SeamTrim readTrim(Fields& parent)
{
    SeamTrim trim;
    const Value* object = optionalObject(parent, "trim");
    if (!object)
        return trim;
    Fields fields(*object, parent.fieldOf("trim") + ".", parent.report());
    trim.stitch = static_cast<SeamTrim::Stitch>(fields.choice("stitch", {"none", "single", "twin"}));
    trim.thread = readColor(fields, "thread", trim.thread);
    trim.stitchLength = fields.number("stitch_length_mm", trim.stitchLength);
    trim.stitchDistance = fields.number("stitch_distance_mm", trim.stitchDistance);
    trim.threadWidth = fields.number("thread_width_mm", trim.threadWidth);
    trim.pipingRadius = fields.number("piping_radius_mm", trim.pipingRadius);
    if (fields.has("piping_fabric"))
        trim.pipingFabric = fields.id("piping_fabric");
    trim.allowance = fields.number("allowance_mm", trim.allowance);
    trim.valley = fields.flag("valley", trim.valley);
    fields.finish();
    return trim;
}

Fabric readFabric(Fields& fields)
{
    Fabric fabric;
    fabric.name = fields.text("name");
    fabric.poisson = fields.number("poisson", fabric.poisson);
    fabric.stiffness = fields.number("stiffness", fabric.stiffness);
    fabric.bendingLength = fields.number("bending_length", fabric.bendingLength);
    fabric.color = readColor(fields, "color", fabric.color);
    fabric.look = readLook(fields);
    fabric.limits = readLimits(fields);
    return fabric;
}

std::optional<Twin> readTwin(Fields& parent)
{
    const Value* object = optionalObject(parent, "twin");
    if (!object)
        return std::nullopt;
    Fields fields(*object, parent.fieldOf("twin") + ".", parent.report());
    Twin twin;
    twin.of = fields.id("of");
    eachOptional(fields, "released", [&](const Value& item, const std::string& field) {
        twin.released.push_back(integerIn(item, field, fields.report(), 0, 2 * mostCurvePoints - 1));
    });
    refuseEmpty(fields, "released");
    std::sort(twin.released.begin(), twin.released.end());
    twin.released.erase(std::unique(twin.released.begin(), twin.released.end()), twin.released.end());
    fields.finish();
    return twin;
}

Patch readPatch(Fields& fields)
{
    Patch patch;
    patch.name = fields.text("name");
    patch.fabric = fields.id("fabric");
    patch.position = fields.vector<2>("position", patch.position);
    patch.rotation = fields.number("rotation", patch.rotation);
    patch.grain = fields.number("grain", patch.grain);
    patch.pressure = fields.number("pressure", patch.pressure);
    patch.wrongSideOut = fields.flag("wrong_side_out", patch.wrongSideOut);
    patch.twin = readTwin(fields);
    patch.outline = readCurve<2>(fields, "outline");
    if (!patch.outline.empty() && !patch.outline.closed())
        fields.report().add("outline.closed",
                            {QT_TRANSLATE_NOOP("Message", "an outline must be closed; write true")});
    return patch;
}

Stretch readStretch(Fields& fields)
{
    const ElementId patch = fields.id("patch");
    const double from = fields.number("from");
    return {patch, from, fields.number("to")};
}

Stretch readStretch(Fields& parent, std::string_view key)
{
    const Value* object = parent.required(key);
    if (object && !object->isObject())
        parent.report().add(parent.fieldOf(key), {QT_TRANSLATE_NOOP("Message", "must be a stretch in braces, with "
                                                                               "patch, from and to")});
    if (!object || !object->isObject())
        return {};
    Fields fields(*object, parent.fieldOf(key) + ".", parent.report());
    const Stretch stretch = readStretch(fields);
    fields.finish();
    return stretch;
}

Match readMatch(Fields& fields)
{
    return static_cast<Match>(fields.choice("match", {"length", "parameter"}));
}

Seam readSeam(Fields& fields)
{
    Seam seam;
    seam.a = readStretch(fields, "a");
    seam.b = readStretch(fields, "b");
    seam.reversed = fields.flag("reversed", seam.reversed);
    seam.match = readMatch(fields);
    seam.continuity = static_cast<Continuity>(fields.choice("continuity", {"C0", "C1", "G1"}));
    seam.trim = readTrim(fields);
    return seam;
}

FixationCurve readFixationCurve(Fields& fields)
{
    FixationCurve fixation;
    fixation.name = fields.text("name");
    fixation.twin = readTwin(fields);
    fixation.curve = readCurve<3>(fields, "curve");
    return fixation;
}

/// One direction or a list of them.
std::vector<Vec3> readDirections(Fields& fields, std::string_view key)
{
    const Value* value = fields.required(key);
    const std::string field = fields.fieldOf(key);
    bool isList = false;
    if (value && value->isArray())
        value->eachItem([&](std::size_t, const Value& item) { isList = isList || item.isArray(); });
    std::vector<Vec3> directions;
    if (value && !isList)
        directions.push_back(vectorIn<3>(*value, field, fields.report(), largestCoordinate));
    else if (value)
        value->eachItem([&](std::size_t i, const Value& item) {
            directions.push_back(
                vectorIn<3>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate));
        });
    return directions;
}

Orientation readOrientation(Fields& fields)
{
    Orientation orientation;
    if (fields.has("normal") && fields.has("tangent"))
        fields.report().add("tangent",
                            {QT_TRANSLATE_NOOP("Message", "there is either a normal or a tangent; remove "
                                                          "one of them")});
    if (fields.has("normal"))
        orientation.directions = readDirections(fields, "normal");
    if (fields.has("tangent")) {
        orientation.kind = Orientation::Kind::Tangent;
        orientation.directions = readDirections(fields, "tangent");
    }
    orientation.weight = fields.number("normal_weight", orientation.weight);
    return orientation;
}

FixationSeam readFixationSeam(Fields& fields)
{
    FixationSeam seam;
    seam.stretch = readStretch(fields);
    seam.orientation = readOrientation(fields);
    if (fields.has("curve") || seam.orientation.empty())
        seam.curve = fields.id("curve");
    if (fields.has("curve_from") || fields.has("curve_to")) {
        const double from = fields.number("curve_from");
        seam.curveRange = {from, fields.number("curve_to")};
    }
    seam.reversed = fields.flag("reversed", seam.reversed);
    seam.match = readMatch(fields);
    seam.trim = readTrim(fields);
    return seam;
}

OutlineTrim readOutlineTrim(Fields& fields)
{
    const Stretch stretch = readStretch(fields);
    return {stretch, readTrim(fields)};
}

void readPlacement(Fields& fields, Placement& placement)
{
    placement.scale = fields.number("scale", placement.scale);
    placement.position = fields.vector<3>("position", placement.position);
    const Eigen::Vector4d wxyz = fields.vector<4>("rotation", {1, 0, 0, 0});
    placement.rotation = Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    const double size = wxyz.norm();
    if (!(std::abs(size - 1) <= 1e-3) && fields.has("rotation"))
        fields.report().add("rotation",
                            {QT_TRANSLATE_NOOP("Message", "must be a quaternion [w, x, y, z] of length 1, "
                                                          "not of length %1"),
                             {numberText(size)}});
    else if (std::abs(size - 1) > 1e-14) // what is normalised already stays bit for bit
        placement.rotation.normalize();
}

FrameMaterial readMaterial(Fields& parent)
{
    const Value* object = optionalObject(parent, "material");
    if (!object)
        return {};
    Fields fields(*object, parent.fieldOf("material") + ".", parent.report());
    FrameMaterial material;
    material.kind =
        static_cast<FrameMaterial::Kind>(fields.choice("kind", {"plain", "wood", "metal", "plastic", "foam"}));
    material.color = readColor(fields, "color", material.color);
    fields.finish();
    return material;
}

std::vector<std::string> namesIn(Fields& fields, std::string_view key)
{
    std::vector<std::string> names;
    eachOptional(fields, key, [&](const Value& item, const std::string& field) {
        if (item.kind() == Kind::String)
            names.push_back(item.string());
        else
            fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a text in quotation marks")});
    });
    refuseEmpty(fields, key);
    return names;
}

Frame readFrame(Fields& fields)
{
    Frame frame;
    frame.name = fields.text("name");
    frame.file = fields.text("file");
    readPlacement(fields, frame);
    frame.contact = fields.flag("contact", frame.contact);
    frame.contactGap = fields.number("contact_gap", frame.contactGap);
    frame.material = readMaterial(fields);
    frame.hiddenParts = namesIn(fields, "hidden_parts");
    return frame;
}

void readPatchCurve(Fields& fields, PatchCurve& line)
{
    line.name = fields.text("name");
    line.patch = fields.id("patch");
    line.twin = readTwin(fields);
    line.curve = readCurve<2>(fields, "curve");
}

HandleCurve readHandleCurve(Fields& fields)
{
    HandleCurve handle;
    readPatchCurve(fields, handle);
    handle.orientation = readOrientation(fields);
    if (fields.has("target") || handle.orientation.empty())
        handle.target = readCurve<3>(fields, "target");
    handle.match = readMatch(fields);
    return handle;
}

FancySeam readFancySeam(Fields& fields)
{
    FancySeam seam;
    readPatchCurve(fields, seam);
    seam.width = fields.number("width", seam.width);
    seam.depth = fields.number("depth", seam.depth);
    seam.profile = static_cast<Profile>(fields.choice("profile", {"round", "sharp", "welt"}));
    seam.trim = readTrim(fields);
    return seam;
}

std::vector<ElementId> patchesIn(Fields& fields)
{
    std::vector<ElementId> patches;
    eachOptional(fields, "patches", [&](const Value& item, const std::string& field) {
        patches.push_back(ElementId{integerIn(item, field, fields.report(), 1, largestElementId)});
    });
    refuseEmpty(fields, "patches");
    return patches;
}

Colourway readColourway(Fields& parent)
{
    Colourway colourway;
    colourway.name = parent.text("name");
    const Value* list = parent.optional("fabrics");
    const std::string field = parent.fieldOf("fabrics");
    Report& report = parent.report();
    if (list && !list->isArray())
        report.add(field,
                   {QT_TRANSLATE_NOOP("Message", "must be a list of pairs in braces, with patch and fabric")});
    else if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            const std::string at = field + "[" + std::to_string(i) + "]";
            if (!item.isObject()) {
                report.add(at, {QT_TRANSLATE_NOOP("Message", "must be a pair in braces, with patch and fabric")});
                return;
            }
            Fields fields(item, at + ".", report);
            const ElementId patch = fields.id("patch");
            colourway.fabrics.push_back({patch, fields.id("fabric")});
            fields.finish();
        });
    refuseEmpty(parent, "fabrics");
    return colourway;
}

Cushion readCushion(Fields& fields)
{
    Cushion cushion;
    cushion.name = fields.text("name");
    cushion.frame = fields.id("frame");
    cushion.parts = namesIn(fields, "parts");
    cushion.patches = patchesIn(fields);
    cushion.voxel = fields.number("voxel_mm", cushion.voxel);
    cushion.dilation = fields.number("dilation_mm", cushion.dilation);
    cushion.strength = fields.number("strength", cushion.strength);
    cushion.distance = static_cast<Cushion::Distance>(fields.choice("distance", {"city-block", "euclidean"}));
    cushion.enabled = fields.flag("enabled", cushion.enabled);
    return cushion;
}

Foam readFoam(Fields& fields)
{
    Foam foam;
    foam.name = fields.text("name");
    foam.cushion = fields.id("cushion");
    foam.shape = static_cast<Foam::Shape>(fields.choice("shape", {"box", "cylinder", "sphere", "mesh"}));
    foam.size = fields.vector<3>("size", foam.size);
    foam.file = fields.text("file", foam.file);
    readPlacement(fields, foam);
    foam.dilation = fields.number("dilation_mm", foam.dilation);
    foam.strength = fields.number("strength", foam.strength);
    foam.cut = fields.flag("cut", foam.cut);
    return foam;
}

std::vector<HalfSpace> readHalfSpaces(Fields& fields)
{
    std::vector<HalfSpace> halfSpaces;
    const Value* list = fields.required("planes");
    const std::string field = fields.fieldOf("planes");
    if (list && (!list->isArray() || list->size() > mostScanPlanes)) {
        fields.report().add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of at most %1 planes, "
                                                                 "[x, y, z, distance] each"),
                                    {std::to_string(mostScanPlanes)}});
        return halfSpaces;
    }
    if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            const Eigen::Vector4d plane =
                vectorIn<4>(item, field + "[" + std::to_string(i) + "]", fields.report(), largestCoordinate);
            halfSpaces.push_back({plane.head<3>(), plane[3]});
        });
    return halfSpaces;
}

std::vector<ScanCut> readCuts(Fields& parent)
{
    std::vector<ScanCut> cuts;
    const Value* list = parent.optional("cuts");
    const std::string field = parent.fieldOf("cuts");
    Report& report = parent.report();
    if (list && (!list->isArray() || list->size() > mostScanCuts))
        report.add(field, {QT_TRANSLATE_NOOP("Message", "must be a list of at most %1 cuts in braces"),
                           {std::to_string(mostScanCuts)}});
    else if (list)
        list->eachItem([&](std::size_t i, const Value& item) {
            const std::string at = field + "[" + std::to_string(i) + "]";
            if (!item.isObject()) {
                report.add(at, {QT_TRANSLATE_NOOP("Message", "must be a cut in braces, with planes")});
                return;
            }
            Fields fields(item, at + ".", report);
            cuts.push_back({readHalfSpaces(fields), fields.flag("keep", false)});
            fields.finish();
        });
    return cuts;
}

Scan readScan(Fields& fields)
{
    Scan scan;
    scan.name = fields.text("name");
    scan.file = fields.text("file");
    readPlacement(fields, scan);
    scan.threshold = fields.number("threshold_mm", scan.threshold);
    scan.strength = fields.number("strength", scan.strength);
    scan.enabled = fields.flag("enabled", scan.enabled);
    scan.target = static_cast<ScanTarget>(fields.choice("target", {"plane", "point"}));
    scan.cuts = readCuts(fields);
    return scan;
}

std::optional<Symmetry> readSymmetry(Fields& parent)
{
    const Value* object = optionalObject(parent, "symmetry");
    if (!object)
        return std::nullopt;
    Symmetry symmetry;
    Fields fields(*object, parent.fieldOf("symmetry") + ".", parent.report());
    if (const Value* plane = optionalObject(fields, "plane")) {
        Fields numbers(*plane, fields.fieldOf("plane") + ".", parent.report());
        symmetry.planePoint = numbers.vector<3>("point", symmetry.planePoint);
        symmetry.planeNormal = numbers.vector<3>("normal", symmetry.planeNormal);
        numbers.finish();
    }
    if (const Value* axis = optionalObject(fields, "axis")) {
        Fields numbers(*axis, fields.fieldOf("axis") + ".", parent.report());
        symmetry.axisPoint = numbers.vector<2>("point", symmetry.axisPoint);
        symmetry.axisDirection = numbers.vector<2>("direction", symmetry.axisDirection);
        numbers.finish();
    }
    fields.finish();
    return symmetry;
}

template <class T>
ElementPtr finished(T value, Fields& fields)
{
    fields.finish();
    return fields.report().clean() ? makeElement(std::move(value)) : nullptr;
}

std::string textOf(const Value& object, std::string_view wanted)
{
    std::string text;
    object.eachMember([&](const std::string& key, const Value& value) {
        if (key == wanted && text.empty())
            text = value.string();
    });
    return text;
}

} // namespace

Heading headingOf(const Value& element, std::size_t position)
{
    Heading heading;
    if (element.isObject()) {
        Report ignored(ElementId{}, {});
        Fields fields(element, "", ignored);
        if (const Value* id = fields.optional("id")) {
            Report wrong(ElementId{}, {});
            const int number = integerIn(*id, "id", wrong, 1, largestElementId);
            heading.id = wrong.clean() ? ElementId{number} : ElementId{};
        }
    }
    if (heading.id == ElementId{})
        heading.label = "elements[" + std::to_string(position) + "]";
    else
        heading.label = elementLabel(textOf(element, "kind"), heading.id, textOf(element, "name"));
    return heading;
}

Settings readSettings(const Value& object, Report& report)
{
    Settings settings;
    if (!object.isObject()) {
        report.add("", {QT_TRANSLATE_NOOP("Message", "must be an object in braces")});
        return settings;
    }
    Fields fields(object, "", report);
    Settings read;
    read.edgeLength = fields.number("edge_length", settings.edgeLength);
    read.symmetry = readSymmetry(fields);
    if (fields.has("colourway"))
        read.colourway = fields.id("colourway");
    fields.finish();
    return report.clean() ? read : settings;
}

ElementPtr readElement(const Value& object, Report& report)
{
    if (!object.isObject()) {
        report.add("", {QT_TRANSLATE_NOOP("Message", "an element must be an object in braces")});
        return nullptr;
    }
    Fields fields(object, "", report);
    fields.id("id");
    const std::string kind = fields.text("kind");
    if (kind == "fabric")
        return finished(readFabric(fields), fields);
    if (kind == "patch")
        return finished(readPatch(fields), fields);
    if (kind == "seam")
        return finished(readSeam(fields), fields);
    if (kind == "fixation_curve")
        return finished(readFixationCurve(fields), fields);
    if (kind == "fixation_seam")
        return finished(readFixationSeam(fields), fields);
    if (kind == "frame")
        return finished(readFrame(fields), fields);
    if (kind == "handle_curve")
        return finished(readHandleCurve(fields), fields);
    if (kind == "fancy_seam")
        return finished(readFancySeam(fields), fields);
    if (kind == "cushion")
        return finished(readCushion(fields), fields);
    if (kind == "foam")
        return finished(readFoam(fields), fields);
    if (kind == "scan")
        return finished(readScan(fields), fields);
    if (kind == "colourway")
        return finished(readColourway(fields), fields);
    if (kind == "outline_trim")
        return finished(readOutlineTrim(fields), fields);
    if (fields.has("kind") && fields.report().clean())
        report.add("kind", {QT_TRANSLATE_NOOP("Message", "the kind %1 is unknown; there are fabric, patch, seam, "
                                                         "fixation_curve, fixation_seam, frame, handle_curve, "
                                                         "fancy_seam, cushion, foam, scan, colourway "
                                                         "and outline_trim"),
                            {quoted(kind)}});
    return nullptr;
}

} // namespace bolster::json
