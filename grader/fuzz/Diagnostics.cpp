// What a compiler says about a stranger's file, and what is shown of it.

#include "Diagnostics.h"

#include "Files.h"
#include "Fuzz.h"
#include "report/PlainText.h"

namespace {

void mustBeHarmless(const std::string& text) {
    const std::string shown = grader::harmless(text);
    fuzz::require(grader::firstInvalidUtf8(shown) == std::string::npos, "shown text is UTF-8");
    for (const char c : shown)
        fuzz::require(static_cast<unsigned char>(c) >= 32 && c != 127, "no control character");
    fuzz::require(grader::harmless(shown) == shown, "harmless text stays as it is");
    fuzz::require(grader::columns(grader::shortened(shown, 20)) <= 20, "short text is short");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzz::textOf(data, size);
    for (const grader::Diagnostic& each : grader::parseDiagnostics(text)) {
        fuzz::require(each.severity == "error" || each.severity == "warning", "a known severity");
        fuzz::require(each.file.find("/tmp/") != 0, "no folder of the build");
        mustBeHarmless(each.message);
        grader::placeOf(each);
        grader::hintFor(each);
        grader::sourceLine(text, each.line);
    }
    mustBeHarmless(text);
    mustBeHarmless(grader::withoutFolders(text));
    return 0;
}
