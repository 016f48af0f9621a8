#include "PortableFolder.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <array>

namespace bolster {

namespace fs = std::filesystem;

QString portableFolder(const fs::path& program, bool asked)
{
    const fs::path home = program.filename() == "bin" ? program.parent_path() : program;
    std::error_code problem;
    const bool marked =
        fs::is_regular_file(program / "portable", problem) || fs::is_regular_file(home / "portable", problem);
    if (home.empty() || !(asked || marked))
        return {};
    return QString::fromStdString((home / "bolster-settings").string());
}

/// The folders of the desktop, by the names that Qt, OpenGL drivers and fonts ask for. Not that of settings: other
/// programs, which a window may start, would not find theirs.
Message keepEverythingIn(const QString& folder)
{
    struct Place {
        const char* variable;
        const char* name;
    };
    constexpr std::array places = {Place{"XDG_DATA_HOME", "data"}, Place{"XDG_STATE_HOME", "state"},
                                   Place{"XDG_CACHE_HOME", "cache"}};
    const QDir dir(folder);
    bool made = dir.mkpath(QStringLiteral("settings"));
    for (const Place& place : places)
        made = made && dir.mkpath(QLatin1String(place.name)) && QFileInfo(dir.filePath(place.name)).isWritable();
    if (!made || !QFileInfo(dir.filePath(QStringLiteral("settings"))).isWritable())
        return {QT_TRANSLATE_NOOP("Message", "\"%1\", where a portable Bolster keeps settings and work, cannot be "
                                             "written; copy its folder to where you may write"),
                {folder.toStdString()}};
    qputenv("MESA_SHADER_CACHE_DISABLE", "true"); // it ends a program whose disk is full
    for (const Place& place : places)
        qputenv(place.variable, QFile::encodeName(dir.filePath(place.name)));
    for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
        QSettings::setPath(format, QSettings::UserScope, dir.filePath(QStringLiteral("settings")));
    return {};
}

} // namespace bolster
