#include "Manifest.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <mutex>
#include <regex>
#include <set>

#include "Fields.h"

namespace grader {

namespace {

constexpr double kDefaultTolerance = 0.0005;
constexpr int kLargestFrame = 3000;  // pixels a side

/// A name from a manifest becomes part of a path: it must stay inside its folder.
std::string plainFileName(const Fields& where, const std::string& name) {
    const fs::path path(name);
    const bool escapes = std::any_of(path.begin(), path.end(), [](const fs::path& part) {
        return part == ".." || part == "." || part.empty();
    });
    if (name.empty() || path.is_absolute() || escapes)
        throw Error("{}: \"{}\" is no file name below the assignment's folder", where.where(),
                    name);
    return name;
}

/// An id is a name of files, folders and regions, too.
std::string plainId(const Fields& where, const std::string& id) {
    static const std::regex plain("[A-Za-z0-9][A-Za-z0-9_-]{0,63}");
    if (!std::regex_match(id, plain))
        throw Error("{}: \"{}\" is no id: expected letters, digits, - and _", where.where(), id);
    return id;
}

Task readTask(Fields fields) {
    Task task;
    task.id = plainId(fields, fields.get<std::string>("id"));
    task.title = fields.get<std::string>("title");
    task.points = fields.get<double>("points");
    task.needs = fields.get<std::vector<std::string>>("needs", {});
    task.hint = fields.get<std::string>("hint", "");
    task.manual = fields.get<bool>("manual", false);
    fields.done();
    if (task.points <= 0)
        throw Error("{}: points must be above 0, found {}", fields.where(), task.points);
    return task;
}

Feature readFeature(Fields fields) {
    Feature feature;
    feature.id = plainId(fields, fields.get<std::string>("id"));
    feature.title = fields.get<std::string>("title");
    feature.points = fields.get<double>("points");
    feature.without = fields.get<std::string>("without");
    fields.done();
    if (feature.points <= 0)
        throw Error("{}: points must be above 0, found {}", fields.where(), feature.points);
    return feature;
}

Frame readFrame(Fields fields) {
    Frame frame;
    frame.id = plainId(fields, fields.get<std::string>("id"));
    frame.title = fields.get<std::string>("title", frame.id);
    frame.task = fields.get<std::string>("task");
    for (const Fields& feature : fields.list("features"))
        frame.points += frame.features.emplace_back(readFeature(feature)).points;
    if (frame.features.empty())
        frame.points = fields.get<double>("points");
    const auto size = fields.get<std::vector<int>>("size");
    frame.tolerance = fields.get<double>("tolerance", kDefaultTolerance);
    const auto why = fields.get<std::string>("why", "");
    fields.done();
    if (size.size() != 2 || std::min(size[0], size[1]) < 1 ||
        std::max(size[0], size[1]) > kLargestFrame)
        throw Error("{}: field \"size\": expected [width, height] in pixels, 1 to {}",
                    fields.where(), kLargestFrame);
    if (frame.points < 0)
        throw Error("{}: points must not be below 0, found {}", fields.where(), frame.points);
    if (frame.tolerance > kDefaultTolerance && why.empty())
        throw Error("{}: a tolerance above {} needs a \"why\"", fields.where(), kDefaultTolerance);
    frame.width = size[0];
    frame.height = size[1];
    return frame;
}

AssignmentLimits readLimits(Fields fields) {
    AssignmentLimits limits;
    limits.buildSeconds = fields.get<int>("build_seconds", limits.buildSeconds);
    limits.callSeconds = fields.get<double>("call_seconds", limits.callSeconds);
    limits.frameSeconds = fields.get<double>("frame_seconds", limits.frameSeconds);
    limits.memoryMib = fields.get<int>("memory_mib", limits.memoryMib);
    limits.outputKib = fields.get<int>("output_kib", limits.outputKib);
    fields.done();
    constexpr int kMostSeconds = 3600, kMostSize = 1 << 20;
    const auto require = [&](const char* name, double value, double most) {
        if (!(value > 0 && value <= most))
            throw Error("{}: field \"{}\": expected a number above 0, at most {}, found {}",
                        fields.where(), name, most, value);
    };
    require("build_seconds", limits.buildSeconds, kMostSeconds);
    require("call_seconds", limits.callSeconds, kMostSeconds);
    require("frame_seconds", limits.frameSeconds, kMostSeconds);
    require("memory_mib", limits.memoryMib, kMostSize);
    require("output_kib", limits.outputKib, kMostSize);
    return limits;
}

std::map<std::string, std::string> readVisibility(Fields& fields) {
    auto all = fields.get<std::map<std::string, std::string>>("visibility", {});
    for (const auto& [check, visibility] : all)
        if (visibility != kVisible && visibility != kAfterDueDate && visibility != kHidden)
            throw Error("{}: field \"visibility\": \"{}\": expected {}, {} or {}, found \"{}\"",
                        fields.where(), check, kVisible, kAfterDueDate, kHidden, visibility);
    return all;
}

/// Ids name suites, pictures and rows of the report.
template <class T>
void requireDistinctIds(const std::vector<T>& all, const char* what, const std::string& file) {
    std::set<std::string> ids;
    for (const T& each : all)
        if (!ids.insert(each.id).second)
            throw Error("{}: two {} have the id \"{}\"", file, what, each.id);
}

/// What one field alone cannot show.
void requireConsistent(const Manifest& manifest, const std::string& file) {
    requireDistinctIds(manifest.tasks, "tasks", file);
    requireDistinctIds(manifest.frames, "frames", file);
    double sum = 0;
    for (const Task& task : manifest.tasks) {
        sum += task.points;
        if (manifest.framePoints(task.id) > task.points)
            throw Error("{}: the frames of task \"{}\" have more points than the task", file,
                        task.id);
        if (task.manual && manifest.framePoints(task.id) > 0)
            throw Error("{}: task \"{}\" is manual: its frames are looked at, and have 0 points",
                        file, task.id);
    }
    if (std::abs(sum - 100.0) > 1e-6)
        throw Error("{}: the points of all tasks must add up to 100, found {}", file, sum);
    for (const Frame& frame : manifest.frames) {
        requireDistinctIds(frame.features, "features", file + ": frame \"" + frame.id + "\"");
        if (!manifest.task(frame.task))
            throw Error("{}: frame \"{}\" names the unknown task \"{}\"", file, frame.id,
                        frame.task);
    }
    if (manifest.id != manifest.folder.filename())
        throw Error("{}: field \"id\": expected the folder's name \"{}\", found \"{}\"", file,
                    manifest.folder.filename().string(), manifest.id);
}

/// The id that a manifest has, or the folder's name where it is broken: who loads it is told why.
std::string idIn(const fs::path& folder) {
    try {
        return parseJsonFile((folder / "assignment.json").string()).at("id");
    } catch (const std::exception&) {
        return folder.filename().string();
    }
}

/// The folders below `root`/assignments that have a manifest, by name, and the id in it.
std::map<std::string, std::string> idsByFolder(const fs::path& root) {
    std::map<std::string, std::string> ids;
    for (const auto& entry : fs::directory_iterator(root / "assignments"))
        if (fs::exists(entry.path() / "assignment.json"))
            ids[entry.path().filename().string()] = idIn(entry.path());
    return ids;
}

}  // namespace

Json parseJson(const std::string& text, const std::string& path) {
    try {
        return Json::parse(text);
    } catch (const nlohmann::json::exception& error) {  // a number may be too large, too
        throw Error("{}: not JSON: {}", path, error.what());
    }
}

Json parseJsonFile(const std::string& path) {
    return parseJson(readFile(path), path);
}

std::string Task::suite() const {
    std::string name;
    bool upper = true;
    for (const char each : id) {
        if (each == '-')
            upper = true;
        else {
            name +=
                upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(each))) : each;
            upper = false;
        }
    }
    return name;
}

const Task* Manifest::task(const std::string& taskId) const {
    for (const Task& each : tasks)
        if (each.id == taskId)
            return &each;
    return nullptr;
}

double Manifest::framePoints(const std::string& taskId) const {
    double sum = 0;
    for (const Frame& frame : frames)
        sum += frame.task == taskId ? frame.points : 0;
    return sum;
}

std::string Manifest::visibilityOf(const std::string& checkId) const {
    const auto at = visibility.find(checkId);
    return at == visibility.end() ? kVisible : at->second;
}

std::vector<Task> Manifest::automaticTasks() const {
    std::vector<Task> automatic;
    std::copy_if(tasks.begin(), tasks.end(), std::back_inserter(automatic),
                 [](const Task& each) { return !each.manual; });
    return automatic;
}

Manifest Manifest::load(const fs::path& folder) {
    return parse(readFile(folder / "assignment.json"), folder);
}

Manifest Manifest::parse(const std::string& text, const fs::path& folder) {
    const std::string file = (folder / "assignment.json").string();
    const Json json = parseJson(text, file);
    Fields fields(json, file);
    if (const int format = fields.get<int>("format"); format != kFormat)
        throw Error("{}: field \"format\": expected {}, found {}: this grader reads no other", file,
                    kFormat, format);
    Manifest manifest;
    manifest.folder = folder;
    manifest.id = plainId(fields, fields.get<std::string>("id"));
    manifest.title = fields.get<std::string>("title");
    manifest.chapter = fields.get<int>("chapter");
    manifest.summary = fields.get<std::string>("summary");
    for (const auto& name : fields.get<std::vector<std::string>>("submit"))
        manifest.submit.push_back(plainFileName(fields, name));
    for (const auto& [name, from] : fields.get<std::map<std::string, std::string>>("inherits", {}))
        manifest.inherits[plainFileName(fields, name)] = plainId(fields, from);
    manifest.limits = readLimits(fields.object("limits"));
    for (const Fields& task : fields.list("tasks"))
        manifest.tasks.push_back(readTask(task));
    for (const Fields& frame : fields.list("frames"))
        manifest.frames.push_back(readFrame(frame));
    manifest.starterPasses = fields.get<std::vector<std::string>>("starter_passes", {});
    manifest.visibility = readVisibility(fields);
    fields.done();
    requireConsistent(manifest, file);
    return manifest;
}

std::vector<std::string> knownAssignments(const fs::path& root) {
    static std::mutex mutex;
    static std::set<std::string> said;
    std::vector<std::string> ids;
    for (const auto& [folder, id] : idsByFolder(root)) {
        if (folder == id) {
            ids.push_back(id);
            continue;
        }
        const std::scoped_lock lock(mutex);
        if (said.insert(folder).second)
            std::cerr << fmt::format(
                "assignments/{} is a copy of {}, left out: its assignment.json has that id\n",
                folder, id);
    }
    if (ids.empty())
        throw Error("{} holds no assignment: expected folders with an assignment.json",
                    (root / "assignments").string());
    return ids;
}

Manifest loadAssignment(const fs::path& root, const std::string& id) {
    if (!idsByFolder(root).contains(id))
        throw Error("there is no assignment \"{}\"; known are {}", id,
                    fmt::join(knownAssignments(root), ", "));
    return Manifest::load(root / "assignments" / id);
}

}  // namespace grader
