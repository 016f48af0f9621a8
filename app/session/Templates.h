// Designs to begin from: they come with the program, and are opened as new ones without a file.
#pragma once

#include "Samples.h"

namespace bolster {

/// Where they are, as samplesFolder(). "" when nowhere.
QString templatesFolder();
/// NAME.json and NAME.bolster of the folder. What their names mean is said in the user's language; a design of
/// somebody's own has its file's name.
QList<Sample> templates(const QString& folder = templatesFolder());
/// What such a design is called.
QString templateTitle(const QString& path);
/// The picture of a sample or template: NAME.png beside it, which may not be there.
QString pictureBeside(const QString& design);

} // namespace bolster
