// Edits as bytes: CBOR, [[element, field, before, after] ...].
#pragma once

#include "ElementFields.h"
#include "History.h"

#include <optional>
#include <string_view>

namespace bolster {

/// One key of one element's text form with its values as JSON; nothing where the element has no such key.
struct FieldChange {
    ElementId element{};
    std::string field;
    std::optional<std::string> before;
    std::optional<std::string> after;

    friend bool operator==(const FieldChange&, const FieldChange&) = default;
};
using FieldChanges = std::vector<FieldChange>; ///< by element, then by field

// More than a text holds (docs/design-json.md), so nothing that Bolster makes; files from anybody may say more.
inline constexpr std::size_t mostFieldChanges = 1'000'000;      ///< of one edit, and of a snapshot
inline constexpr std::size_t mostStoredElements = 200'000;      ///< of a design
inline constexpr std::int64_t longestStoredDesign = 32ll << 20; ///< bytes of its elements' keys and values

FieldChanges fieldChanges(const Edit& edit);

/// Bytes of keys and values.
struct TextSums {
    std::int64_t growth = 0;  ///< how many more there are
    std::int64_t handled = 0; ///< how many were written and read for it
};
/// The edit, forward, when the design before it or after it is known. Nothing when the settings cannot be read, or
/// there are too many elements; others come back as Quarantined then. `sums` is told of the keys and values of the
/// elements.
std::optional<Edit> editOf(const FieldChanges& changes, const Design& design, StoredEdits::Known known,
                           TextSums* sums = nullptr);

/// Why the edit cannot be stored: NaN, infinity and text that is not UTF-8 would not come back as they are, and
/// there are limits. Empty when it can.
Message refusal(const Edit& edit);

std::string encodeChanges(const FieldChanges& changes);
/// Nothing for bytes of any other form; they may come from anybody.
std::optional<FieldChanges> decodeChanges(std::string_view bytes);

/// As they lie in a project: packed (deflate) where that is shorter.
std::string packChanges(const FieldChanges& changes);
/// Of both forms.
std::optional<FieldChanges> unpackChanges(std::string_view bytes);
/// How many bytes they say they hold, unpacked. Nothing when that is more than there can be.
std::optional<std::uint64_t> unpackedLength(std::string_view bytes);

/// The arguments of a verb: a list of texts, not many.
std::string encodeTexts(const std::vector<std::string>& texts);
std::optional<std::vector<std::string>> decodeTexts(std::string_view bytes);

/// A design that was put together of stored changes, and how long they are.
struct Replayed {
    Design design;
    std::int64_t length = 0;  ///< bytes of its elements' keys and values
    std::int64_t handled = 0; ///< of those that were written and read for the last step
};
/// The next one. Nothing when the changes cannot be read, or lead to more than any design that is stored.
std::optional<Replayed> replayed(const Replayed& parent, const FieldChanges& changes);

/// A whole design, as the edit that makes it from an empty one, packed. Empty for one that is too large: it is
/// still there as its edits.
std::string encodeDesign(const Design& design);
std::optional<Replayed> decodeDesign(std::string_view bytes);

} // namespace bolster
