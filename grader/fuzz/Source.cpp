// A student's file: its TODO regions, and what it may include.

#include "Files.h"
#include "Fuzz.h"
#include "Includes.h"
#include "Regions.h"
#include "Tokens.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzz::textOf(data, size);
    grader::includesOnlyHeaders(text);
    grader::includedNames(text);
    grader::withoutComments(text);
    grader::forEachToken(text, [&](const grader::Token& token) {
        fuzz::require(!token.word.empty() && !token.kind.empty(), "every token says something");
    });
    grader::firstInvalidUtf8(text);
    const std::string outside = grader::outsideRegions(text);
    fuzz::require(outside.size() <= text.size(), "taking out adds nothing");
    for (const auto& [id, body] : grader::regionsOf(text)) {
        const auto same = grader::withRegion(text, id, body);
        fuzz::require(same.has_value(), "a region that is there can be replaced");
        fuzz::require(grader::regionsOf(*same).count(id) == 1, "and is there afterwards");
        fuzz::require(grader::outsideRegions(*same) == outside, "and nothing else has changed");
    }
    return 0;
}
