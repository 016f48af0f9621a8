// Views of the 3D window that the user has named, kept in the settings.
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
};

} // namespace bolster
