// How the readers of files say no: they throw this, importMesh and importCloud catch it.
#pragma once

#include "Message.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolster {

/// A place in a file: a line (from 1) of a text, a byte (from 0) of a binary file, or the file as a whole.
struct FilePlace {
    enum class Unit { File, Line, Byte };

    Unit unit = Unit::File;
    std::uint64_t number = 0;
};

/// In `sentence`, %1 stands for file and place; `args` are for %2, %3 ...
struct FileRefused {
    FilePlace place;
    std::string sentence;
    std::vector<std::string> args;
};

[[noreturn]] inline void refuseFile(FilePlace place, std::string sentence, std::vector<std::string> args = {})
{
    throw FileRefused{place, std::move(sentence), std::move(args)};
}

/// A word of an untrusted file, made fit for a message.
std::string excerpt(std::string_view word);

} // namespace bolster
