#include "FitForm.h"

#include "FileFormats.h"
#include "FileGuess.h"
#include "FormImport.h"

namespace bolster {

bool readTarget(const FitForm& form, FitTarget& target, Message& problem, const std::stop_token& stop)
{
    if (form.scan && form.cloud) {
        target = targetOf(*form.scan, *form.cloud);
        return true;
    }
    if (form.file.isEmpty())
        return true;
    ImportedForm read = importForm(form.file, {stop, {}, {}});
    read = placed(read, saidPlacement(read.said, endingOf(form.file)));
    if (read.mesh)
        target = targetOf(*read.mesh);
    else if (read.cloud)
        target = targetOf(Scan{}, *read.cloud);
    problem = read.problem;
    return read.mesh || read.cloud;
}

} // namespace bolster
