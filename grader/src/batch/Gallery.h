#pragma once

#include "Files.h"

namespace grader {

/// What a gallery shows, for whoever made it.
struct GalleryCount {
    std::size_t students = 0;  ///< with at least one picture
    std::size_t pictures = 0;  ///< that differ
};

/// The pictures of a class without names, to be shown in a lecture: `into`/index.html, which needs
/// no network, and a folder of pictures beside it. Those that are the same are there once, with how
/// many have them, the most frequent first, and otherwise in an order that says nothing. Neither
/// page nor file names say whose a picture is, or its points.
///
/// `results` is what a batch wrote; of that only the folders for students are read, so no frame has
/// a reference that depends on a secret seed. `course`: the top of the repository. Throws Error
/// when there are no results, no picture, or `into` is there already and not empty.
GalleryCount writeGallery(const fs::path& course, const fs::path& results, const fs::path& into);

}  // namespace grader
