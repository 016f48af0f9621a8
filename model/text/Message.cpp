#include "Message.h"

#include <array>
#include <charconv>
#include <cmath>

namespace bolster {

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

} // namespace

// One pass, so that a "%1" inside an argument (a name, say) stays as it is.
std::string filledIn(const std::string& sentence, const std::vector<std::string>& args)
{
    std::string text;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        if (sentence[i] != '%' || i + 1 == sentence.size() || !isDigit(sentence[i + 1])) {
            text += sentence[i];
            continue;
        }
        std::size_t end = i + 1;
        std::size_t number = 0;
        for (; end < sentence.size() && end < i + 3 && isDigit(sentence[end]); ++end)
            number = 10 * number + static_cast<std::size_t>(sentence[end] - '0');
        if (number >= 1 && number <= args.size())
            text += args[number - 1];
        else
            text += sentence.substr(i, end - i);
        i = end - 1;
    }
    return text;
}

std::string Message::english() const
{
    return filledIn(key, args);
}

std::string numberText(double value, int digits)
{
    if (!std::isfinite(value))
        return std::isnan(value) ? "NaN" : value > 0 ? "infinity" : "-infinity";
    std::array<char, 64> buffer;
    const double size = std::abs(value);
    if (size >= 1e15 || (size > 0 && size < 1e-6)) {
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       std::chars_format::scientific, digits - 1);
        return std::string(buffer.data(), end.ptr);
    }
    const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
    const int decimals = digits > before ? digits - before : 0;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string text(buffer.data(), end.ptr);
    if (decimals > 0) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

} // namespace bolster
