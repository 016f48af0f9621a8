// What a program that reads a file of unknown origin has been given by whoever has started it (runHelper).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bolster {

/// The bytes of an open file, read-only; none when it is empty or no ordinary file.
class MappedFile {
public:
    explicit MappedFile(int descriptor);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view view() const;

private:
    void* m_bytes;
    std::size_t m_size = 0;
};

/// A file that is open beside the one on the standard input.
struct GivenFile {
    int descriptor = -1;
    std::string name;
};
/// As the arguments from `first` on say: "NUMBER=NAME".
std::vector<GivenFile> givenFiles(int argc, char** argv, int first);

/// What is said to whoever has started this program. Libraries print to the standard output whenever they like, so
/// it gets a descriptor of its own, and what they print goes the way of errors.
class Answer {
public:
    Answer();

    int descriptor() const { return m_descriptor; }
    /// Ends the program when nobody listens any more.
    void write(std::string_view bytes) const;

private:
    int m_descriptor;
};

/// Ends with whoever has started it, and has no environment.
void leaveEverything();

} // namespace bolster
