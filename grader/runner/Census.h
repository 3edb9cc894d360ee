#pragma once

#include <cg/Context.h>

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/DrawCall.h"

/// The draw census: what a scene really drew, whatever the student's code looks like.
///
/// The runner exports its own draw entry points (glDrawElements and its kin), which the subject is
/// bound to before the driver's. They note the call and pass it on. So do those that compile and
/// link shaders, for the sake of driverWork(). An instrument of honesty, not a wall: code that asks
/// the driver for the real pointer goes around it.
namespace runner {

/// From now on calls go to `context`, which must stay until another is given.
void setCensusContext(const cg::Context* context);

/// Begins anew. Unfilled regions of the shaders in use are always noted, calls only when
/// `recordCalls`.
void beginCensus(bool recordCalls);

struct Census {
    std::vector<protocol::DrawCall> calls;
    std::vector<std::string> todos;  ///< ids, each once
};
Census takeCensus();

/// What the driver is at work on for the subject, in this thread. May be asked by a signal handler.
enum class DriverWork : std::uint64_t { none, shaders, drawing };
DriverWork driverWork();

}  // namespace runner
