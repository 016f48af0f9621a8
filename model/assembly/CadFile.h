// STEP and IGES files as assemblies, by OpenCASCADE. Nothing of it is seen here: its headers are heavy.
#pragma once

#include "AssemblyWriter.h"

#include <string_view>

namespace bolster {

struct CadOrder {
    enum class Kind { Step, Iges };

    Kind kind = Kind::Step;
    double tolerance = 0.2; ///< mm between a face and its triangles
    bool edges = false;
};

/// Whatever the library wants to look up, before it has seen a file.
void prepareCad();

/// `bytes` are what the standard input holds: IGES is read from there. Throws AssemblyRefused.
void readCad(std::string_view bytes, const CadOrder& order, AssemblyWriter& writer);

} // namespace bolster
