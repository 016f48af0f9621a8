#include "FrameSimplifying.h"

#include "MeshExport.h"
#include "SimplifyMesh.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <set>

namespace bolster {

SimplifiedFrame simplifiedFrame(const QString& path, const TriangleMesh& mesh,
                                const std::vector<std::string>& unwanted, std::size_t triangles,
                                const ImportWatch& watch)
{
    const std::set<std::string> left(unwanted.begin(), unwanted.end());
    std::vector<bool> wanted;
    for (const TriangleMesh::Part& part : mesh.parts)
        wanted.push_back(!left.contains(part.name));
    const SimplifiedMesh fewer = simplified(mesh, wanted, triangles, watch.stop);
    SimplifiedFrame frame;
    if (watch.stop.stop_requested())
        return frame;
    if (fewer.mesh.triangles.empty()) {
        frame.problem = {QT_TRANSLATE_NOOP("Message", "nothing is left of the parts that are wanted"), {}};
        return frame;
    }
    frame.folder = std::make_shared<QTemporaryDir>();
    frame.path = frame.folder->filePath(QFileInfo(path).completeBaseName() + QStringLiteral(".obj"));
    frame.problem = writeMesh(fewer.mesh, frame.path, "unit and axes as in the file that it is from");
    if (!frame.problem.empty())
        return frame;
    ImportedFile read = importFile(FileKind::Mesh, frame.path, watch); // as the design will read it
    frame.content = std::move(read.content);
    frame.problem = std::move(read.problem);
    return frame;
}

} // namespace bolster
