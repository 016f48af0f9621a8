#include "Imaging.h"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

namespace bolster {

namespace {

namespace fs = std::filesystem;

/// That of this installation - of the workbench, and of the programs beside it - or of this build.
fs::path modulePath()
{
    std::error_code problem;
    const fs::path folder = fs::read_symlink("/proc/self/exe", problem).parent_path();
    const fs::path name("bolster-imaging.so");
    for (const fs::path& installed : {folder / ".." / "libexec" / "bolster" / name, folder / name})
        if (fs::exists(installed, problem))
            return installed;
    return BOLSTER_IMAGING_MODULE;
}

const Imaging& load()
{
    const fs::path path = modulePath();
    // It stays: what it has made may be in use until the end.
    void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    using Entry = const Imaging* (*)();
    const auto entry = module ? reinterpret_cast<Entry>(dlsym(module, "bolsterImaging")) : nullptr;
    if (!entry) {
        const char* const why = dlerror();
        throw std::runtime_error("pictures cannot be made, install Bolster again (" +
                                 std::string(why ? why : path.c_str()) + ")");
    }
    return *entry();
}

} // namespace

const Imaging& imaging()
{
    static const Imaging& loaded = load();
    return loaded;
}

} // namespace bolster
