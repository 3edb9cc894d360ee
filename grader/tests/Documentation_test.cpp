// Every command in the documentation is tried, and every link leads somewhere. Commands run in a
// copy of the checkout; documentation.json says what stands for the names in them, and which ones
// are not run, and why.

#include "Documentation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using namespace lab;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DocumentationTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        copy_ = std::make_unique<CourseCopy>();
        documentation_ = std::make_unique<Documentation>(*copy_);
    }
    static void TearDownTestSuite() {
        documentation_.reset();
        copy_.reset();
    }

    static std::unique_ptr<CourseCopy> copy_;
    static std::unique_ptr<Documentation> documentation_;
};
std::unique_ptr<CourseCopy> DocumentationTest::copy_;
std::unique_ptr<Documentation> DocumentationTest::documentation_;

TEST_F(DocumentationTest, KeepsItsPromises) {
    const auto pages = pagesOf(copy_->root());
    ASSERT_THAT(pages, testing::IsSupersetOf({"README.md", "docs/batch.md", "CONTRIBUTING.md",
                                              "assignments/06-rotation/README.md"}));
    std::size_t commands = 0;
    for (const std::string& page : pages) {
        const std::string text = readFile(copy_->root() / page);
        commands += commandsIn(text).size();
        for (const std::string& finding : documentation_->tryCommands(page, text))
            ADD_FAILURE() << finding;
        for (const std::string& finding : documentation_->tryLinks(page, text))
            ADD_FAILURE() << finding;
    }
    EXPECT_GT(commands, 50u);
    EXPECT_THAT(documentation_->unusedEntries(), IsEmpty()) << "take them out of "
                                                               "documentation.json";
}

TEST_F(DocumentationTest, FindsWhatIsWrong) {
    const auto found = documentation_->tryCommands("page.md",
                                                   "```\n"
                                                   "./grade 06-rotation\n"
                                                   "./grade 05-nothing\n"
                                                   "./grade sing\n"
                                                   "./grade compare A B\n"
                                                   "make\n"
                                                   "cd nowhere\n"
                                                   "./grade window 06-rotation\n"
                                                   "./grade check-course --loud\n"
                                                   "ninja -C build/release no_such_target\n"
                                                   "```\n"
                                                   "Say `./grade export --sideways …`,\n"
                                                   "`./grade batch`, `./grade batch --upwards`,\n"
                                                   "`ctest -R workflows`.\n");
    EXPECT_THAT(found,
                ElementsAre(HasSubstr("page.md:3: ./grade 05-nothing\n    ended with exit code 2"),
                            HasSubstr("page.md:4:"), HasSubstr("page.md:5:"),
                            HasSubstr("page.md:6: make\n    nothing tries this"),
                            HasSubstr("page.md:7: cd nowhere\n    there is no such folder"),
                            HasSubstr("page.md:9:"), HasSubstr("there is no target no_such_target"),
                            HasSubstr("does not know --sideways"),
                            HasSubstr("page.md:13: ./grade batch --upwards"),
                            HasSubstr("page.md:14: ctest -R workflows\n    nothing tries this")));
    EXPECT_THAT(
        documentation_->tryLinks("docs/page.md",
                                 "[a](../README.md) [b](none.md) [c](batch.md#what-it-takes)"
                                 " [d](batch.md#nothing)\n"),
        ElementsAre("docs/page.md:1: none.md: there is no such file",
                    HasSubstr("batch.md#nothing: no heading there")));
}

}  // namespace
