#pragma once

namespace confine {

/// Refuses this process, and all that it starts, every system call that a compiler, a linker or a
/// program that draws has no use for: tracing others, namespaces and mounts, keys, BPF, io_uring,
/// performance counters, modules, sockets of every family. Refused calls fail (EPERM; sockets
/// EACCES; clone3 ENOSYS, after which the C library takes clone); calls of a foreign architecture
/// end the process. Cannot be undone. Throws std::runtime_error where the kernel has no seccomp.
///
/// Tried on x86-64. The list names calls, not numbers, so aarch64 should do, untested.
void refuseDangerousCalls();

}  // namespace confine
