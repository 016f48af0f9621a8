#include "JobFolder.h"

#include "TriangleMesh.h"
#include "WholeFile.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <filesystem>
#include <system_error>

namespace bolster::cli {

JobFolder::JobFolder(QString path, const std::string& asked)
    : m_path(std::move(path))
    , m_asked(jobHash(asked).toHex().toStdString())
{}

Message JobFolder::open() const
{
    const QDir folder(m_path);
    if (folder.exists() && !folder.isEmpty() && !folder.exists("asked"))
        return {QT_TRANSLATE_NOOP("Message", "The folder \"%1\" holds other files: choose one of its own."),
                {m_path.toStdString()}};
    if (Message problem = madeFolder(m_path); !problem.empty())
        return problem;
    const QString name = file("asked");
    if (!QFile::exists(name))
        return replaceWholeFile(name, m_asked + "\n");
    if (readWholeFile(name, 100).bytes != m_asked + "\n")
        return {QT_TRANSLATE_NOOP("Message", "The folder \"%1\" holds the work of another design or of other "
                                             "options: choose another folder."),
                {m_path.toStdString()}};
    return {};
}

Message madeFolder(const QString& path)
{
    std::error_code error;
    std::filesystem::create_directories(QFile::encodeName(path).toStdString(), error);
    if (!error && !QFileInfo(path).isDir())
        error = std::make_error_code(std::errc::not_a_directory);
    if (!error)
        return {};
    return {QT_TRANSLATE_NOOP("Message", "The folder \"%1\" cannot be made (%2)."),
            {path.toStdString(), error.message()}};
}

QByteArray jobHash(const std::string& bytes)
{
    return QCryptographicHash::hash(QByteArrayView(bytes.data(), std::ssize(bytes)), QCryptographicHash::Sha1);
}

std::string meshesAsText(const DesignFiles& files)
{
    std::string text;
    for (const auto& [id, mesh] : files.meshes) {
        for (const Vec3& point : mesh->points)
            text.append(reinterpret_cast<const char*>(point.data()), 3 * sizeof(double));
        for (const auto& triangle : mesh->triangles)
            text.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
    }
    return text;
}

} // namespace bolster::cli
