// One run of the design reader over any bytes; for the test of every build and for the fuzzer.
#pragma once

#include "DesignCheck.h"
#include "DesignJson.h"

#include <cstdio>
#include <cstdlib>

namespace bolster::test {

inline void must(bool condition, const char* what)
{
    if (condition)
        return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// Reads, writes, reads, checks. Aborts when something is broken; says whether the bytes were a design.
inline bool fuzzDesign(std::string_view text)
{
    const ReadDesign read = readDesign(text);
    must(read.readable || (hasErrors(read.problems) && read.design == Design()),
         "an unreadable text has its reason");
    if (!read.readable)
        return false;
    const std::string written = writeDesign(read.design);
    const ReadDesign again = readDesign(written);
    must(again.readable, "what is written can be read");
    must(again.design == read.design, "it reads back equal");
    must(writeDesign(again.design) == written, "writing is canonical");

    const Problems problems = allProblems(read);
    const Design usable = usablePart(read.design, problems);
    must(!hasErrors(checkDesign(usable)), "the usable part has no errors");
    must(hasErrors(checkDesign(read.design)) || usable == read.design, "a sound design is usable as it is");
    return true;
}

} // namespace bolster::test
