#pragma once

#include <optional>

#include "recognise/Signatures.h"

namespace grader {

/// The mistake that explains what a task lost; nothing when none does.
///
/// `checks` are those of one task. A known mistake explains them when every answer that the
/// student's code gave agrees with the mistake's, and at least one of them does not with the right
/// one; for a task that lost in frames only, when every lost frame is much nearer to the mistake's
/// than to the reference. Several that explain them equally are told together, or what they have in
/// common where their entries say it. Where none does, the usual slips are tried on the right
/// answers (UsualSlips.h).
std::optional<Recognised> recognise(const Signatures& signatures, const std::string& task,
                                    const std::vector<CheckResult>& checks);

}  // namespace grader
