#include "DxfEntity.h"

#include "DrawnWords.h"
#include "DxfGroups.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace bolster {

namespace {

constexpr std::uint64_t largestDxf = 100'000'000;
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

/// Coordinates and the like: what drawings need of all the numbers.
bool isNeeded(int code)
{
    return (code >= 10 && code < 80) || code == 230;
}

class DxfParser {
public:
    DxfParser(std::string_view text, const ImportWatch& watch)
        : m_groups(dxfGroups(text, watch))
    {}

    DxfFile parse()
    {
        while (!m_ended && m_groups->next(m_group)) {
            if (m_group.code == 0)
                begin();
            else if (m_group.code == 2 && m_inSection && m_section.empty())
                m_section = std::string(m_group.words);
            else if (m_group.code == 9)
                m_variable = std::string(m_group.words);
            else if (m_group.code == 999)
                m_comments.emplace_back(words());
            else
                value();
        }
        if (!m_sections)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is not a DXF file: it has no sections"));
        if (!m_ended)
            cutOff();
        finish();
        return std::move(m_file);
    }

private:
    std::string words() const { return drawnWords(m_group.words, m_codePage); }

    void begin()
    {
        const std::string_view kind = m_group.words;
        if (kind == "VERTEX" && m_entity && m_entity->kind == "POLYLINE") {
            m_entity->vertices.emplace_back();
            m_entity->vertices.back().kind = "VERTEX";
            return;
        }
        finish();
        if (kind == "SECTION") {
            m_inSection = true;
            m_sections = true;
            m_section.clear();
        } else if (kind == "ENDSEC") {
            m_drawn = m_drawn || m_section == "ENTITIES";
            m_inSection = false;
            m_section.clear();
        } else if (kind == "EOF") {
            m_ended = true;
        } else if (kind != "SEQEND" && (m_section == "BLOCKS" || m_section == "ENTITIES")) {
            m_entity.emplace();
            m_entity->kind = std::string(kind);
            m_entity->comments = std::move(m_comments);
            m_comments.clear();
        }
    }

    /// What an interrupted copy leaves is a drawing with other shapes, or with fewer.
    void cutOff()
    {
        if (m_inSection && !m_drawn)
            refuseFile(m_groups->place(),
                       QT_TRANSLATE_NOOP("Message",
                                         "%1: the file ends in the middle of its section %2, so it is not "
                                         "whole; get it once more"),
                       {m_section.empty() ? "?" : excerpt(m_section)});
        m_file.endMissing = true;
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
            m_file.units = static_cast<int>(std::clamp(number(), -1.0, 1000.0));
        if (m_section == "HEADER" && m_variable == "$DWGCODEPAGE" && m_group.code == 3)
            m_codePage = codePageOf(m_group.words);
        if (!m_entity)
            return;
        DxfEntity& entity = m_entity->vertices.empty() ? *m_entity : m_entity->vertices.back();
        if (m_group.code == 8)
            entity.layer = words();
        else if (m_group.code == 1 || m_group.code == 3)
            entity.text += words();
        else if (m_group.code == 2)
            entity.name = words();
        else if (isNeeded(m_group.code))
            entity.numbers.emplace_back(m_group.code, number());
    }

    double number() const { return numberOf(m_group, m_groups->place()); }

    std::unique_ptr<DxfGroups> m_groups;
    DxfGroup m_group;
    DxfFile m_file;
    bool m_sections = false;
    bool m_inSection = false;
    bool m_drawn = false; ///< all of ENTITIES was there
    bool m_ended = false;
    std::string m_section;
    std::string m_variable;
    std::string m_block;
    std::string m_codePage;
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
    return DxfParser(text, bytes.watch()).parse();
}

} // namespace bolster
