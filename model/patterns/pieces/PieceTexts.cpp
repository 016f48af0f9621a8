#include "PieceTexts.h"

#include "DrawnWords.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace bolster {

namespace {

constexpr double mostSaid = 1e9; // more than anybody writes; what is possible is asked later

/// A whole number where one begins; what is no whole number ("2.5", "-1") is nothing. Passes it.
std::optional<double> wholeNumber(std::string_view& text)
{
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    double value = 0;
    for (const char digit : text.substr(0, end))
        value = std::min(mostSaid, 10 * value + (digit - '0'));
    const bool any = end > 0;
    text.remove_prefix(end);
    if (text.starts_with('.')) { // "2.0" is whole
        const std::size_t rest = std::min(text.find_first_not_of("0123456789", 1), text.size());
        if (rest < 2 || text.substr(1, rest - 1).find_first_not_of('0') != std::string_view::npos)
            return std::nullopt;
        text.remove_prefix(rest);
    }
    return any ? std::optional(value) : std::nullopt;
}

/// So many as it is, so many mirrored: "2", "2,2", "2 pcs"; nothing for anything else.
std::optional<std::pair<double, double>> saidQuantity(std::string_view text)
{
    text = trimmed(text);
    const auto plain = wholeNumber(text);
    text = trimmed(text);
    double mirrored = 0;
    if (!text.empty() && std::string_view(",;+").find(text.front()) != std::string_view::npos) {
        text = trimmed(text.substr(1));
        const auto second = wholeNumber(text);
        if (!second)
            return std::nullopt;
        mirrored = *second;
    }
    // Words may follow, more numbers may not.
    if (!plain || text.find_first_of("0123456789-/*") != std::string_view::npos)
        return std::nullopt;
    return std::pair(*plain, mirrored);
}

void setQuantity(double plain, double mirrored, FoundPiece& piece)
{
    piece.pair = mirrored > 0 && plain == mirrored;
    piece.quantity = std::max(1.0, piece.pair ? plain : plain + mirrored);
    piece.oddQuantity.assign(plain + mirrored > 0 ? 0 : 1, '0');
}

void readQuantity(const std::string& value, FoundPiece& piece)
{
    if (trimmed(value).empty())
        return;
    if (const auto said = saidQuantity(value))
        setQuantity(said->first, said->second, piece);
    else
        piece.oddQuantity = value;
}

/// "Cut 2 and 2 mirrored", "2x", "Qty 4", "4 pieces": a first number, and a second one where that is mirrored.
void readHowMany(const std::string& words, FoundPiece& piece)
{
    std::string_view text = words;
    const auto passToNumber = [&] {
        const std::size_t digit = text.find_first_of("0123456789");
        const bool negative = digit != std::string_view::npos && digit > 0 && text[digit - 1] == '-';
        text.remove_prefix(std::min(digit, text.size()));
        return !negative;
    };
    const bool first = passToNumber();
    const auto plain = wholeNumber(text);
    if (!first || !plain) {
        piece.oddQuantity = words;
        return;
    }
    double mirrored = 0;
    if (text.find("mirror") != std::string_view::npos || text.find("gespiegelt") != std::string_view::npos ||
        text.find("miroir") != std::string_view::npos)
        if (passToNumber())
            mirrored = wholeNumber(text).value_or(0);
    setQuantity(*plain, mirrored, piece);
}

bool saysHowMany(const std::string& words)
{
    for (const char* word :
         {"cut", "qty", "quantity", "pieces", "pcs", "x ", "\u00d7", "zuschneiden", "st\u00fcck", "couper"})
        if (words.find(word) != std::string::npos)
            return true;
    return words.size() > 1 && words.back() == 'x';
}

/// "ONE WAY", "any direction", "two ways".
void readNap(const std::string& value, FoundPiece& piece)
{
    static constexpr std::pair<std::string_view, Nap> words[] = {
        {"one", Nap::OneWay}, {"two", Nap::TwoWays}, {"both", Nap::TwoWays}, {"any", Nap::Any}, {"none", Nap::Any}};
    const std::string said = lowered(value);
    for (const auto& [word, nap] : words)
        if (said.starts_with(word)) {
            piece.nap = nap;
            return;
        }
    piece.oddNap = said.empty() ? std::string() : value;
}

/// Degrees, with or without their unit.
void readTolerance(const std::string& value, FoundPiece& piece)
{
    constexpr double most = 180;
    double degrees = 0;
    const auto read = std::from_chars(value.data(), value.data() + value.size(), degrees);
    if (read.ec == std::errc() && degrees >= 0 && degrees <= most)
        piece.tolerance = degrees;
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
        readQuantity(value, piece);
    else if (key == "fabric" || key == "material")
        piece.fabric = value;
    else if (key == "annotation")
        piece.note = value;
    else if (key == "nap")
        readNap(value, piece);
    else if (key == "shrinkage")
        piece.shrinkage = value;
    else if (key == "grain tolerance")
        readTolerance(value, piece);
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
        else if (words.find_first_of("0123456789") != std::string::npos && saysHowMany(words))
            readHowMany(words, piece);
    }
}

} // namespace bolster
