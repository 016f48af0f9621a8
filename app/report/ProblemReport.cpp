#include "ProblemReport.h"

#include "PackedFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QGuiApplication>
#include <QLocale>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSysInfo>
#include <QThread>

#include <utility>
#include <vector>

namespace bolster {

namespace {

std::vector<std::pair<const char*, std::string>> partsOf(const ProblemReport& report)
{
    std::vector<std::pair<const char*, std::string>> parts;
    const auto add = [&](const char* name, const std::string& text) {
        if (!text.empty())
            parts.emplace_back(name, text);
    };
    add("what-happened.txt", report.happened.toStdString());
    add("versions.txt", withoutHome(report.versions).toStdString());
    add("log.txt", withoutHome(report.log).toStdString());
    add("last-crash.txt", withoutHome(report.crash).toStdString());
    add("design.json", report.design);
    return parts;
}

} // namespace

QString versionsText(const QString& openGl)
{
    const QStringList lines{
        QStringLiteral("Bolster: %1").arg(QCoreApplication::applicationVersion()),
        QStringLiteral("Qt: %1 (built with %2)").arg(QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR)),
        QStringLiteral("OpenGL: %1").arg(openGl),
        QStringLiteral("System: %1, kernel %2 %3, %4")
            .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(), QSysInfo::kernelVersion(),
                 QSysInfo::currentCpuArchitecture()),
        QStringLiteral("Windows: %1, %2 threads")
            .arg(QGuiApplication::platformName())
            .arg(QThread::idealThreadCount()),
        QStringLiteral("Language: %1").arg(QLocale().name())};
    return lines.join(u'\n') + u'\n';
}

QString openGlText(QOffscreenSurface& surface)
{
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface))
        return QStringLiteral("none");
    const auto text = [functions = context.functions()](GLenum name) {
        const auto* found = reinterpret_cast<const char*>(functions->glGetString(name));
        return QString::fromLatin1(found ? found : "?");
    };
    QString all = QStringLiteral("%1, %2, %3").arg(text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION));
    context.doneCurrent();
    return all;
}

QString withoutHome(QString text)
{
    const QString home = QDir::homePath();
    return home.size() > 1 ? text.replace(home, QStringLiteral("~")) : text;
}

std::string packedReport(const ProblemReport& report)
{
    PackedFile file;
    for (const auto& [name, text] : partsOf(report))
        file.add(std::string("bolster-report/").append(name), text, true);
    return std::move(file).bytes();
}

QStringList contentsOf(const ProblemReport& report)
{
    QStringList names;
    for (const auto& [name, text] : partsOf(report))
        names << QString::fromLatin1(name);
    return names;
}

} // namespace bolster
