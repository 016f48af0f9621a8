#include "EditCodec.h"

#include <QByteArray>
#include <QCborStreamReader>
#include <QCborStreamWriter>

#include <algorithm>

namespace bolster {
namespace {

constexpr qsizetype largestPacked = 256'000'000; // bytes of a design, unpacked

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

// Reads exactly what the writers above write: nothing nests, so there is no depth to limit, and nothing is reserved
// that the bytes do not fill.
class Reader {
public:
    explicit Reader(std::string_view bytes)
        : m_bytes(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())))
        , m_reader(m_bytes)
    {}

    /// Calls item() for each one, until one fails.
    template <class Item>
    bool array(Item item)
    {
        if (!m_reader.isArray() || !m_reader.isLengthKnown() || !m_reader.enterContainer())
            return false;
        while (m_reader.hasNext())
            if (!item())
                return false;
        return m_reader.lastError() == QCborError::NoError && m_reader.leaveContainer();
    }

    bool arrayOf(std::uint64_t length) const
    {
        return m_reader.isArray() && m_reader.isLengthKnown() && m_reader.length() == length;
    }

    bool text(std::string& text)
    {
        if (!m_reader.isString() || !m_reader.isLengthKnown())
            return false;
        if (m_reader.length() > static_cast<std::uint64_t>(m_bytes.size() - m_reader.currentOffset()))
            return false;
        text.resize(static_cast<std::size_t>(m_reader.length()));
        std::size_t filled = 0;
        auto chunk = m_reader.readStringChunk(text.data(), static_cast<qsizetype>(text.size()));
        while (chunk.status == QCborStreamReader::Ok) {
            filled += static_cast<std::size_t>(chunk.data);
            chunk = m_reader.readStringChunk(text.data() + filled, static_cast<qsizetype>(text.size() - filled));
        }
        return chunk.status == QCborStreamReader::EndOfString && filled == text.size();
    }

    bool optionalText(std::optional<std::string>& text)
    {
        text.reset();
        if (m_reader.isNull())
            return m_reader.next();
        return this->text(text.emplace());
    }

    bool id(ElementId& id)
    {
        if (!m_reader.isUnsignedInteger() || m_reader.toUnsignedInteger() > largestElementId)
            return false;
        id = ElementId{static_cast<std::int32_t>(m_reader.toUnsignedInteger())};
        return m_reader.next();
    }

    bool atEnd() const { return m_reader.currentOffset() == m_bytes.size(); }

private:
    QByteArray m_bytes;
    QCborStreamReader m_reader;
};

bool readChange(Reader& reader, FieldChange& change)
{
    if (!reader.arrayOf(4))
        return false;
    int index = 0;
    return reader.array([&] {
        switch (index++) {
        case 0:
            return reader.id(change.element);
        case 1:
            return reader.text(change.field);
        case 2:
            return reader.optionalText(change.before);
        default:
            return reader.optionalText(change.after);
        }
    });
}

ElementPtr elementBehind(const FieldChange* begin, const FieldChange* end, ElementFields fields,
                         std::optional<std::string> FieldChange::*side)
{
    for (; begin != end; ++begin) {
        if (begin->*side)
            fields[begin->field] = *(begin->*side);
        else
            fields.erase(begin->field);
    }
    return elementFromFields((end - 1)->element, fields);
}

std::string pack(std::string_view bytes)
{
    return qCompress(reinterpret_cast<const uchar*>(bytes.data()), static_cast<qsizetype>(bytes.size()))
        .toStdString();
}

std::optional<std::string> unpack(std::string_view bytes)
{
    if (bytes.size() < 4)
        return std::nullopt;
    qsizetype size = 0; // that the packed bytes claim
    for (std::size_t i = 0; i < 4; ++i)
        size = size << 8 | static_cast<uchar>(bytes[i]);
    if (size > largestPacked || size > 1100 * static_cast<qsizetype>(bytes.size())) // deflate reaches 1032
        return std::nullopt;
    return qUncompress(reinterpret_cast<const uchar*>(bytes.data()), static_cast<qsizetype>(bytes.size()))
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

std::optional<Edit> editOf(const FieldChanges& changes, const Design& design, StoredEdits::Known known)
{
    const bool forward = known == StoredEdits::Known::Parent;
    Edit edit;
    for (const FieldChange *begin = changes.data(), *all = begin + changes.size(); begin != all;) {
        const FieldChange* const end =
            std::find_if(begin, all, [&](const FieldChange& each) { return each.element != begin->element; });
        const ElementPtr here = design.element(begin->element);
        const ElementPtr there = elementBehind(begin, end, elementFields(begin->element, here),
                                               forward ? &FieldChange::after : &FieldChange::before);
        if (begin->element == settingsId && !there)
            return std::nullopt;
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
    const auto again = editOf(fieldChanges(edit), before, StoredEdits::Known::Parent);
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
    Reader reader(bytes);
    FieldChanges changes;
    const bool read = reader.array([&] { return readChange(reader, changes.emplace_back()); });
    const bool sorted = std::adjacent_find(changes.begin(), changes.end(), [](const auto& a, const auto& b) {
                            return std::tie(a.element, a.field) >= std::tie(b.element, b.field);
                        }) == changes.end();
    return read && sorted && reader.atEnd() ? std::optional(std::move(changes)) : std::nullopt;
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
    Reader reader(bytes);
    std::vector<std::string> texts;
    const bool read = reader.array([&] { return reader.text(texts.emplace_back()); });
    return read && reader.atEnd() ? std::optional(std::move(texts)) : std::nullopt;
}

std::string packChanges(const FieldChanges& changes)
{
    std::string plain = encodeChanges(changes);
    std::string packed = pack(plain);
    return packed.size() < plain.size() ? packed : plain;
}

/// The first byte of an array in CBOR is 0x80 or more; packed bytes begin with their length, which is far from
/// that.
std::optional<FieldChanges> unpackChanges(std::string_view bytes)
{
    if (bytes.empty() || static_cast<std::uint8_t>(bytes.front()) >= 0x80)
        return decodeChanges(bytes);
    const auto plain = unpack(bytes);
    return plain ? decodeChanges(*plain) : std::nullopt;
}

std::string encodeDesign(const Design& design)
{
    return pack(encodeChanges(fieldChanges(editBetween(Design(), design, {}))));
}

std::optional<Design> decodeDesign(std::string_view bytes)
{
    const auto plain = unpack(bytes);
    const auto changes = plain ? decodeChanges(*plain) : std::nullopt;
    const auto edit = changes ? editOf(*changes, Design(), StoredEdits::Known::Parent) : std::nullopt;
    return edit ? std::optional(Design().with(*edit)) : std::nullopt;
}

} // namespace bolster
