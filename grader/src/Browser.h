#pragma once

#include "Files.h"

namespace grader {

/// Opens a page in the browser that the desktop prefers, which goes on without this program. False
/// when that fails: no xdg-open, or no browser.
bool openInBrowser(const fs::path& page);

}  // namespace grader
