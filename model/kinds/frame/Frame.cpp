#include "Frame.h"

#include <algorithm>

namespace bolster {

// Backslashes and drive letters count too: the design may travel to a system where they are separators.
std::optional<Message> elementFileProblem(const std::string& file)
{
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
    if (file.empty())
        return Message{
            QT_TRANSLATE_NOOP("Message", "no file is named; write the name of a file beside the design")};
    if (std::any_of(file.begin(), file.end(), isControl) || file.size() > 1000)
        return Message{QT_TRANSLATE_NOOP("Message", "this is no name of a file")};
    const bool drive = file.size() > 1 && file[1] == ':';
    if (file.front() == '/' || drive || file.find('\\') != std::string::npos)
        return Message{QT_TRANSLATE_NOOP("Message",
                                         "\"%1\" must be relative to the design's folder and use \"/\" between "
                                         "folders"),
                       {file}};
    for (std::size_t start = 0; start <= file.size();) {
        const std::size_t end = std::min(file.find('/', start), file.size());
        if (file.compare(start, end - start, "..") == 0)
            return Message{QT_TRANSLATE_NOOP("Message",
                                             "\"%1\" goes up with \"..\"; write the way from the design's "
                                             "folder without it, or copy the file there"),
                           {file}};
        start = end + 1;
    }
    return std::nullopt;
}

} // namespace bolster
