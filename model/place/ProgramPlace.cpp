#include "ProgramPlace.h"

namespace bolster {
namespace {

namespace fs = std::filesystem;

constexpr int mostFoldersInBuild = 4; // build/tests/widgets/...

} // namespace

fs::path programFolder()
{
    std::error_code problem;
    return fs::read_symlink("/proc/self/exe", problem).parent_path();
}

fs::path buildAround(const fs::path& folder)
{
    std::error_code problem;
    fs::path found = folder;
    for (int i = 0; i < mostFoldersInBuild && found.has_relative_path(); ++i, found = found.parent_path())
        if (fs::is_regular_file(found / "CMakeCache.txt", problem))
            return found;
    return {};
}

fs::path shippedFile(const std::string& name, const std::string& folderInBuild)
{
    const fs::path program = programFolder();
    if (program.empty())
        return {};
    std::error_code problem;
    const fs::path build = buildAround(program);
    for (const fs::path& folder :
         {program / ".." / "libexec" / "bolster", program, build.empty() ? fs::path() : build / folderInBuild})
        if (const fs::path file = folder / name; !folder.empty() && fs::is_regular_file(file, problem))
            return file.lexically_normal();
    return {};
}

} // namespace bolster
