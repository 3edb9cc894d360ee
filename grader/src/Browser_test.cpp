#include "Browser.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <string>

#include "testing/Tree.h"

namespace {

using namespace grader;

/// A machine whose xdg-open does what a test wants.
class Browsing : public testing::Test {
protected:
    Browsing() : path_(std::getenv("PATH")) {
        setenv("PATH", (programs_.path().string() + ":/usr/bin:/bin").c_str(), 1);
    }
    ~Browsing() override { setenv("PATH", path_.c_str(), 1); }

    void makeXdgOpen(const std::string& body) const {
        const fs::path program = programs_.write("xdg-open", "#!/bin/sh\n" + body + "\n");
        fs::permissions(program, fs::perms(0755));
    }
    std::string file(const std::string& name) const { return (programs_ / name).string(); }

    testing_help::Tree programs_;
    std::string path_;
};

TEST_F(Browsing, ThePageIsHandedOver) {
    makeXdgOpen("echo \"$1\" > '" + file("opened") + "'");
    EXPECT_TRUE(openInBrowser("/some/page.html"));
    EXPECT_EQ(readFile(file("opened")), "/some/page.html\n");
}

TEST_F(Browsing, AFailureIsTold) {
    makeXdgOpen("exit 3");
    EXPECT_FALSE(openInBrowser("/some/page.html"));
}

TEST_F(Browsing, ABrowserThatStaysIsLeftAlone) {
    makeXdgOpen("echo $$ > '" + file("pid") + "'\nexec sleep 60");
    EXPECT_TRUE(openInBrowser("/some/page.html"));
    const pid_t browser = std::stoi(readFile(file("pid")));
    EXPECT_EQ(kill(browser, 0), 0);
    kill(browser, SIGKILL);
}

}  // namespace
