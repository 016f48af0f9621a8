// Where the running program lies, and what is shipped with it.
#pragma once

#include <filesystem>
#include <string>

namespace bolster {

/// The folder of the running program, links followed; empty when nobody can say. (Qt's own answer needs an
/// application object, which the command line has none of.)
std::filesystem::path programFolder();

/// The build that a program belongs to which lies in `folder`: a program is not moved without being installed, so
/// none has to know a path. Empty for what is installed.
std::filesystem::path buildAround(const std::filesystem::path& folder);

/// A file "../libexec/bolster/NAME" of this installation, or "NAME" beside the program, or in `folderInBuild` of
/// this build; empty when there is none.
std::filesystem::path shippedFile(const std::string& name, const std::string& folderInBuild);

} // namespace bolster
