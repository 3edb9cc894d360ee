#include "BuildId.h"

#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <optional>
#include <vector>

namespace grader {

namespace {

/// Notes are small, and stand near the beginning.
constexpr std::size_t kMostNotes = 64 * 1024;

template <class T>
std::optional<T> readAt(std::ifstream& file, std::uint64_t offset) {
    T value;
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(reinterpret_cast<char*>(&value), sizeof value);
    return file ? std::optional(value) : std::nullopt;
}

std::size_t aligned(std::size_t size) {
    return (size + 3) / 4 * 4;
}

/// The id among the notes of one segment, in hexadecimal digits; empty when it is not there.
std::string idAmong(const std::vector<char>& notes) {
    for (std::size_t at = 0; at + sizeof(Elf64_Nhdr) <= notes.size();) {
        Elf64_Nhdr head;
        std::memcpy(&head, notes.data() + at, sizeof head);
        const std::size_t name = at + sizeof head, value = name + aligned(head.n_namesz);
        if (value + head.n_descsz > notes.size())
            return "";
        if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == sizeof ELF_NOTE_GNU &&
            std::memcmp(notes.data() + name, ELF_NOTE_GNU, sizeof ELF_NOTE_GNU) == 0) {
            std::string id;
            for (std::size_t i = 0; i < head.n_descsz; ++i)
                id += fmt::format("{:02x}", static_cast<unsigned char>(notes[value + i]));
            return id;
        }
        at = value + aligned(head.n_descsz);
    }
    return "";
}

std::string buildIdOf(const fs::path& program) {
    std::ifstream file(program, std::ios::binary);
    const auto head = readAt<Elf64_Ehdr>(file, 0);
    if (!head || std::memcmp(head->e_ident, ELFMAG, SELFMAG) != 0 ||
        head->e_ident[EI_CLASS] != ELFCLASS64)
        return "";
    for (std::uint64_t i = 0; i < head->e_phnum; ++i) {
        const auto segment = readAt<Elf64_Phdr>(file, head->e_phoff + i * head->e_phentsize);
        if (!segment)
            return "";
        if (segment->p_type != PT_NOTE || segment->p_filesz > kMostNotes)
            continue;
        std::vector<char> notes(segment->p_filesz);
        file.seekg(static_cast<std::streamoff>(segment->p_offset));
        if (!file.read(notes.data(), static_cast<std::streamsize>(notes.size())))
            return "";
        if (const std::string id = idAmong(notes); !id.empty())
            return id;
    }
    return "";
}

}  // namespace

std::string identityOf(const fs::path& program) {
    const std::string id = buildIdOf(program);
    return id.empty() ? sha256(readFile(program)) : id;
}

}  // namespace grader
