#include "DxfEntity.h"

#include "DrawnWords.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace bolster {

namespace {

constexpr std::uint64_t largestDxf = 100'000'000;
constexpr std::size_t mostGroups = 12'000'000;
constexpr std::size_t fileChunk = 1 << 20;

std::string wholeText(const FileBytes& bytes)
{
    if (bytes.size() > largestDxf)
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the file is larger than a pattern can be (%2 MB)"),
                   {std::to_string(largestDxf / 1'000'000)});
    FileWindow window(bytes);
    std::string text;
    while (text.size() < bytes.size()) {
        bytes.watch().check(0.3 * static_cast<double>(text.size()) / static_cast<double>(bytes.size()));
        const std::string_view more = window.view(text.size(), fileChunk);
        text.append(more);
        if (more.empty())
            break;
    }
    return text;
}

struct Group {
    int code = 0;
    std::string_view value;
};

class Groups {
public:
    Groups(std::string_view text, const ImportWatch& watch)
        : m_text(text)
        , m_watch(watch)
    {}

    /// False at the end of the text.
    bool next(Group& group)
    {
        std::string_view code;
        do {
            if (!line(code))
                return false;
        } while (code.empty());
        const FilePlace place{FilePlace::Unit::Line, m_line};
        const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
        if (error != std::errc() || end != code.data() + code.size())
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a group code of DXF"),
                       {excerpt(code)});
        if (!line(group.value))
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the file ends in the middle of something"));
        if (++m_groups > mostGroups)
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: more is drawn in it than a pattern can have"));
        if (m_groups % 65536 == 0)
            m_watch.check(0.3 + 0.7 * static_cast<double>(m_at) / static_cast<double>(m_text.size()));
        return true;
    }

    FilePlace place() const { return {FilePlace::Unit::Line, m_line}; }

private:
    bool line(std::string_view& found)
    {
        if (m_at >= m_text.size())
            return false;
        const std::size_t end = std::min(m_text.find_first_of("\r\n", m_at), m_text.size());
        found = m_text.substr(m_at, end - m_at);
        m_at = end + 1;
        if (end + 1 < m_text.size() && m_text[end] == '\r' && m_text[end + 1] == '\n')
            ++m_at;
        ++m_line;
        found = trimmed(found);
        return true;
    }

    std::string_view m_text;
    const ImportWatch& m_watch;
    std::size_t m_at = 0;
    std::uint64_t m_line = 0;
    std::size_t m_groups = 0;
};

/// Coordinates and the like: what drawings need of all the numbers.
bool isNeeded(int code)
{
    return (code >= 10 && code < 80) || code == 230;
}

class DxfParser {
public:
    DxfParser(std::string_view text, const ImportWatch& watch)
        : m_groups(text, watch)
    {}

    DxfFile parse()
    {
        while (m_groups.next(m_group)) {
            m_seen = true;
            if (m_group.code == 0)
                begin();
            else if (m_group.code == 2 && m_inSection && m_section.empty())
                m_section = std::string(m_group.value);
            else if (m_group.code == 9)
                m_variable = std::string(m_group.value);
            else if (m_group.code == 999)
                m_comments.emplace_back(drawnWords(m_group.value));
            else
                value();
        }
        finish();
        if (!m_sections)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is not a DXF file: it has no sections"));
        return std::move(m_file);
    }

private:
    void begin()
    {
        const std::string_view kind = m_group.value;
        if (kind == "VERTEX" && m_entity && m_entity->kind == "POLYLINE") {
            m_entity->vertices.emplace_back();
            m_entity->vertices.back().kind = "VERTEX";
            return;
        }
        if (kind == "SEQEND")
            return;
        finish();
        if (kind == "SECTION") {
            m_inSection = true;
            m_sections = true;
            m_section.clear();
        } else if (kind == "ENDSEC" || kind == "EOF") {
            m_inSection = false;
        } else if (m_section == "BLOCKS" || m_section == "ENTITIES") {
            m_entity.emplace();
            m_entity->kind = std::string(kind);
            m_entity->comments = std::move(m_comments);
            m_comments.clear();
        }
    }

    void finish()
    {
        if (!m_entity)
            return;
        if (m_entity->kind == "BLOCK")
            beginBlock();
        else if (m_entity->kind == "ENDBLK")
            m_block.clear();
        else if (m_section == "ENTITIES")
            m_file.entities.push_back(std::move(*m_entity));
        else if (!m_block.empty())
            m_file.blocks[m_block].entities.push_back(std::move(*m_entity));
        m_entity.reset();
    }

    void beginBlock()
    {
        m_block = m_entity->name;
        if (m_block.empty())
            return;
        if (m_file.blocks.contains(m_block)) // the first one counts, in AutoCAD too
            m_block.append(" (").append(std::to_string(m_file.blocks.size())).append(")");
        m_file.blocks[m_block] = {m_block, m_entity->point(10), {}};
        m_file.blockNames.push_back(m_block);
    }

    void value()
    {
        if (m_section == "HEADER" && m_variable == "$INSUNITS" && m_group.code == 70)
            m_file.units = static_cast<int>(number());
        if (!m_entity)
            return;
        DxfEntity& entity = m_entity->vertices.empty() ? *m_entity : m_entity->vertices.back();
        if (m_group.code == 8)
            entity.layer = drawnWords(m_group.value);
        else if (m_group.code == 1 || m_group.code == 3)
            entity.text += drawnWords(m_group.value);
        else if (m_group.code == 2)
            entity.name = drawnWords(m_group.value);
        else if (isNeeded(m_group.code))
            entity.numbers.emplace_back(m_group.code, number());
    }

    double number() const
    {
        std::string_view word = m_group.value;
        if (word.starts_with('+'))
            word.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value) ||
            std::abs(value) > 1e12)
            refuseFile(m_groups.place(), QT_TRANSLATE_NOOP("Message", "%1: \"%2\" is not a number"),
                       {excerpt(m_group.value)});
        return value;
    }

    Groups m_groups;
    Group m_group;
    DxfFile m_file;
    bool m_seen = false;
    bool m_sections = false;
    bool m_inSection = false;
    std::string m_section;
    std::string m_variable;
    std::string m_block;
    std::vector<std::string> m_comments;
    std::optional<DxfEntity> m_entity;
};

} // namespace

bool DxfEntity::has(int code) const
{
    for (const auto& [key, value] : numbers)
        if (key == code)
            return true;
    return false;
}

double DxfEntity::number(int code, double otherwise) const
{
    for (const auto& [key, value] : numbers)
        if (key == code)
            return value;
    return otherwise;
}

int DxfEntity::integer(int code, int otherwise) const
{
    return static_cast<int>(std::clamp(number(code, otherwise), -1e9, 1e9));
}

std::vector<double> DxfEntity::all(int code) const
{
    std::vector<double> found;
    for (const auto& [key, value] : numbers)
        if (key == code)
            found.push_back(value);
    return found;
}

std::vector<Vec2> DxfEntity::points(int code) const
{
    const std::vector<double> x = all(code), y = all(code + 10);
    std::vector<Vec2> found;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
        found.emplace_back(x[i], y[i]);
    return found;
}

DxfFile readDxfFile(const FileBytes& bytes)
{
    const std::string text = wholeText(bytes);
    if (text.starts_with("AutoCAD Binary DXF"))
        refuseFile(
            {}, QT_TRANSLATE_NOOP("Message", "%1 is a binary DXF file: save it as text (ASCII) and import that"));
    return DxfParser(text, bytes.watch()).parse();
}

} // namespace bolster
