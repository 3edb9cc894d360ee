#include <cg/EglContext.h>
#include <cg/ShaderProbe.h>
#include <runner/Census.h>
#include <runner/Harness.h>

#include "subject/JudgeMain.h"

/// The same tests with the subject linked in: no sandbox, no pipe, so that a debugger can step
/// from a failing check into the student's function.

extern "C" void cg_register_harness(Harness& harness);

namespace judge {

namespace {

class LinkedSubject : public Subject {
public:
    LinkedSubject() { cg_register_harness(harness_); }

protected:
    protocol::Answer answerTo(protocol::Request request) override {
        protocol::Answer answer;
        const auto found = harness_.functions.find(request.name);
        if (found == harness_.functions.end()) {
            answer.outcome = protocol::Outcome::unknown;
            answer.detail = "the harness has no function " + request.name;
            return answer;
        }
        harness_.clearTodos();
        try {
            protocol::ByteReader arguments(request.arguments);
            answer.payload = request.kind == protocol::RequestKind::draw
                                 ? draw(request, [&] { return found->second(arguments); })
                                 : found->second(arguments);
        } catch (const cg::MissingFunction& error) {
            answer.outcome = protocol::Outcome::missing;
            answer.detail = error.what();
        } catch (const std::exception& error) {  // `catch throw` stops a debugger where it starts
            answer.outcome = protocol::Outcome::exception;
            answer.detail = error.what();
        }
        answer.todos = harness_.reachedTodos();
        return answer;
    }

private:
    template <class Work>
    protocol::Bytes draw(const protocol::Request& request, Work work) {
        if (!context_)
            context_ = cg::createEglContext(64, 64);
        runner::setCensusContext(context_.get());
        runner::beginCensus(request.census);
        protocol::Bytes value = work();
        return protocol::encodeDrawAnswer({std::move(value), runner::takeCensus().calls});
    }

    std::unique_ptr<cg::Context> context_;
    Harness harness_;
};

}  // namespace

std::unique_ptr<Subject> makeSubject(const std::vector<std::string>&, const KernelLimits&) {
    return std::make_unique<LinkedSubject>();
}

}  // namespace judge
