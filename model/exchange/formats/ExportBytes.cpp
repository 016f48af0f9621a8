#include "ExportBytes.h"

#include <cctype>

namespace bolster {

std::string safeName(std::string name)
{
    for (char& c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && !std::isalnum(byte) && c != '-' && c != '.')
            c = '_';
    }
    return name;
}

} // namespace bolster
