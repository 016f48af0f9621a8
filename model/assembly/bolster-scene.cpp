// A process of its own that reads one file of a modelling program, of unknown origin: the file on its standard
// input, its parts on its standard output (AssemblyWriter). It may crash, hang or run out of memory;
// importAssembly() limits it and cleans up after it. Before it looks at the first byte it gives up all rights but
// these two.
//
//   bolster-scene gltf|glb|fbx|dae|3mf [NUMBER=NAME ...]     NUMBER: an open file that lies beside it
#include "GivenFiles.h"
#include "PartMesh.h"
#include "Sandbox.h"
#include "SceneFile.h"

#include <memory>
#include <unistd.h>

using namespace bolster;

int main(int argc, char** argv)
{
    leaveEverything();
    const Answer answer;
    std::vector<int> kept = {answer.descriptor()};
    const std::vector<GivenFile> beside = givenFiles(argc, argv, 2);
    for (const GivenFile& file : beside)
        kept.push_back(file.descriptor);
    if (argc < 2 || !enterSandbox(kept))
        ::_exit(4);
    const MappedFile file(STDIN_FILENO);
    SceneOrder order{argv[1], {}};
    std::vector<std::unique_ptr<MappedFile>> mapped;
    for (const GivenFile& one : beside) {
        mapped.push_back(std::make_unique<MappedFile>(one.descriptor));
        order.beside.emplace(one.name, mapped.back()->view());
    }
    const int code = writeAssembly([&answer](std::string_view bytes) { answer.write(bytes); },
                                   [&](AssemblyWriter& writer) { readScene(file.view(), order, writer); });
    ::_exit(code); // no library tidies up
}
