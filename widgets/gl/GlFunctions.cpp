#include "GlFunctions.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <QSurfaceFormat>

namespace bolster {

bool promisesGl()
{
    static const QStringList platforms{QStringLiteral("xcb"), QStringLiteral("wayland"), QStringLiteral("windows"),
                                       QStringLiteral("cocoa")};
    const QString platform = QGuiApplication::platformName();
    return std::any_of(platforms.begin(), platforms.end(),
                       [&](const QString& p) { return platform.startsWith(p); });
}

GlFunctions* glFunctions()
{
    QOpenGLContext* context = QOpenGLContext::currentContext();
    return context ? QOpenGLVersionFunctionsFactory::get<GlFunctions>(context) : nullptr;
}

QSurfaceFormat glFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    return format;
}

void loadGl()
{
    QOpenGLContext context;
    context.setFormat(glFormat());
    if (promisesGl())
        context.create();
}

QString glProblem()
{
    const auto problem = [](const char* text) { return QCoreApplication::translate("bolster::GlCanvas", text); };
    if (!promisesGl())
        return problem(QT_TRANSLATE_NOOP("bolster::GlCanvas", "No OpenGL: drawn in software"));

    QOpenGLContext context;
    context.setFormat(glFormat());
    if (!context.create())
        return problem(QT_TRANSLATE_NOOP("bolster::GlCanvas", "No OpenGL: drawn in software"));
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return problem(QT_TRANSLATE_NOOP("bolster::GlCanvas", "No OpenGL: drawn in software"));
    const bool usable = glFunctions() != nullptr;
    context.doneCurrent();
    return usable ? QString()
                  : problem(QT_TRANSLATE_NOOP("bolster::GlCanvas", "OpenGL is older than 3.3: drawn in software"));
}

} // namespace bolster
