#include "ImageModule.h"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <memory>

#include "Error.h"

namespace grader {

namespace {

struct ImageModule {
    using Read = int (*)(const char*, int*, int*, unsigned char**, unsigned char**, char*,
                         std::size_t);
    using Write = int (*)(const char*, int, int, const unsigned char*, char*, std::size_t);
    Read read;
    Write write;
};

const ImageModule& imageModule() {
    static const ImageModule loaded = [] {
        void* library = dlopen(COURSE_IMAGE_LIBRARY, RTLD_NOW | RTLD_LOCAL);
        if (!library)
            throw Error(
                "the image library cannot be loaded: {}; install libopenimageio and build "
                "again",
                dlerror());
        return ImageModule{reinterpret_cast<ImageModule::Read>(dlsym(library, "cg_image_read")),
                           reinterpret_cast<ImageModule::Write>(dlsym(library, "cg_image_write"))};
    }();
    return loaded;
}

constexpr std::size_t kErrorSize = 1024;

}  // namespace

Picture readPicture(const fs::path& path) {
    Picture picture;
    unsigned char *pixels = nullptr, *broken = nullptr;
    char error[kErrorSize] = "";
    if (imageModule().read(path.c_str(), &picture.width, &picture.height, &pixels, &broken, error,
                           sizeof error) != 0)
        throw Error("{} cannot be read: {}", path.string(), error);
    const std::unique_ptr<unsigned char, void (*)(void*)> owned(pixels, std::free);
    const auto size = std::size_t(4) * static_cast<std::size_t>(picture.width) *
                      static_cast<std::size_t>(picture.height);
    picture.rgba.assign(pixels, pixels + size);
    const std::unique_ptr<unsigned char, void (*)(void*)> ownedFlags(broken, std::free);
    for (std::size_t i = 0; broken && i < size / 4; ++i)
        if (broken[i])
            picture.broken.push_back(i);
    return picture;
}

void writePicture(const fs::path& path, const Picture& picture) {
    if (path.has_parent_path())
        fs::create_directories(path.parent_path());
    char error[kErrorSize] = "";
    if (imageModule().write(path.c_str(), picture.width, picture.height, picture.rgba.data(), error,
                            sizeof error) != 0)
        throw Error("{} cannot be written: {}", path.string(), error);
}

Picture readPictureCached(const fs::path& path, const fs::path& cacheFolder) {
    const fs::path entry = cacheFolder / sha256(readFile(path));
    if (fs::exists(entry)) {
        const std::string bytes = readFile(entry);
        Picture picture;
        constexpr std::size_t kHeader = 2 * sizeof(int);
        if (bytes.size() > kHeader) {
            std::memcpy(&picture.width, bytes.data(), sizeof(int));
            std::memcpy(&picture.height, bytes.data() + sizeof(int), sizeof(int));
            picture.rgba.assign(bytes.begin() + kHeader, bytes.end());
        }
        if (picture.rgba.size() ==
            std::size_t(4) * static_cast<std::size_t>(picture.width) * std::size_t(picture.height))
            return picture;
    }
    Picture picture = readPicture(path);
    std::string bytes(reinterpret_cast<const char*>(&picture.width), sizeof(int));
    bytes.append(reinterpret_cast<const char*>(&picture.height), sizeof(int));
    bytes.append(picture.rgba.begin(), picture.rgba.end());
    try {
        writeFile(entry, bytes);
    } catch (const std::exception&) {  // a cache that cannot be written: it is read again then
    }
    return picture;
}

}  // namespace grader
