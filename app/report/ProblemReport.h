// What helps to find a mistake of the program, in one file that the user gives to whom they like.
#pragma once

#include <QString>
#include <QStringList>

#include <string>

class QOffscreenSurface;

namespace bolster {

struct ProblemReport {
    QString happened;   ///< in the user's words; may be empty
    QString versions;   ///< a line each
    QString log;        ///< of this run
    QString crash;      ///< the last one; empty: there was none
    std::string design; ///< as text; empty: it is not in the report
};

/// Of program, Qt, OpenGL and system. Without names of users or computers.
QString versionsText(const QString& openGl);
/// "vendor, renderer, version" of the OpenGL that windows get, or why there is none. Takes its time: not for the
/// GUI thread. `surface` is a valid QOffscreenSurface, which only the GUI thread can make.
QString openGlText(QOffscreenSurface& surface);
/// The user's folder is left out of what is written: "~" stands for it.
QString withoutHome(QString text);
/// As a ZIP file with a text for each part.
std::string packedReport(const ProblemReport& report);
/// Names of the files in it, with what is in each, for the user to see before.
QStringList contentsOf(const ProblemReport& report);

} // namespace bolster
