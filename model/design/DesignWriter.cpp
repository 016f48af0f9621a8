// The canonical text of a design.
#include "DesignJson.h"

#include "JsonText.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace bolster {

namespace {

// The shortest text that reads back as the same double. JSON has no others than finite ones.
std::string text(double value)
{
    if (!std::isfinite(value))
        return "null";
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), end.ptr);
}

// Bit for bit, so that -0 is written when the default is 0.
bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Values, class ToText>
std::string listOf(const Values& values, const ToText& toText)
{
    std::string line;
    for (const auto& value : values)
        line.append(line.empty() ? "" : ", ").append(toText(value));
    return "[" + line + "]";
}

template <class Vector>
std::string list(const Vector& values)
{
    return listOf(values, text);
}

template <class Vector>
bool sameVector(const Vector& a, const Vector& b)
{
    for (Eigen::Index i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i]))
            return false;
    return true;
}

// One JSON object, key by key.
class Line {
public:
    Line& raw(std::string_view key, std::string_view value)
    {
        m_text.append(m_text.empty() ? "" : ", ").append("\"").append(key).append("\": ").append(value);
        return *this;
    }
    Line& add(std::string_view key, double value) { return raw(key, text(value)); }
    Line& add(std::string_view key, ElementId id) { return raw(key, std::to_string(number(id))); }
    Line& quoted(std::string_view key, std::string_view value) { return raw(key, json::quoted(value)); }
    Line& unless(const std::string& fallback, std::string_view key, const std::string& value)
    {
        return value == fallback ? *this : quoted(key, value);
    }
    Line& flag(std::string_view key, bool value) { return raw(key, value ? "true" : "false"); }
    Line& unless(double fallback, std::string_view key, double value)
    {
        return same(value, fallback) ? *this : add(key, value);
    }
    Line& unless(bool fallback, std::string_view key, bool value)
    {
        return value == fallback ? *this : flag(key, value);
    }
    template <class Vector>
    Line& unlessVector(const Vector& fallback, std::string_view key, const Vector& value)
    {
        return sameVector(value, fallback) ? *this : raw(key, list(value));
    }
    bool empty() const { return m_text.empty(); }
    std::string done() const { return "{" + m_text + "}"; }

private:
    std::string m_text;
};

template <int Dim>
std::string curveText(const BSpline<Dim>& curve)
{
    std::string points;
    for (const auto& point : curve.points())
        points.append(points.empty() ? "" : ", ").append(list(point));
    Line line;
    line.add("degree", curve.degree()).flag("closed", curve.closed()).raw("points", "[" + points + "]");
    if (curve.hasDefaultKnots())
        return line.done();
    if (const auto corners = curve.cornerIndices())
        return line.raw("corners", list(*corners)).done();
    return line.raw("knots", list(curve.knots())).done();
}

void addMatch(Line& line, Match match)
{
    if (match == Match::Parameter)
        line.quoted("match", "parameter");
}

void addStretch(Line& line, const Stretch& stretch)
{
    line.add("patch", stretch.patch).add("from", stretch.from).add("to", stretch.to);
}

std::string stretchText(const Stretch& stretch)
{
    Line line;
    addStretch(line, stretch);
    return line.done();
}

void addSymmetry(Line& line, const Symmetry& symmetry)
{
    const Symmetry normal;
    Line plane, axis, both;
    plane.unlessVector(normal.planePoint, "point", symmetry.planePoint)
        .unlessVector(normal.planeNormal, "normal", symmetry.planeNormal);
    axis.unlessVector(normal.axisPoint, "point", symmetry.axisPoint)
        .unlessVector(normal.axisDirection, "direction", symmetry.axisDirection);
    if (plane.done() != Line().done())
        both.raw("plane", plane.done());
    if (axis.done() != Line().done())
        both.raw("axis", axis.done());
    line.raw("symmetry", both.done());
}

void addLook(Line& line, const FabricLook& look)
{
    static constexpr std::array<const char*, 7> kinds = {"plain", "checker", "smooth_leather", "grained_leather",
                                                         "woven", "velvet",  "image"};
    const FabricLook normal = usualLook(look.kind);
    Line all;
    if (look.kind != FabricLook::Kind::Plain)
        all.quoted("kind", kinds[static_cast<std::size_t>(look.kind)]);
    all.unless(normal.secondColor, "second_color", look.secondColor)
        .unless(normal.roughness, "roughness", look.roughness)
        .unless(normal.scale, "scale_mm", look.scale)
        .unless(normal.rotation, "rotation", look.rotation)
        .unless(normal.relief, "relief", look.relief)
        .unless(normal.file, "file", look.file);
    if (!all.empty())
        line.raw("look", all.done());
}

void addLimits(Line& line, const StretchLimits& limits)
{
    const StretchLimits normal;
    Line all;
    all.unless(normal.along, "along", limits.along)
        .unless(normal.across, "across", limits.across)
        .unless(normal.shear, "shear", limits.shear);
    if (!all.empty())
        line.raw("limits", all.done());
}

void addTrim(Line& line, const SeamTrim& trim)
{
    static constexpr std::array<const char*, 3> stitches = {"none", "single", "twin"};
    const SeamTrim normal;
    Line all;
    if (trim.stitch != normal.stitch)
        all.quoted("stitch", stitches[static_cast<std::size_t>(trim.stitch)]);
    all.unless(normal.thread, "thread", trim.thread)
        .unless(normal.stitchLength, "stitch_length_mm", trim.stitchLength)
        .unless(normal.stitchDistance, "stitch_distance_mm", trim.stitchDistance)
        .unless(normal.threadWidth, "thread_width_mm", trim.threadWidth)
        .unless(normal.pipingRadius, "piping_radius_mm", trim.pipingRadius);
    if (trim.pipingFabric != normal.pipingFabric)
        all.add("piping_fabric", trim.pipingFabric);
    all.unless(normal.allowance, "allowance_mm", trim.allowance).unless(normal.valley, "valley", trim.valley);
    if (!all.empty())
        line.raw("trim", all.done());
}

void addFields(Line& line, const Settings& settings)
{
    line.add("edge_length", settings.edgeLength);
    if (settings.symmetry)
        addSymmetry(line, *settings.symmetry);
    if (settings.colourway != ElementId{})
        line.add("colourway", settings.colourway);
}

void addTwin(Line& line, const std::optional<Twin>& twin)
{
    if (!twin)
        return;
    Line link;
    link.add("of", twin->of);
    if (!twin->released.empty())
        link.raw("released", listOf(twin->released, [](int point) { return std::to_string(point); }));
    line.raw("twin", link.done());
}

void addFields(Line&, const Quarantined&) {}

void addFields(Line& line, const Fabric& fabric)
{
    const Fabric normal;
    line.quoted("name", fabric.name)
        .unless(normal.poisson, "poisson", fabric.poisson)
        .unless(normal.stiffness, "stiffness", fabric.stiffness)
        .unless(normal.bendingLength, "bending_length", fabric.bendingLength)
        .unless(normal.color, "color", fabric.color);
    addLook(line, fabric.look);
    addLimits(line, fabric.limits);
}

void addFields(Line& line, const Patch& patch)
{
    const Patch normal;
    line.quoted("name", patch.name)
        .add("fabric", patch.fabric)
        .unlessVector(normal.position, "position", patch.position)
        .unless(normal.rotation, "rotation", patch.rotation)
        .unless(normal.grain, "grain", patch.grain)
        .unless(normal.pressure, "pressure", patch.pressure)
        .unless(normal.wrongSideOut, "wrong_side_out", patch.wrongSideOut);
    addTwin(line, patch.twin);
    line.raw("outline", curveText(patch.outline));
}

void addFields(Line& line, const Seam& seam)
{
    static constexpr std::array<const char*, 3> continuities = {"C0", "C1", "G1"};
    line.raw("a", stretchText(seam.a)).raw("b", stretchText(seam.b)).unless(true, "reversed", seam.reversed);
    addMatch(line, seam.match);
    if (seam.continuity != Continuity::C0)
        line.quoted("continuity", continuities[static_cast<std::size_t>(seam.continuity)]);
    addTrim(line, seam.trim);
}

void addFields(Line& line, const FixationCurve& fixation)
{
    line.quoted("name", fixation.name);
    addTwin(line, fixation.twin);
    line.raw("curve", curveText(fixation.curve));
}

void addOrientation(Line& line, const Orientation& orientation)
{
    const auto& directions = orientation.directions;
    std::string all;
    for (const Vec3& direction : directions)
        all.append(all.empty() ? "" : ", ").append(list(direction));
    if (!directions.empty())
        line.raw(orientation.kind == Orientation::Kind::Normal ? "normal" : "tangent",
                 directions.size() == 1 ? all : "[" + all + "]");
    line.unless(1.0, "normal_weight", orientation.weight);
}

void addFields(Line& line, const FixationSeam& seam)
{
    addStretch(line, seam.stretch);
    if (seam.hasCurve())
        line.add("curve", seam.curve);
    if (seam.curveRange)
        line.add("curve_from", seam.curveRange->first).add("curve_to", seam.curveRange->second);
    line.unless(false, "reversed", seam.reversed);
    addMatch(line, seam.match);
    addOrientation(line, seam.orientation);
    addTrim(line, seam.trim);
}

void addFields(Line& line, const OutlineTrim& trimmed)
{
    addStretch(line, trimmed.stretch);
    addTrim(line, trimmed.trim);
}

void addFields(Line& line, const Colourway& colourway)
{
    line.quoted("name", colourway.name);
    const auto pairText = [](const Colourway::Entry& entry) {
        return Line().add("patch", entry.patch).add("fabric", entry.fabric).done();
    };
    if (!colourway.fabrics.empty())
        line.raw("fabrics", listOf(colourway.fabrics, pairText));
}

void addPlacement(Line& line, const Placement& placement)
{
    const Quat& q = placement.rotation;
    line.unless(1.0, "scale", placement.scale)
        .unlessVector(Vec3(0, 0, 0), "position", placement.position)
        .unlessVector(Eigen::Vector4d(1, 0, 0, 0), "rotation", Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
}

void addMaterial(Line& line, const FrameMaterial& material)
{
    static constexpr std::array<const char*, 5> kinds = {"plain", "wood", "metal", "plastic", "foam"};
    Line all;
    if (material.kind != FrameMaterial::Kind::Plain)
        all.quoted("kind", kinds[static_cast<std::size_t>(material.kind)]);
    all.unless(std::string(), "color", material.color);
    if (!all.empty())
        line.raw("material", all.done());
}

void addFields(Line& line, const Frame& frame)
{
    line.quoted("name", frame.name).quoted("file", frame.file);
    addPlacement(line, frame);
    line.unless(false, "contact", frame.contact).unless(0.0, "contact_gap", frame.contactGap);
    addMaterial(line, frame.material);
    if (!frame.hiddenParts.empty())
        line.raw("hidden_parts", listOf(frame.hiddenParts, json::quoted));
}

void addFields(Line& line, const Cushion& cushion)
{
    const Cushion normal;
    line.quoted("name", cushion.name).add("frame", cushion.frame);
    if (!cushion.parts.empty())
        line.raw("parts", listOf(cushion.parts, json::quoted));
    if (!cushion.patches.empty())
        line.raw("patches", listOf(cushion.patches, [](ElementId id) { return std::to_string(number(id)); }));
    line.unless(normal.voxel, "voxel_mm", cushion.voxel)
        .unless(normal.dilation, "dilation_mm", cushion.dilation)
        .unless(normal.strength, "strength", cushion.strength);
    if (cushion.distance == Cushion::Distance::Euclidean)
        line.quoted("distance", "euclidean");
    line.unless(normal.enabled, "enabled", cushion.enabled);
}

void addFields(Line& line, const Foam& foam)
{
    static constexpr std::array<const char*, 4> shapes = {"box", "cylinder", "sphere", "mesh"};
    const Foam normal;
    line.quoted("name", foam.name).add("cushion", foam.cushion);
    if (foam.shape != Foam::Shape::Box)
        line.quoted("shape", shapes[static_cast<std::size_t>(foam.shape)]);
    line.unlessVector(normal.size, "size", foam.size);
    if (!foam.file.empty())
        line.quoted("file", foam.file);
    addPlacement(line, foam);
    line.unless(normal.dilation, "dilation_mm", foam.dilation)
        .unless(normal.strength, "strength", foam.strength)
        .unless(normal.cut, "cut", foam.cut);
}

void addPatchCurve(Line& line, const PatchCurve& drawn)
{
    line.quoted("name", drawn.name).add("patch", drawn.patch);
    addTwin(line, drawn.twin);
    line.raw("curve", curveText(drawn.curve));
}

void addFields(Line& line, const HandleCurve& handle)
{
    addPatchCurve(line, handle);
    if (handle.hasTarget())
        line.raw("target", curveText(handle.target));
    addMatch(line, handle.match);
    addOrientation(line, handle.orientation);
}

void addFields(Line& line, const FancySeam& seam)
{
    static constexpr std::array<const char*, 3> profiles = {"round", "sharp", "welt"};
    const FancySeam normal;
    addPatchCurve(line, seam);
    line.unless(normal.width, "width", seam.width).unless(normal.depth, "depth", seam.depth);
    if (seam.profile != normal.profile)
        line.quoted("profile", profiles[static_cast<std::size_t>(seam.profile)]);
    addTrim(line, seam.trim);
}

std::string cutText(const ScanCut& cut)
{
    std::string planes;
    for (const HalfSpace& h : cut.halfSpaces)
        planes.append(planes.empty() ? "" : ", ")
            .append(list(Eigen::Vector4d(h.normal.x(), h.normal.y(), h.normal.z(), h.distance)));
    return Line().raw("planes", "[" + planes + "]").unless(false, "keep", cut.keep).done();
}

void addFields(Line& line, const Scan& scan)
{
    const Scan normal;
    line.quoted("name", scan.name).quoted("file", scan.file);
    addPlacement(line, scan);
    line.unless(normal.threshold, "threshold_mm", scan.threshold)
        .unless(normal.strength, "strength", scan.strength)
        .unless(normal.enabled, "enabled", scan.enabled);
    if (scan.target == ScanTarget::Point)
        line.quoted("target", "point");
    std::string cuts;
    for (const ScanCut& cut : scan.cuts)
        cuts.append(cuts.empty() ? "" : ", ").append(cutText(cut));
    if (!cuts.empty())
        line.raw("cuts", "[" + cuts + "]");
}

} // namespace

std::string writeElement(ElementId id, const Element& element)
{
    if (const auto* quarantined = std::get_if<Quarantined>(&element))
        return quarantined->text;
    Line line;
    if (id != settingsId)
        line.add("id", id).quoted("kind", kindName(element));
    std::visit([&](const auto& value) { addFields(line, value); }, element);
    return line.done();
}

namespace {

/// As it stands in the list of elements. The text of a quarantined one comes from anybody: what is no JSON there
/// would make all of the design unreadable, so it is written as a text in quotes, which is quarantined again.
std::string listedElement(ElementId id, const Element& element)
{
    const std::string text = writeElement(id, element);
    if (!std::holds_alternative<Quarantined>(element))
        return text;
    Message wrong;
    const bool fits = json::Document::parse(text, wrong) && json::Document::parse("[[" + text + "]]", wrong);
    return fits ? text : json::quoted(text);
}

} // namespace

std::string writeDesign(const Design& design)
{
    std::string elements;
    for (const auto& [id, element] : design.elements())
        elements.append(elements.empty() ? "\n  " : ",\n  ").append(listedElement(id, *element));
    return "{\"format\": \"bolster-design\", \"version\": 1, \"unit\": \"mm\",\n \"settings\": " +
           writeElement(settingsId, *design.element(settingsId)) + ",\n \"elements\": [" + elements + "]}\n";
}

} // namespace bolster
