// The folder of work that can be ended and goes on there, on one machine or several.
#pragma once

#include "DesignFiles.h"
#include "Message.h"

#include <QByteArray>
#include <QString>

#include <string>

namespace bolster::cli {

class JobFolder {
public:
    /// `asked`: everything that the result depends on; other work than what is there already is a problem.
    JobFolder(QString path, const std::string& asked);

    /// Makes the folder, or says why not.
    Message open() const;
    QString file(const QString& name) const { return m_path + "/" + name; }

private:
    QString m_path;
    std::string m_asked; ///< its hash
};

/// Makes it with those above it, or says why not.
Message madeFolder(const QString& path);

/// SHA-1, of 20 bytes: against mistakes, not against people.
QByteArray jobHash(const std::string& bytes);

/// Foam and frames that a result depends on, so that others are told from them.
std::string meshesAsText(const DesignFiles& files);

} // namespace bolster::cli
