// Project files: the design with its whole history and the files it uses (docs/project-file.md).
#pragma once

#include "DesignFile.h"
#include "EditCodec.h"
#include "Hash.h"
#include "History.h"

#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace bolster {

class Database;

/// What a project knows of a node of its history besides what History does.
struct ProjectNode {
    std::array<std::uint8_t, 16> uid{}; ///< the same in every copy of the project
    std::int64_t run = 0;               ///< of the program: increases each time the project is opened for work
    Hash designHash{};                  ///< of the design after the edit
    Hash rowHash{};                     ///< of everything about the node and all before it
};

struct OpenedProject {
    Message problem;      ///< why it could not be opened; the rest is empty then
    bool damaged = false; ///< that is why: salvageProject may help
    std::string uuid;     ///< the same in all copies of the project
    Design design;        ///< of the current node
    History history;
    std::vector<ProjectNode> nodes;             ///< by NodeId
    std::optional<NodeId> saved;                ///< the node that was saved last
    Hash seal{};                                ///< of everything in the file but pictures
    std::optional<Hash> base;                   ///< of a journal: the seal of the project file that it goes with
    std::map<std::string, std::int64_t> assets; ///< by name: numbers in the file
    std::int64_t designsChecked = 0;            ///< so many of the first ones are what their edits lead to
    std::shared_ptr<Database> database;         ///< what the history and the assets are read from
};

enum class ProjectCheck {
    ToWork,    ///< all rows and the current design: 0.5 s with 100,000 edits
    Thorough,  ///< and all assets, and the design after each edit as far as that takes some seconds
    Everything ///< and all of these designs, however long that takes
};

/// The problem of a project that cannot be opened, for a line on stderr: names the file, and `bolster salvage`
/// where that may help.
Message damageAdvice(const OpenedProject& project, const QString& path);

/// Only whether it is a project or a text, by the first bytes.
bool looksLikeProject(const QString& path);

/// The project's name among all, or "" when it cannot be read; nothing else is looked at. Of a journal, too.
std::string projectUuid(const QString& path);

struct ProjectPicture {
    std::string png;      ///< bytes that anybody may have made; empty when there is none
    Message problem;      ///< why the project cannot be read
    bool damaged = false; ///< that is why
};

/// The small picture of the current version, or of the newest before it that has one. Nothing else of the project
/// is looked at, so that it is quick, however long the history is.
ProjectPicture projectPicture(const QString& path);

/// Opens a project file without changing it. Nothing but a problem when anything is wrong with it: see
/// salvageProject.
OpenedProject openProject(const QString& path, ProjectCheck check = ProjectCheck::ToWork);

/// What the edit of a node changes, as it is stored; nothing when it cannot be read.
std::optional<FieldChanges> storedChanges(const OpenedProject& project, NodeId node);

/// The largest id that any version gives to anything. Looks at all edits: with many of them it takes a while.
ElementId largestIdEver(const OpenedProject& project);

/// Writes all assets below this folder, which is made if it isn't there. Nothing when one of the files is there
/// already; stops at the first that fails.
Message extractAllAssets(const OpenedProject& project, const QString& folder);

/// Writes the files that elements of the design name to this folder, below it with the folders they name. What an
/// asset lacks is a problem of the elements that use it.
Problems extractAssets(const OpenedProject& project, const Design& design, const QString& folder);

/// A design from either form, with its files: that of a text (openDesign), or the current one of a project.
OpenedDesign openDesignOrProject(const QString& path);

} // namespace bolster
