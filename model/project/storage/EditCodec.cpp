#include "EditCodec.h"

#include "CborReader.h"

#include <QByteArray>
#include <QCborStreamWriter>

#include <algorithm>

namespace bolster {
namespace {

// A key of a change that is not there is null.
void appendText(QCborStreamWriter& writer, const std::string& text)
{
    writer.appendTextString(text.data(), static_cast<qsizetype>(text.size()));
}

void appendText(QCborStreamWriter& writer, const std::optional<std::string>& text)
{
    if (text)
        appendText(writer, *text);
    else
        writer.appendNull();
}

bool readChange(CborReader& reader, FieldChange& change)
{
    std::uint64_t parts = 0;
    return reader.array(parts) && parts == 4 && reader.id(change.element) && reader.text(change.field) &&
           reader.optionalText(change.before) && reader.optionalText(change.after) && change.before != change.after;
}

/// Stops at the first that is wrong or out of order: nobody is to hold what will be refused.
std::optional<FieldChanges> readChanges(CborReader reader)
{
    std::uint64_t count = 0;
    if (!reader.array(count) || count > mostFieldChanges)
        return std::nullopt;
    FieldChanges changes;
    for (std::uint64_t i = 0; i < count; ++i) {
        FieldChange change;
        if (!readChange(reader, change) || (i > 0 && std::tie(changes.back().element, changes.back().field) >=
                                                         std::tie(change.element, change.field)))
            return std::nullopt;
        changes.push_back(std::move(change));
    }
    return reader.atEnd() ? std::optional(std::move(changes)) : std::nullopt;
}

/// More than enough for what CBOR adds to the texts of a change.
constexpr std::size_t bytesBesideTexts = 24;
constexpr std::uint64_t mostTexts = 100; // of a list

bool canBeStored(const FieldChanges& changes)
{
    std::size_t bytes = 0;
    for (const FieldChange& change : changes)
        bytes += change.field.size() + change.before.value_or("").size() + change.after.value_or("").size() +
                 bytesBesideTexts;
    return changes.size() <= mostFieldChanges && bytes <= longestPlain;
}

std::int64_t textLengthOf(const ElementFields& fields)
{
    std::size_t length = 0;
    for (const auto& [key, text] : fields)
        length += key.size() + text.size();
    return static_cast<std::int64_t>(length);
}

ElementFields fieldsBehind(const FieldChange* begin, const FieldChange* end, ElementFields fields,
                           std::optional<std::string> FieldChange::*side)
{
    for (; begin != end; ++begin) {
        if (begin->*side)
            fields[begin->field] = *(begin->*side);
        else
            fields.erase(begin->field);
    }
    return fields;
}

std::string pack(std::string_view bytes)
{
    return qCompress(reinterpret_cast<const uchar*>(bytes.data()), static_cast<qsizetype>(bytes.size()))
        .toStdString();
}

} // namespace

FieldChanges fieldChanges(const Edit& edit)
{
    FieldChanges changes;
    for (const Change& change : edit.changes) {
        const ElementFields before = elementFields(change.id, change.before);
        const ElementFields after = elementFields(change.id, change.after);
        const auto value = [](const ElementFields& fields, const std::string& key) {
            const auto found = fields.find(key);
            return found == fields.end() ? std::nullopt : std::optional(found->second);
        };
        for (const auto& [key, text] : before)
            if (value(after, key) != text)
                changes.push_back({change.id, key, text, value(after, key)});
        for (const auto& [key, text] : after)
            if (!before.contains(key))
                changes.push_back({change.id, key, std::nullopt, text});
    }
    std::sort(changes.begin(), changes.end(), [](const FieldChange& a, const FieldChange& b) {
        return std::tie(a.element, a.field) < std::tie(b.element, b.field);
    });
    return changes;
}

std::optional<Edit> editOf(const FieldChanges& changes, const Design& design, StoredEdits::Known known,
                           TextSums* sums)
{
    const bool forward = known == StoredEdits::Known::Parent;
    Edit edit;
    std::size_t elements = design.elements().size();
    for (const FieldChange *begin = changes.data(), *all = begin + changes.size(); begin != all;) {
        const FieldChange* const end =
            std::find_if(begin, all, [&](const FieldChange& each) { return each.element != begin->element; });
        const ElementPtr here = design.element(begin->element);
        const ElementFields from = elementFields(begin->element, here);
        const ElementFields to =
            fieldsBehind(begin, end, from, forward ? &FieldChange::after : &FieldChange::before);
        const ElementPtr there = elementFromFields(begin->element, to);
        elements += there && !here ? 1 : 0;
        if ((begin->element == settingsId && !there) || elements > mostStoredElements)
            return std::nullopt;
        if (sums) {
            sums->growth += textLengthOf(to) - textLengthOf(from);
            sums->handled += textLengthOf(to) + textLengthOf(from);
        }
        edit.changes.push_back({begin->element, forward ? here : there, forward ? there : here});
        begin = end;
    }
    return edit;
}

Message refusal(const Edit& edit)
{
    Edit from; // only what the edit touches
    for (const Change& change : edit.changes)
        from.changes.push_back({change.id, nullptr, change.before});
    const Design before = Design().with(from);
    const Design after = before.with(edit);
    const FieldChanges changes = fieldChanges(edit);
    if (!canBeStored(changes))
        return {QT_TRANSLATE_NOOP("Message", "this changes more at once than can be stored: at most %1 MB, and %2 "
                                             "keys; do it in parts"),
                {std::to_string(longestPlain >> 20), std::to_string(mostFieldChanges)}};
    const auto again = editOf(changes, before, StoredEdits::Known::Parent);
    if (again && before.with(*again) == after)
        return {};
    std::string labels;
    for (const ElementId id : again ? differences(before.with(*again), after) : std::set{settingsId})
        if (const ElementPtr element = after.element(id); element && labels.empty())
            labels = elementLabel(id, *element);
    return {QT_TRANSLATE_NOOP("Message",
                              "%1 cannot be stored: it holds a number that is none, or text in an unknown "
                              "encoding"),
            {labels}};
}

std::string encodeChanges(const FieldChanges& changes)
{
    QByteArray bytes;
    QCborStreamWriter writer(&bytes);
    writer.startArray(changes.size());
    for (const FieldChange& change : changes) {
        writer.startArray(4);
        writer.append(static_cast<quint64>(number(change.element)));
        appendText(writer, change.field);
        appendText(writer, change.before);
        appendText(writer, change.after);
        writer.endArray();
    }
    writer.endArray();
    return bytes.toStdString();
}

std::optional<FieldChanges> decodeChanges(std::string_view bytes)
{
    return readChanges(CborReader(PlainBytes::asTheyAre(bytes)));
}

std::string encodeTexts(const std::vector<std::string>& texts)
{
    QByteArray bytes;
    QCborStreamWriter writer(&bytes);
    writer.startArray(texts.size());
    for (const std::string& text : texts)
        appendText(writer, text);
    writer.endArray();
    return bytes.toStdString();
}

std::optional<std::vector<std::string>> decodeTexts(std::string_view bytes)
{
    CborReader reader(PlainBytes::asTheyAre(bytes));
    std::uint64_t count = 0;
    if (!reader.array(count) || count > mostTexts)
        return std::nullopt;
    std::vector<std::string> texts(static_cast<std::size_t>(count));
    for (std::string& text : texts)
        if (!reader.text(text))
            return std::nullopt;
    return reader.atEnd() ? std::optional(std::move(texts)) : std::nullopt;
}

std::string packChanges(const FieldChanges& changes)
{
    std::string plain = encodeChanges(changes);
    std::string packed = pack(plain);
    return packed.size() < plain.size() ? packed : plain;
}

namespace {

/// The first byte of an array in CBOR is 0x80 or more; packed bytes begin with their length, which is far from
/// that.
bool isPacked(std::string_view bytes)
{
    return !bytes.empty() && static_cast<std::uint8_t>(bytes.front()) < 0x80;
}

} // namespace

std::optional<std::uint64_t> unpackedLength(std::string_view bytes)
{
    return isPacked(bytes) ? plainLength(bytes) : bytes.size();
}

std::optional<FieldChanges> unpackChanges(std::string_view bytes)
{
    return isPacked(bytes) ? readChanges(CborReader(PlainBytes::unpacked(bytes))) : decodeChanges(bytes);
}

std::string encodeDesign(const Design& design)
{
    const FieldChanges changes = fieldChanges(editBetween(Design(), design, {}));
    return canBeStored(changes) ? pack(encodeChanges(changes)) : std::string();
}

std::optional<Replayed> decodeDesign(std::string_view bytes)
{
    const auto changes = readChanges(CborReader(PlainBytes::unpacked(bytes)));
    return changes ? replayed({}, *changes) : std::nullopt;
}

std::optional<Replayed> replayed(const Replayed& parent, const FieldChanges& changes)
{
    TextSums sums;
    const auto edit = editOf(changes, parent.design, StoredEdits::Known::Parent, &sums);
    const std::int64_t length = parent.length + sums.growth;
    if (!edit || length > longestStoredDesign)
        return std::nullopt;
    return Replayed{parent.design.with(*edit), length, sums.handled};
}

} // namespace bolster
