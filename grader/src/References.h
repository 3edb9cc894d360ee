#pragma once

#include <map>
#include <string>
#include <vector>

#include "Manifest.h"
#include "Toolchain.h"
#include "compare/FrameScore.h"
#include "compare/Picture.h"
#include "recognise/Signatures.h"

namespace grader {

class Grader;

/// Seed 1 is published: its references and signatures are stored, so that a student's copy needs no
/// solutions.
inline constexpr std::uint64_t kPublishedSeed = 1;

/// Whether references can be drawn, for a seed that is not published: the solution is here, with
/// its mistakes. Students may have some solutions; those are without.
bool canDrawReferences(const fs::path& root, const std::string& assignment);

/// What a frame is compared with: in reference_images/NN-name/, FRAME.png is the solution's,
/// FRAME.starter.png the starter's, and FRAME.FEATURE.png the solution's with the mistake that
/// lacks the feature.
using Pictures = std::map<std::string, Picture>;  // by file name

std::string referenceName(const Frame& frame);
std::string starterName(const Frame& frame);
std::string ablatedName(const Frame& frame, const Feature& feature);

std::vector<std::string> referenceNames(const Manifest& manifest);

fs::path referenceFolder(const Toolchain& tools, const std::string& assignment);
fs::path signaturesFile(const Toolchain& tools, const std::string& assignment);

/// The stored pictures. Throws Error with the command that mends it when one is missing or has
/// another size than its frame.
Pictures loadReferences(const Toolchain& tools, const Manifest& manifest);

/// The same, drawn now. Throws Error without solutions/, or when one cannot be drawn.
Pictures drawReferences(const Grader& grader, const Manifest& manifest, std::uint64_t seed);

using FrameRules = std::map<std::string, FrameRule>;  // by frame

/// What frames are scored by. Moves the pictures.
FrameRules rulesOf(const Manifest& manifest, Pictures pictures);

/// Signatures of all mistakes, by grading each of them with the published seed.
Signatures makeSignatures(const Grader& grader, const Manifest& manifest);

}  // namespace grader
