#pragma once

#include <cg/Resources.h>
#include <cg/Todo.h>

#include <functional>
#include <map>
#include <string>

#include "protocol/Value.h"
#include "runner/SeededValues.h"

/// What an assignment offers to the runner: functions to call and frames to draw.
///
/// An assignment's harness.cpp says, once:
///
///     CG_HARNESS(harness) {
///         harness.function("rotation", [](float degrees, glm::vec3 axis) {
///             return rotation(degrees, axis);
///         });
///         harness.frame("turned", [](const FrameRequest& request) { ... });
///     }
///
/// Student code must be called, never have its address taken: a function that a submission lacks
/// is found out at the call, and costs only the checks that make it.

/// A frame to draw. The context is current, its viewport is the whole picture.
struct FrameRequest {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::uint64_t seed = 1;
};

class Harness {
public:
    using Function = std::function<protocol::Bytes(protocol::ByteReader&)>;
    using Frame = std::function<void(const FrameRequest&)>;

    /// Offers a callable whose argument and result types are those of Value.h.
    template <class F>
    void function(const std::string& name, F callable) {
        functions[name] = wrap(std::function(std::move(callable)));
    }
    void frame(const std::string& name, Frame draw) { frames[name] = std::move(draw); }

    std::map<std::string, Function> functions;
    std::map<std::string, Frame> frames;

    // The subject carries its own copy of library cg; these reach it.
    const std::vector<std::string>& (*reachedTodos)() = nullptr;
    void (*clearTodos)() = nullptr;
    void (*addResourceFolder)(const std::string&) = nullptr;

private:
    template <class R, class... A>
    static Function wrap(std::function<R(A...)> callable) {
        return [callable](protocol::ByteReader& in) {
            // Braces fix the order of evaluation.
            std::tuple<std::decay_t<A>...> arguments{protocol::Codec<std::decay_t<A>>::read(in)...};
            in.end();
            return protocol::encode(std::apply(callable, arguments));
        };
    }
};

#define CG_HARNESS(harness)                                 \
    static void cgDescribeHarness(Harness& harness);        \
    extern "C" void cg_register_harness(Harness& harness) { \
        harness.reachedTodos = &cg::reachedTodos;           \
        harness.clearTodos = &cg::clearTodos;               \
        harness.addResourceFolder = &cg::addResourceFolder; \
        cgDescribeHarness(harness);                         \
    }                                                       \
    static void cgDescribeHarness(Harness& harness)
