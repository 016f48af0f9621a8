#include "ViewerParts.h"

#include <QFile>

namespace bolster {

namespace {

std::string viewerResource(const char* name)
{
    QFile file(QStringLiteral(":/viewer/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("a resource of the viewer is missing");
    return file.readAll().toStdString();
}

} // namespace

PageParts viewerParts()
{
    PageParts parts;
    parts.html = viewerResource("page.html");
    parts.style = viewerResource("page.css");
    parts.script = viewerResource("page.js");
    parts.licence = viewerResource("LICENSE.three");
    for (const char* const library : {"three/three.min.js", "three/examples/js/controls/OrbitControls.js",
                                      "three/examples/js/loaders/GLTFLoader.js"})
        parts.libraries.push_back(viewerResource(library));
    return parts;
}

} // namespace bolster
