// The designs that come with the program.
#pragma once

#include <QList>
#include <QString>

#include <string>

namespace bolster {

struct Sample {
    QString path;
    QString title;
    QString description; ///< may be empty
};

/// A folder that is shipped with the program: installed with it, or in the source tree it was built from. "" when
/// nowhere.
QString shippedFolder(const std::string& name);
QString samplesFolder();
/// NAME.json and NAME/NAME.json of the folder, in the order and with the titles of samples.json if there is one.
QList<Sample> samples(const QString& folder = samplesFolder());
/// The title of a sample, or the file's name.
QString titleOf(const QString& path);
/// A design of the program itself is never written to.
bool isSample(const QString& path);

} // namespace bolster
