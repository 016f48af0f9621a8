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

FieldChanges fieldChanges(const Edit& edit);
/// The edit, forward, when the design before it or after it is known. Nothing when the settings cannot be read;
/// other elements come back as Quarantined then.
std::optional<Edit> editOf(const FieldChanges& changes, const Design& design, StoredEdits::Known known);

/// Why the edit cannot be stored: NaN, infinity and text that is not UTF-8 would not come back as they are. Empty
/// when it can.
Message refusal(const Edit& edit);

std::string encodeChanges(const FieldChanges& changes);
/// Nothing for bytes of any other form; they may come from anybody.
std::optional<FieldChanges> decodeChanges(std::string_view bytes);

/// As they lie in a project: packed (deflate) where that is shorter.
std::string packChanges(const FieldChanges& changes);
/// Of both forms.
std::optional<FieldChanges> unpackChanges(std::string_view bytes);

/// The arguments of a verb: a list of texts.
std::string encodeTexts(const std::vector<std::string>& texts);
std::optional<std::vector<std::string>> decodeTexts(std::string_view bytes);

/// A whole design, as the edit that makes it from an empty one, packed.
std::string encodeDesign(const Design& design);
std::optional<Design> decodeDesign(std::string_view bytes);

} // namespace bolster
