// unpack ARCHIVE FOLDER: unpacks what a student handed in, inside the sandbox, into an empty
// folder. Exit code 0: all of it is there. 1: the archive is refused; standard output says why, in
// one line. 2: something else went wrong; standard error says what.

#include <cstdio>
#include <exception>

#include "unpack/Unpack.h"

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: unpack ARCHIVE FOLDER\nStarted by the grader, not by hand.\n");
        return 2;
    }
    try {
        const std::string refusal = unpack::unpack(argv[1], argv[2]);
        if (refusal.empty())
            return 0;
        std::puts(refusal.c_str());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "unpack: %s\n", error.what());
        return 2;
    }
}
