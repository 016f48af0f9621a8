// A sentence for the user that can be translated later: design and solver know no Qt.
#pragma once

#include <string>
#include <vector>

// The same definition as Qt's, so that lupdate finds the sentence and both headers can meet.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(scope, x) x
#endif

namespace bolster {

/// The key is the English sentence with %1, %2 ... for the arguments. Write it as
/// `Message{QT_TRANSLATE_NOOP("Message", "Patch \"%1\" has no fabric"), {name}}`; the window looks the key
/// up in its translations, the command line prints `english()`.
struct Message {
    std::string key;
    std::vector<std::string> args{};

    bool empty() const { return key.empty(); }
    std::string english() const;

    friend bool operator==(const Message&, const Message&) = default;
};

/// Puts the arguments into a sentence with %1, %2 ... .
std::string filledIn(const std::string& sentence, const std::vector<std::string>& args);

/// A length, ratio ... for a sentence: at most `digits` significant ones, "." as the decimal point.
std::string numberText(double value, int digits = 4);

} // namespace bolster
