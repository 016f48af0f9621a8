#include "PieceTexts.h"

#include "DrawnWords.h"

#include <charconv>

namespace bolster {

namespace {

constexpr int mostPieces = 9999;

/// The whole numbers of a text, "1,0" being two.
std::vector<int> numbersIn(std::string_view text)
{
    std::vector<int> found;
    while (!text.empty() && found.size() < 4) {
        const std::size_t digit = text.find_first_of("0123456789");
        if (digit == std::string_view::npos)
            break;
        text.remove_prefix(digit);
        int value = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), value).ptr;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        found.push_back(value);
    }
    return found;
}

/// So many as it is, so many mirrored.
void setQuantity(const std::vector<int>& counts, FoundPiece& piece)
{
    if (counts.empty())
        return;
    const int plain = std::clamp(counts[0], 0, mostPieces),
              mirrored = counts.size() > 1 ? std::clamp(counts[1], 0, mostPieces) : 0;
    piece.pair = mirrored > 0 && plain == mirrored;
    piece.quantity = std::max(1, piece.pair ? plain : plain + mirrored);
}

bool saysHowMany(const std::string& words)
{
    for (const char* word :
         {"cut", "qty", "quantity", "pieces", "pcs", "x ", "\u00d7", "zuschneiden", "st\u00fcck", "couper"})
        if (words.find(word) != std::string::npos)
            return true;
    return words.size() > 1 && words.back() == 'x';
}

} // namespace

bool readKey(const std::string& words, FoundPiece& piece)
{
    const auto [key, value] = keyAndValue(words);
    if (key == "piece name")
        piece.name = value;
    else if (key == "size")
        piece.size = value;
    else if (key == "quantity")
        setQuantity(numbersIn(value), piece);
    else if (key == "fabric" || key == "material")
        piece.fabric = value;
    else if (key == "annotation")
        piece.note = value;
    else
        return key == "category" || key == "sample size" || key == "style name";
    return true;
}

void readLabel(const std::vector<std::string>& lines, FoundPiece& piece)
{
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (readKey(lines[i], piece))
            continue;
        const std::string words = lowered(lines[i]);
        if (piece.name.empty())
            piece.name = lines[i];
        else if (const std::vector<int> counts = numbersIn(words); !counts.empty() && saysHowMany(words))
            setQuantity(counts, piece);
    }
}

} // namespace bolster
