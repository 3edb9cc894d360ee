#pragma once

#include <string>
#include <vector>

namespace confine {

/// Whether this kernel can hold a process to named files (Landlock, Linux 5.13; a container's own
/// filter may refuse it).
bool canHoldToFiles();

/// Holds this process, and all that it starts, to these files and folders, and to devices such as
/// /dev/null: what is `readable` may be read and started, what is `writable` also changed.
/// Nothing else can be opened, though names and sizes of other files can be seen. From Linux 6.12
/// on, no signal reaches a process outside either. Does nothing where the kernel cannot. Cannot be
/// undone. Throws std::runtime_error for a folder that is not there.
void holdToFiles(const std::vector<std::string>& readable,
                 const std::vector<std::string>& writable);

}  // namespace confine
