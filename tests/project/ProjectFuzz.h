// One run of the readers of the project file over any bytes; for the tests of every build and for the fuzzers.
#pragma once

#include "EditCodec.h"
#include "Project.h"

#include <QFile>

#include <cstdio>
#include <cstdlib>

namespace bolster::test {

inline void mustHold(bool condition, const char* what)
{
    if (condition)
        return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// Aborts when something is broken; says whether the bytes were an edit.
inline bool fuzzChanges(std::string_view bytes)
{
    decodeTexts(bytes);
    decodeDesign(bytes);
    unpackChanges(bytes);
    const auto changes = decodeChanges(bytes);
    if (!changes)
        return false;
    mustHold(decodeChanges(encodeChanges(*changes)) == changes, "what is written reads back equal");
    const Design start;
    const auto edit = editOf(*changes, start, StoredEdits::Known::Parent);
    if (!edit)
        return true;
    const Design design = start.with(*edit);
    const auto again = editOf(fieldChanges(editBetween(start, design, {})), start, StoredEdits::Known::Parent);
    mustHold(again && start.with(*again) == design, "a design that was read can be stored");
    editOf(*changes, design, StoredEdits::Known::Child);
    return true;
}

/// Opens the bytes as a project file at `path`, and goes everywhere in it.
inline bool fuzzProject(const QString& path, std::string_view bytes)
{
    QFile file(path);
    mustHold(file.open(QIODevice::WriteOnly), "the file can be written");
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    for (const ProjectCheck check : {ProjectCheck::ToWork, ProjectCheck::Everything}) {
        const OpenedProject project = openProject(path, check);
        if (!project.problem.empty())
            return false;
        for (NodeId node = 0; node < project.history.count(); ++node)
            mustHold(project.history.designAt(node, project.design).has_value() || check == ProjectCheck::ToWork,
                     "each version of a checked project is there");
    }
    return true;
}

} // namespace bolster::test
