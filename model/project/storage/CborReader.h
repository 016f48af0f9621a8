// Reads exactly the CBOR that edits are written as. Private to the library.
#pragma once

#include "ElementId.h"
#include "PlainBytes.h"

#include <vector>

namespace bolster {

/// Nothing nests but what its caller asks for, and nothing is reserved that the bytes cannot fill. Each function is
/// false when there is something else.
class CborReader {
public:
    explicit CborReader(PlainBytes bytes)
        : m_bytes(std::move(bytes))
    {}

    bool array(std::uint64_t& length);
    bool text(std::string& text);
    bool optionalText(std::optional<std::string>& text);
    bool id(ElementId& id);
    bool atEnd() const { return m_bytes.atEnd(); }

private:
    struct Head {
        int kind = 0; ///< the major type
        std::uint64_t number = 0;
        bool wide = false; ///< whether the number stands behind the first byte
    };
    bool head(Head& head);
    bool characters(std::uint64_t count, std::string& text);

    PlainBytes m_bytes;
};

} // namespace bolster
