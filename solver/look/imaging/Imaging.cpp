#include "Imaging.h"

#include "ProgramPlace.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace bolster {

namespace {

const Imaging& load()
{
    // Of the workbench, and of the programs beside it.
    const std::string path = shippedFile("bolster-imaging.so", "solver/look/painting").string();
    // It stays: what it has made may be in use until the end.
    void* const module = path.empty() ? nullptr : dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    using Entry = const Imaging* (*)();
    const auto entry = module ? reinterpret_cast<Entry>(dlsym(module, "bolsterImaging")) : nullptr;
    if (!entry) {
        const char* const why = path.empty() ? "there is no bolster-imaging.so" : dlerror();
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
