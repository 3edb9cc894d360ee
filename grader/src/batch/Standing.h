#pragma once

#include <memory>
#include <string>

#include "batch/Essence.h"

namespace grader {

/// What became of one submission of a batch.
struct Standing {
    std::string entrant;   ///< its name
    std::string status;    ///< of the result document, or "refused", or "grader_error"
    std::string sentence;  ///< why it was refused, or what the grader's fault was
    double points = 0, maxPoints = 0;
    std::shared_ptr<const Essence> result;  ///< null where there is none
    std::string unstable;                   ///< how repeated gradings differ; empty when they agree
    bool fromBefore = false;  ///< nothing that decides it has changed: not graded again
    bool graderFailed() const { return status == "grader_error"; }
};

/// One that met a fault of the grader's.
inline Standing faultOf(const std::string& entrant, const std::string& sentence) {
    return {entrant, "grader_error", sentence, 0, 0, nullptr, "", false};
}

}  // namespace grader
