#include "Reported.h"

#include "Output.h"
#include "Subcommands.h"

#include <exception>
#include <new>

namespace bolster::cli {

int reported(const std::string& name, const std::function<int()>& command)
{
    try {
        return command();
    } catch (const UsageError& error) {
        printError(name + ": " + error.what());
        printError("Try \"" + name + " --help\".");
        return badInput;
    } catch (const std::bad_alloc&) {
        printError(name + ": there is not enough memory for this design");
    } catch (const std::exception& error) {
        printError(name + ": " + error.what());
    }
    return otherFailure;
}

} // namespace bolster::cli
