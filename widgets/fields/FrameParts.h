// What the inspector says of a frame's mesh: its parts, those that a cushion takes, and how fine voxels can be.
#pragma once

#include "ElementForm.h"

#include <QCoreApplication>

namespace bolster {

class Document;

class FrameParts {
    Q_DECLARE_TR_FUNCTIONS(FrameParts)

public:
    FrameParts(Document& document, const FormSources& sources, const FormWishes& wishes)
        : m_document(document)
        , m_sources(sources)
        , m_wishes(wishes)
    {}

    /// What a frame's file consists of, each part with a mark that shows it.
    void addShown(PropertyForm& form, ElementId frame) const;
    /// Those that cushions may take, each with a mark if they do.
    void addPadded(PropertyForm& form, const std::vector<ElementId>& cushions) const;
    void addVoxelNote(PropertyForm& form, ElementId cushion) const;

private:
    Document& m_document;
    const FormSources& m_sources;
    const FormWishes& m_wishes;
};

} // namespace bolster
