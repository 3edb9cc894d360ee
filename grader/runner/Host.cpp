#include "runner/Host.h"

#include <cg/GlslProgram.h>
#include <cg/HeadlessContext.h>
#include <cg/ShaderProbe.h>
#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <utility>

#include "runner/Census.h"
#include "runner/CrashReport.h"
#include "runner/Undrawn.h"

namespace runner {

namespace {

using protocol::Answer;
using protocol::Bytes;
using protocol::Outcome;
using protocol::Request;
using protocol::RequestKind;

/// Ends a request with an outcome of its own.
struct Refusal {
    Outcome outcome;
    std::string detail;
};

/// dlerror says "…: undefined symbol: NAME" when a relocation cannot be resolved.
Refusal refusalOfLoader(const std::string& error) {
    const std::string marker = "undefined symbol: ";
    if (const auto at = error.find(marker); at != std::string::npos) {
        const auto start = at + marker.size();
        return {Outcome::missing, error.substr(start, error.find_first_of(" ,\n", start) - start)};
    }
    return {Outcome::faulty, "the subject cannot be loaded: " + error};
}

/// Addresses taken by the object that contains `address`.
void rememberObject(const void* address) {
    Dl_info info{};
    link_map* map = nullptr;
    if (!dladdr1(address, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP))
        return;
    const auto base = reinterpret_cast<std::uintptr_t>(info.dli_fbase);
    const auto* header = static_cast<const ElfW(Ehdr)*>(info.dli_fbase);
    const auto* segments = reinterpret_cast<const ElfW(Phdr)*>(base + header->e_phoff);
    std::uintptr_t end = base;
    for (int i = 0; i < header->e_phnum; ++i)
        if (segments[i].p_type == PT_LOAD)
            end = std::max(end, base + segments[i].p_vaddr + segments[i].p_memsz);
    setCrashObject(base, end);
}

void flushOutput() {
    std::cout.flush();
    std::fflush(nullptr);
}

}  // namespace

void Host::serve(int descriptor) {
    for (;;) {
        Bytes body;
        if (protocol::readMessage(descriptor, protocol::kRequestMagic, protocol::kLargestRequest,
                                  -1, body) != protocol::ReadStatus::ok)
            _exit(0);
        const Request request = protocol::decodeRequest(body);
        Answer answer = perform(request);
        answer.nonce = request.nonce;
        flushOutput();
        if (loaded_) {
            answer.todos = harness_.reachedTodos();
            harness_.clearTodos();
            for (const std::string& id : std::exchange(shaderTodos_, {}))
                if (std::find(answer.todos.begin(), answer.todos.end(), id) == answer.todos.end())
                    answer.todos.push_back(id);
        }
        if (!protocol::writeAll(descriptor, protocol::framed(protocol::kAnswerMagic,
                                                             protocol::encodeAnswer(answer))))
            _exit(0);
    }
}

Answer Host::perform(const Request& request) {
    Answer answer;
    try {
        switch (request.kind) {
            case RequestKind::call:
                answer.payload = call(request);
                break;
            case RequestKind::draw:
                answer.payload = draw(request);
                break;
            case RequestKind::frame:
                answer = drawFrame(request);
                break;
            case RequestKind::graphics:
                answer.payload = describeGraphics();
                break;
        }
    } catch (const Refusal& refusal) {
        answer.outcome = refusal.outcome;
        answer.detail = refusal.detail;
    } catch (const protocol::ProtocolError& error) {
        answer.outcome = Outcome::unknown;
        answer.detail = request.name + ": " + error.what();
    } catch (const cg::GlslError& error) {
        answer.outcome = Outcome::shader;
        answer.detail = error.what();
    } catch (const cg::MissingFunction& error) {
        answer.outcome = Outcome::missing;
        answer.detail = error.what();
    } catch (const std::bad_alloc&) {
        answer.outcome = Outcome::memory;
    } catch (const std::exception& error) {
        answer.outcome = Outcome::exception;
        answer.detail = error.what();
    } catch (...) {
        answer.outcome = Outcome::exception;
        answer.detail = "something that is no std::exception";
    }
    return answer;
}

Bytes Host::call(const Request& request) {
    load();
    const auto found = harness_.functions.find(request.name);
    if (found == harness_.functions.end())
        throw Refusal{Outcome::unknown, "the harness has no function " + request.name};
    protocol::ByteReader arguments(request.arguments);
    return found->second(arguments);
}

Bytes Host::draw(const Request& request) {
    constexpr int kSide = 64;  // pixels of a framebuffer that nobody looks at
    needContext(kSide, kSide);
    beginCensus(request.census);
    protocol::DrawAnswer answer;
    answer.value = call(request);
    Census census = takeCensus();
    shaderTodos_ = std::move(census.todos);
    answer.calls = std::move(census.calls);
    return protocol::encodeDrawAnswer(answer);
}

Answer Host::drawFrame(const Request& request) {
    needContext(request.width, request.height);
    load();
    const auto found = harness_.frames.find(request.name);
    if (found == harness_.frames.end())
        throw Refusal{Outcome::unknown, "the harness has no frame " + request.name};
    const auto drawOver = [&](const Filling& filling) {
        fill(*context_, filling);
        beginCensus(false);
        found->second({request.width, request.height, request.seed});
        shaderTodos_ = takeCensus().todos;
        return context_->readPixels().rgba;
    };
    Answer answer;
    answer.payload = drawOver(kFirstFilling);
    // What looks as if it was not drawn is drawn again over something else.
    if (shows(answer.payload, kFirstFilling))
        answer.code = static_cast<int>(undrawnPixels(answer.payload, drawOver(kSecondFilling)));
    return answer;
}

Bytes Host::describeGraphics() {
    needContext(64, 64);
    return protocol::encodeGraphics(
        {context_->provider(), context_->version(), context_->renderer()});
}

void Host::load() {
    if (loaded_)
        return;
    // Lazily, so that a function which is missing costs only those who call it.
    void* object = dlopen(files_.object.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!object)
        throw refusalOfLoader(dlerror());
    using Register = void (*)(Harness&);
    const auto describe = reinterpret_cast<Register>(dlsym(object, "cg_register_harness"));
    if (!describe)
        throw Refusal{Outcome::faulty, "the subject has no harness"};
    rememberObject(reinterpret_cast<const void*>(describe));
    describe(harness_);
    harness_.addResourceFolder(files_.resourceFolder);
    loaded_ = true;
}

void Host::needContext(int width, int height) {
    try {
        if (!context_)
            context_ = cg::createHeadlessContext(files_.provider, width, height);
        else
            context_->resizeFramebuffer(width, height);
        setCensusContext(context_.get());
        using Viewport = void (*)(int, int, int, int);
        reinterpret_cast<Viewport>(context_->function("glViewport"))(0, 0, width, height);
    } catch (const std::exception& error) {
        throw Refusal{Outcome::faulty, error.what()};
    }
}

}  // namespace runner
