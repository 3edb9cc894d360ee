#pragma once

#include "Files.h"
#include "compare/Picture.h"

namespace grader {

/// Reading and writing image files, by library cg_image. It is loaded at the first use only: its
/// 260 libraries cost a quarter of a second, and most runs need no image file.
/// Both throw Error with the library's reason.
Picture readPicture(const fs::path& path);
void writePicture(const fs::path& path, const Picture& picture);

/// The same picture, without its `broken`, by way of a cache of decoded pictures in `cacheFolder`,
/// which needs no library when the file has been read before.
Picture readPictureCached(const fs::path& path, const fs::path& cacheFolder);

}  // namespace grader
