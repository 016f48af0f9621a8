// From a stranger's file to patches: what is read must be a design without errors.
#pragma once

#include "DesignCheck.h"
#include "DrawingReaders.h"
#include "PatternDesign.h"

#include <cstdlib>

namespace bolster::test {

inline void fuzzPattern(Drawing (*read)(const FileBytes&), std::string_view bytes)
{
    try {
        const Drawing drawing = read(FileBytes(bytes));
        const FoundPattern pattern = findPieces(drawing, {guessedUnit(drawing), "", 2});
        const ImportedPattern imported = patternEdit(Design(), pattern);
        for (const Problem& problem : checkDesign(Design().with(imported.edit)))
            if (problem.severity == Severity::Error)
                std::abort();
    } catch (const FileRefused&) {
    }
}

} // namespace bolster::test
