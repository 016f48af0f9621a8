#include "FoundPieces.h"

#include "DrawnWords.h"
#include "LayerRole.h"
#include "PartReader.h"
#include "PieceTexts.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace bolster {

namespace {

std::string blockName(const std::string& words)
{
    std::string name = lowered(words);
    for (char& c : name)
        if (c >= 0 && !std::isalnum(static_cast<unsigned char>(c)))
            c = '_';
    return name;
}

bool isSewingLine(const DrawnLine& line)
{
    const LayerRole role = layerRole(line.layer);
    return role == LayerRole::Sew || role == LayerRole::FineSew;
}

/// What the texts of a block say of its piece; the block's name otherwise.
FoundPiece aboutPart(const DrawnPart& part)
{
    FoundPiece about;
    if (part.name.empty())
        return about;
    std::vector<std::string> label;
    for (const DrawnText& text : part.texts)
        if (!readKey(text.words, about))
            label.push_back(text.words);
    if (about.name.empty()) {
        about.name = part.name;
        std::string ending("_");
        ending.append(about.size);
        if (!about.size.empty() && about.name.size() > ending.size() && about.name.ends_with(ending))
            about.name.erase(about.name.size() - ending.size());
        // Programs spell names of blocks in capitals, without blanks.
        const auto spelled = std::ranges::find(label, blockName(about.name), blockName);
        if (spelled != label.end())
            about.name = *spelled;
        readLabel(label, about);
    }
    return about;
}

void readStyle(const Drawing& drawing, FoundPattern& pattern)
{
    for (const std::string& words : drawing.texts) {
        const auto [key, value] = keyAndValue(words);
        if (key == "style name" && pattern.style.empty())
            pattern.style = value;
        else if (key == "version")
            pattern.version = value;
        else if (key == "sample size")
            pattern.sampleSize = value;
    }
}

void nameTheRest(FoundPattern& pattern)
{
    int count = 0;
    for (FoundPiece& piece : pattern.pieces) {
        ++count;
        if (piece.name.empty())
            piece.name = piece.sew && !piece.sew->called.empty() ? piece.sew->called : piece.cut.called;
        if (piece.name.empty())
            piece.name = std::string("Piece ").append(std::to_string(count));
        if (piece.note == "mirrored")
            piece.note.clear();
    }
}

} // namespace

FoundPattern findPieces(const Drawing& drawing, const PieceOrder& order)
{
    FoundPattern pattern;
    pattern.unit = order.unit;
    readStyle(drawing, pattern);
    std::vector<FoundPiece> about;
    std::set<std::string> sizes;
    for (const DrawnPart& part : drawing.parts) {
        about.push_back(aboutPart(part));
        const std::string& size = about.back().size;
        if (!size.empty() && sizes.insert(size).second)
            pattern.sizes.push_back(size);
    }
    if (std::ranges::find(pattern.sizes, pattern.sampleSize) == pattern.sizes.end())
        pattern.sampleSize = pattern.sizes.empty() ? "" : pattern.sizes.front();
    const bool isSewn = std::ranges::any_of(
        drawing.parts, [](const DrawnPart& part) { return std::ranges::any_of(part.lines, isSewingLine); });
    const std::string& wanted = order.size.empty() ? pattern.sampleSize : order.size;
    for (std::size_t i = 0; i < drawing.parts.size(); ++i)
        if (about[i].size.empty() || about[i].size == wanted)
            PartReader(drawing.parts[i], order, isSewn, pattern).read(about[i]);
    nameTheRest(pattern);
    return pattern;
}

} // namespace bolster
