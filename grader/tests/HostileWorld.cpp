#include <sys/ipc.h>
#include <sys/sem.h>
#include <sys/shm.h>

#include <cstdlib>
#include <random>
#include <sstream>

#include "Error.h"
#include "HostileCase.h"
#include "Regions.h"

namespace hostile {

namespace {

using grader::Error;

std::string randomWord(const std::string& prefix) {
    std::random_device device;
    return prefix + fmt::format("{:08x}{:08x}", device(), device());
}

/// The lines of all hidden tests that could stand nowhere else.
std::vector<std::string> linesOfHiddenTests() {
    constexpr std::size_t kLong = 40;
    std::vector<std::string> lines;
    for (const auto& entry : fs::recursive_directory_iterator(lab::root() / "solutions")) {
        if (entry.path().parent_path().filename() != "hidden_tests" || !entry.is_regular_file())
            continue;
        std::istringstream file(grader::readFile(entry.path()));
        for (std::string line; std::getline(file, line);) {
            line.erase(0, line.find_first_not_of(' '));
            if (line.size() >= kLong && !line.starts_with("//"))
                lines.push_back(line);
        }
    }
    if (lines.empty())
        throw Error("{} has no hidden test", (lab::root() / "solutions").string());
    return lines;
}

/// "body.cpp" in place of the region of a .cpp file or header, "body.frag" of a shader.
std::string partOf(const Case& attack, const std::string& part) {
    const std::string ending = attack.file.ends_with(".frag") ? ".frag" : ".cpp";
    const fs::path file = attack.folder / (part + ending);
    return fs::exists(file) ? grader::readFile(file) : "";
}

/// The archive that an attack has in its folder or has made; empty where there is none.
fs::path archiveIn(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("archive."))
            return entry.path();
    return {};
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Folders that a submission could reach where nothing holds it, which outlive its grading.
std::vector<fs::path> foldersOfOthers() {
    std::vector<fs::path> folders = {"/tmp",
                                     "/var/tmp",
                                     "/dev/shm",
                                     "/dev/mqueue",
                                     "/run",
                                     "/usr/lib",
                                     lab::root(),
                                     lab::root() / "build/release/cache",
                                     fs::current_path(),
                                     fs::current_path().parent_path()};
    // Of other gradings, and of one that was not cleared away.
    for (const fs::path& each : grader::entriesOf(fs::temp_directory_path()))
        if (each.filename().string().starts_with("course-"))
            folders.insert(folders.end(), {each, each / "stage", each / "out"});
    return folders;
}

}  // namespace

std::string leftBy(const Case& attack) {
    return "left-behind-by-" + attack.name;
}

World::World(bool plain) : plain_(plain) {
    secrets_ = {randomWord("secret_beside_"), randomWord("secret_of_the_neighbour_"),
                randomWord("secret_of_the_environment_")};
    const auto hidden = linesOfHiddenTests();
    secrets_.insert(secrets_.end(), hidden.begin(), hidden.end());
    // A sandbox hides what everybody may read; a plain process can only be another user.
    fs::permissions(folder(), fs::perms(plain ? 0700 : 0755));
    grader::writeFile(folder() / "secret.txt", secrets_[0] + "\n");
    grader::writeFile(githubEnv(), "");
    const std::string file = "06-rotation/rotation.cpp";
    grader::writeFile(folder() / "neighbour" / file,
                      "// " + secrets_[1] + "\n#error " + secrets_[1] + "\n" + honest_.read(file));
    const fs::path mistake = lab::root() / "solutions" / kHalfRight / "mistakes/euler-degrees.cpp";
    halfRight_.solve(file, "euler-rodrigues", grader::readFile(mistake));
    setenv("TOKEN_OF_THE_GRADER", secrets_[2].c_str(), 1);
    setenv("GITHUB_ENV", githubEnv().c_str(), 1);
}

std::vector<std::string> World::tracesOf(const Case& attack) const {
    std::vector<std::string> traces;
    const std::set<std::string> ours = {"secret.txt", "neighbour", "github.env"};
    for (const auto& entry : fs::directory_iterator(folder()))
        if (!ours.contains(entry.path().filename().string()))
            traces.push_back(entry.path().string());
    if (grader::readFile(folder() / "secret.txt") != secrets_[0] + "\n")
        traces.push_back("the secret file is another one");
    if (!grader::readFile(githubEnv()).empty())
        traces.push_back("$GITHUB_ENV has lines");
    for (const fs::path& each : foldersOfOthers())
        for (const std::string& name : {leftBy(attack), std::string("left-behind")})
            if (grader::typeOf(each / name) != fs::file_type::not_found &&
                grader::typeOf(each / name) != fs::file_type::none)
                traces.push_back((each / name).string());
    constexpr key_t kKey = 0x41414141;
    if (shmget(kKey, 0, 0) >= 0 || semget(kKey, 0, 0) >= 0)
        traces.push_back("memory or a semaphore that all processes share");
    return traces;
}

std::string World::filled(std::string text, const Case& attack) const {
    replaceAll(text, "@ROOT@", lab::root().string());
    replaceAll(text, "@SECRET@", (folder() / "secret.txt").string());
    replaceAll(text, "@SIBLING@", (folder() / "neighbour").string());
    replaceAll(text, "@GITHUB_ENV@", githubEnv().string());
    replaceAll(text, "@LEFT@", leftBy(attack));
    return text;
}

fs::path World::prepare(const Case& attack, const fs::path& target) const {
    fs::create_directories(target);
    fs::copy(honest() / attack.assignment, target / attack.assignment, fs::copy_options::recursive);
    const auto part = [&](const char* name) { return filled(partOf(attack, name), attack); };
    if (!attack.file.empty()) {
        const fs::path file = target / attack.assignment / attack.file;
        std::string text = grader::readFile(file);
        if (!attack.region.empty()) {
            const auto put = grader::withRegion(text, attack.region, part("body"));
            if (!put)
                throw Error("{}: {} has no region \"{}\"", attack.folder.string(), attack.file,
                            attack.region);
            text = *put;
        }
        grader::writeFile(file, part("top") + text);
    }
    if (const fs::path script = attack.folder / "make.sh"; fs::exists(script)) {
        const auto made =
            grader::run({"bash", "-ec", "cd \"$0\"\n" + filled(grader::readFile(script), attack),
                         target.string()},
                        30.0);
        if (!made.succeeded())
            throw Error("{} failed: {}", script.string(), made.output);
    }
    for (const fs::path& folder : {target, attack.folder})
        if (const auto archive = archiveIn(folder); !archive.empty())
            return archive;
    return target;
}

}  // namespace hostile
