#pragma once

namespace cg {

/// Whether a destructor may delete GL objects that were made while context number `madeIn` was
/// current (see currentContextId; 0 when that is not known). Objects with static lifetime outlive
/// the window: by then their context, and the objects with it, are gone, a GL call would reach
/// nothing or, worse, the objects of a newer context. Then the answer is no and nothing leaks.
bool mayDelete(unsigned madeIn) noexcept;

}  // namespace cg
