#include "FitForm.h"

#include "CloudImport.h"
#include "MeshImport.h"

namespace bolster {

bool readTarget(const FitForm& form, FitTarget& target, Message& problem, const std::stop_token& stop)
{
    if (form.scan && form.cloud) {
        target = targetOf(*form.scan, *form.cloud);
        return true;
    }
    if (form.file.isEmpty())
        return true;
    const ImportedMesh read = importMesh(form.file, {stop, {}, {}});
    if (read.mesh && !read.mesh->triangles.empty()) {
        target = targetOf(*read.mesh);
        return true;
    }
    const ImportedCloud cloud = importCloud(form.file, {stop, {}, {}});
    if (cloud.cloud)
        target = targetOf(Scan{}, *cloud.cloud);
    problem = read.mesh ? cloud.problem : read.problem;
    return cloud.cloud != nullptr;
}

} // namespace bolster
