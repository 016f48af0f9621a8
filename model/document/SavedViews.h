// Views of the 3D window that the user has named, and the last ones of files, kept in the settings.
#pragma once

#include "Viewpoint.h"

#include <QStringList>

#include <optional>

namespace bolster {

class SavedViews {
public:
    /// In the order of the alphabet.
    static QStringList names();
    /// Nothing when there is none of this name, or its numbers make no sense.
    static std::optional<Viewpoint> find(const QString& name);
    /// Replaces one of the same name.
    static void save(const QString& name, const Viewpoint& view);
    static void remove(const QString& name);

    /// Where one stood when the file was closed; nothing when that is not known (any more).
    static std::optional<Viewpoint> lastOf(const QString& file);
    /// Of some fifty files the latest is kept.
    static void keepLast(const QString& file, const Viewpoint& view);
};

} // namespace bolster
