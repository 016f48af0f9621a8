// What a kind of element says of each of its fields, once, for everything that treats all kinds alike: reading and
// writing the text form, its rules, references, differences, what a change costs the solver, forms, schema.
//
// Beside each struct lies its description (FabricFields.h ...):
//
//     template <>
//     struct Description<Fabric> {
//         template <class V, class... S>
//         static void of(V& v, S&... s)
//         {
//             v.field({.key = "poisson", ...}, Number{-0.5, 0.5}, s.poisson...);
//         }
//     };
//
// A walker `v` has `field(Field, form, values...)` for each form of field it cares about, and what is nested:
// `group`, `part`, `within`, `list`, `usual`. It walks one value, or two in step: before and after, given and
// usual.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

// The same definition as Qt's, so that lupdate finds the words and both headers can meet.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif

namespace bolster {

/// What a change asks of the solver, from little to much.
enum class SolveCost {
    Nothing,   ///< names, colours, layout, frames that nothing comes from: the surface stays
    Republish, ///< depth and profile of fancy seams: the solution stays, what is shown of it changes
    Retarget,  ///< right-hand sides only: what is held has moved, pressure, Poisson parameter, cushions, scans
    Refactor,  ///< matrix values too: stiffness, bending length, continuity
    Warp,      ///< points of outlines and of curves in them have moved: the triangulation is bent while they do
    Rebuild,   ///< outlines, curves in them, edge length: triangulate again, positions and frames are carried over
    Resew      ///< Rebuild, and seams or fixations came or went, so that the surface is torn
};

/// Whether the key stands in the text form.
enum class Presence {
    Unusual, ///< only with another value than the usual one
    Always,  ///< always written, but a text does without it
    Required ///< a text without it is wrong
};

struct Field {
    const char* key = "";     ///< of the text form
    const char* label = "";   ///< in forms and lists, to be translated in the context "Field"
    const char* meaning = ""; ///< a phrase for documents and schema
    const char* tip = "";     ///< a sentence for who waits with the pointer over it, context "Field"
    const char* verb = "";    ///< of its edit, with the element's name as %1, in the context "Message"
    SolveCost cost = SolveCost::Nothing;
    Presence presence = Presence::Unusual;
    bool counts = true; ///< with the present values of the others; what does not is not checked
    /// Required unless one of these keys stands beside it.
    std::array<const char*, 2> unless{};
    const char* alone = "";   ///< the label where no heading beside it says what it is of; else the label
    const char* without = ""; ///< what it is called that there is none, if not the usual; context "Field"
};

/// Of all that have a name.
inline constexpr Field nameField{
    .key = "name", .label = QT_TRANSLATE_NOOP("Field", "Name"), .presence = Presence::Required};

/// Of all elements.
inline constexpr Field noteField{
    .key = "note",
    .label = QT_TRANSLATE_NOOP("Field", "Note"),
    .meaning = "what people write at it for each other, in any number of lines; it changes nothing else",
    .tip =
        QT_TRANSLATE_NOOP("Field", "For whoever works on the design: it changes neither the cover nor what is cut"),
    .verb = QT_TRANSLATE_NOOP("Message", "Change the note of %1")};

enum class Unit { None, Millimetres, Degrees, Percent, MillimetresPerUnit };

inline constexpr double noLimit = std::numeric_limits<double>::infinity();

/// What a box for a number is like, where that is not what its limits say.
struct NumberBoxing {
    double step = 1;
    int decimals = 2;
    double least = -noLimit; ///< narrower than the rule
    double most = noLimit;
    double sliderLeast = 0; ///< what a slider covers; the box beside it takes more
    double sliderMost = 0;  ///< 0: no slider
};

/// A double within limits.
struct Number {
    double least = -noLimit;
    double most = noLimit;
    Unit unit = Unit::None;
    NumberBoxing box{};
    bool checked = true; ///< the rule is a general one; else the kind has a rule of its own
};

/// A bool.
struct Flag {};

/// A std::string for people.
struct Text {};

/// "#rrggbb", lower case.
struct Color {
    bool mayBeEmpty = false; ///< then it follows from something else
};

/// Of a file in the design's folder.
struct FileName {};

/// A std::vector<std::string>.
struct Names {};

/// An enum: word i of the text form, and of the list to choose from, is that of value i.
struct Words {
    std::span<const char* const> keys;
    std::span<const char* const> labels; ///< context "Field"
};

/// How an element stands to another one that it refers to.
enum class Need {
    Needed, ///< it cannot be without: goes with it, comes with it, is left out without it
    Listed, ///< a list of ids; the same, but a removed one only leaves the list unless it was the last
    Seen,   ///< comes with it; goes back to the usual when that is removed
    Shown,  ///< goes back to the usual when that is removed
    Linked  ///< whoever cares for such links sees to it
};

/// An ElementId, or a std::vector of them, of elements of kind T.
template <class T>
struct Refers {
    using Kind = T;
    Need need = Need::Needed;
    bool checked = true; ///< as with numbers
};

/// Numbers of a Vec2 or Vec3, each within limits.
struct Coordinates {
    double least = -1e7;
    double most = 1e7;
    Unit unit = Unit::Millimetres;
    NumberBoxing box{};
};

/// A Vec2 or Vec3 whose rule is the kind's own.
struct Direction {};

/// A Quat of length 1.
struct Turn {};

/// A BSpline2 or BSpline3. Where it is emptied or filled, what it holds comes or goes: SolveCost::Resew.
struct Curve {
    bool outline = false; ///< closed, and with a rule of its own
};

/// std::optional<std::pair<double, double>>: part of a curve; the key is that of its start.
struct CurveRange {
    const char* endKey;
};

/// An Orientation but for its weight; the key is that of normals. Without directions nothing is held, so a change
/// from or to that is a SolveCost::Rebuild.
struct Directions {
    const char* tangentKey;
};

/// std::vector<int>: numbers of points, increasing, each once.
struct PointNumbers {};

/// std::vector<HalfSpace>.
struct Planes {
    std::size_t most;
};

/// A std::vector of structs with descriptions. The messages are those of reading, keys of the context "Message".
struct Entries {
    const char* wrongList;
    const char* wrongEntry;
    std::size_t most = std::numeric_limits<std::size_t>::max(); ///< %1 of wrongList
    bool mayBeEmpty = true;                                     ///< in the text; else an empty list is a mistake
};

/// What a kind is called in the window; to be translated in the context "ElementText".
struct KindNames {
    int place;           ///< among the kinds in lists
    const char* one;     ///< "Patch"
    const char* many;    ///< "Patches"
    const char* counted; ///< "%1 patches"
    const char* icon;    ///< of resources/icons
};

/// Specialised for every kind and every struct that is a part of some.
///   static constexpr const char* word: of kinds, in the text form
///   static constexpr KindNames names: of kinds
///   static constexpr const char* added: of kinds, the verb of adding one, with its name as %1
///   static SolveCost comes(const T&): of kinds, what one that comes or goes asks of the solver
///   static constexpr bool shapesNothing: of kinds that are no business of the solver's, whatever their parts say
///   static constexpr const char* section: of parts, where docs/design-json.md is about it
///   static constexpr const char* wrong: of parts, what is said where there is something else than an object
///   static T usual(const T&): where a field decides the usual values of the others; `of` calls v.usual(s...)
///   template <class V, class... S> static void of(V& v, S&... s)
template <class T>
struct Description;

/// For v.part: what a struct has from its base.
template <class B>
const B& asBase(const B& value)
{
    return value;
}
template <class B>
B& asBase(B& value)
{
    return value;
}

template <class T>
T usualOf(const T& value)
{
    if constexpr (requires { Description<T>::usual(value); })
        return Description<T>::usual(value);
    else
        return T{};
}

} // namespace bolster
