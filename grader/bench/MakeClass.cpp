// Makes a class to grade: submissions of one assignment from its solution, variants, starter and
// known mistakes, each edited a little at random, so that no two are the same text, and no two
// sources the same program. Of four headers three differ by comments alone. The same number gives
// the same class everywhere.
//
//     class_maker ASSIGNMENT COUNT SEED OUT [--canvas]
//
// With --canvas, as Canvas exports them: all files in one folder, named by student.

#include <fmt/format.h>

#include <algorithm>

#include <iostream>
#include <random>

#include "Error.h"
#include "Manifest.h"
#include "Mistakes.h"
#include "Regions.h"

namespace {

using namespace grader;
using Files = std::map<std::string, std::string>;  // name → text

class Maker {
public:
    Maker(const fs::path& root, const std::string& id, std::uint32_t seed)
        : manifest_(loadAssignment(root, id)),
          solution_(root / "solutions" / id),
          variants_(variantsOf(solution_)),
          random_(seed) {
        for (Mistake& each : readMistakes(solution_))
            if (submitted(each.file))
                mistakes_.push_back(std::move(each));
        std::erase_if(variants_,
                      [](const fs::path& each) { return fs::exists(each / "loses.json"); });
    }

    /// Of ten students one hands in the starter, two the solution, two a variant, and the others
    /// have one, two or three mistakes.
    Files next(std::size_t number) {
        const unsigned kind = below(10);
        Files files = kind == 0 ? filesIn(manifest_.folder) : filesIn(solution_);
        if (kind >= 3 && kind < 5)
            for (const auto& [name, text] : filesIn(variants_[below(variants_.size())]))
                files[name] = text;
        if (kind >= 5)
            for (unsigned i = 0; i < 1 + below(3); ++i) {
                const Mistake& mistake = mistakes_[below(mistakes_.size())];
                files[mistake.file] =
                    withRegion(files[mistake.file], mistake.region, mistake.body).value();
            }
        for (auto& [name, text] : files)
            text = edited(name, text, number);
        return files;
    }

private:
    /// std::uniform_int_distribution differs between libraries.
    unsigned below(std::size_t count) { return static_cast<unsigned>(random_() % count); }

    bool submitted(const std::string& name) const {
        return std::find(manifest_.submit.begin(), manifest_.submit.end(), name) !=
               manifest_.submit.end();
    }

    Files filesIn(const fs::path& folder) const {
        Files files;
        for (const std::string& name : manifest_.submit)
            if (fs::exists(folder / name))
                files[name] = readFile(folder / name);
        return files;
    }

    /// Comments behind a line in twenty that ends a statement, another one on top, and below a
    /// constant that nobody needs.
    std::string edited(const std::string& name, const std::string& text, std::size_t number) {
        std::string result = fmt::format("// submission {}\n", number);
        if (text.starts_with("#version"))
            result.clear();
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
            std::string line = text.substr(at, end - at);
            if (line.ends_with(";\n") && below(20) == 0)
                line.insert(line.size() - 1,
                            fmt::format("  // step {} of {}", below(1000), number));
            result += line;
            at = end;
        }
        if (name.ends_with(".cpp"))
            result += fmt::format("[[maybe_unused]] static const int attempt = {};\n", number);
        else if (name.ends_with(".h") && below(4) == 0)
            result += fmt::format("inline constexpr int version = {};\n", number);
        else if (text.starts_with("#version"))
            result += fmt::format("const int attempt = {};\n", number);
        return result;
    }

    Manifest manifest_;
    fs::path solution_;
    std::vector<Mistake> mistakes_;
    std::vector<fs::path> variants_;
    std::mt19937 random_;
};

int make(int argc, char** argv) {
    const bool canvas = argc == 6 && std::string(argv[5]) == "--canvas";
    if (argc != 5 && !canvas)
        throw Error("usage: class_maker ASSIGNMENT COUNT SEED OUT [--canvas]");
    Maker maker(COURSE_ROOT, argv[1], static_cast<std::uint32_t>(std::stoul(argv[3])));
    const fs::path out = argv[4];
    const auto count = std::stoul(argv[2]);
    for (std::size_t k = 1; k <= count; ++k)
        for (const auto& [name, text] : maker.next(k)) {
            const std::string student = fmt::format("student{:03}", k);
            writeFile(canvas ? out / fmt::format("{}_{}_{}_{}", student, 1000 + k, 50000 + k,
                                                 fs::path(name).filename().string())
                             : out / student / argv[1] / name,
                      text);
        }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return make(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "class_maker: " << error.what() << "\n";
        return 2;
    }
}
