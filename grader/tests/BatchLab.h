#pragma once

#include "Lab.h"

namespace lab {

inline const std::string kRotation = "06-rotation/rotation.cpp";

/// A class of four, graded by `./grade batch`: one has full marks, one half of them, one does not
/// compile, and one is an archive that is none.
class BatchTest : public testing::Test {
protected:
    BatchTest() {
        fs::create_directories(home());
        put("honest", Submission());
        Submission half;
        half.solve(kRotation, "cross-matrix", "    return glm::mat3(0.0f);\n");
        put("half", half);
        Submission broken;
        broken.write(kRotation, "this is no C++\n");
        put("broken", broken);
        writeFile(home() / "text.zip", "my homework");
        writeFile(home() / "list.txt", "alpha, beta");
    }

    fs::path home() const { return work_.path() / "submissions"; }
    fs::path out() const { return work_.path() / "out"; }
    void put(const std::string& name, const Submission& submission) const {
        fs::create_directories(home() / name);
        fs::copy(submission.folder() / "06-rotation", home() / name / "06-rotation",
                 fs::copy_options::recursive);
    }
    Graded batch(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments = {"batch",       home().string(), "--assignment",
                                              "06-rotation", "--out",         out().string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runGrader(arguments);
    }
    Json students() const {
        return parseJsonFile((out() / "results.json").string()).at("students");
    }
    Json student(const std::string& name) const {
        for (const Json& each : students())
            if (each.at("student") == name)
                return each;
        return nullptr;
    }

    WorkFolder work_;
};

}  // namespace lab
