// Lines and names as mesh files have them.
#pragma once

#include "RawNumbers.h"

namespace bolster {

template <class Vector>
void appendLine(std::string& text, const char* keyword, const Vector& numbers)
{
    text += keyword;
    for (const auto number : numbers) {
        text += ' ';
        appendNumber(text, number);
    }
    text += '\n';
}

/// OBJ names end at blanks, and some programs stumble over more than that.
std::string safeName(std::string name);

} // namespace bolster
