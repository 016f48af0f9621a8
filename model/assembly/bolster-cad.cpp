// A process of its own that reads one STEP or IGES file of unknown origin: the file on its standard input, its
// parts on its standard output (AssemblyWriter). It may crash, hang or run out of memory; importAssembly() limits
// it and cleans up after it. Before it looks at the first byte it gives up all rights but these two.
//
//   bolster-cad step|iges TOLERANCE_UM [edges]
#include "CadFile.h"
#include "GivenFiles.h"
#include "PartMesh.h"
#include "Sandbox.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

using namespace bolster;

namespace {

CadOrder orderOf(int argc, char** argv)
{
    CadOrder order;
    if (argc > 1 && std::string_view(argv[1]) == "iges")
        order.kind = CadOrder::Kind::Iges;
    if (argc > 2)
        order.tolerance = std::max(1, std::atoi(argv[2])) / 1000.0;
    order.edges = argc > 3 && std::string_view(argv[3]) == "edges";
    return order;
}

} // namespace

int main(int argc, char** argv)
{
    leaveEverything();
    const Answer answer;
    const int kept[] = {answer.descriptor()};
    const CadOrder order = orderOf(argc, argv);
    prepareCad();
    if (!enterSandbox(kept))
        ::_exit(4);
    const MappedFile file(STDIN_FILENO);
    const int code = writeAssembly([&answer](std::string_view bytes) { answer.write(bytes); },
                                   [&](AssemblyWriter& writer) { readCad(file.view(), order, writer); });
    ::_exit(code); // no library tidies up
}
