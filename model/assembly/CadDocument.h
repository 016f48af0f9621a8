// A STEP or IGES file as the library has it: shapes with names and colours, in millimetres.
#pragma once

#include "CadFile.h"

#include <TDocStd_Document.hxx>

#include <vector>

namespace bolster {

struct CadDocument {
    Handle(TDocStd_Document) document;
    FileFacts said;
    std::vector<std::string> elsewhere; ///< files that it refers to
    std::uint64_t faces = 0; ///< as many as it writes at least; the library leaves out what it cannot read
};

/// Throws AssemblyRefused.
CadDocument readCadDocument(std::string_view bytes, CadOrder::Kind kind, AssemblyWriter& writer);

/// Throws AssemblyRefused.
void writeCadParts(const CadDocument& document, const CadOrder& order, AssemblyWriter& writer);

} // namespace bolster
