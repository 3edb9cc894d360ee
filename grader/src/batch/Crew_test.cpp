#include "batch/Crew.h"

#include <gmock/gmock.h>

#include <chrono>
#include <future>
#include <set>
#include <thread>

namespace {

using namespace grader;
using testing::ElementsAre;

const std::atomic<bool> kOn = false;

Standing done(std::size_t piece) {
    Standing standing;
    standing.entrant = std::to_string(piece);
    standing.status = "graded";
    return standing;
}

Standing lost(std::size_t piece) {
    return faultOf(std::to_string(piece), "lost");
}

void tellNobody(const Standing&) {}

std::vector<std::string> statusesOf(const Crew::Done& all) {
    std::vector<std::string> statuses;
    for (const auto& each : all.standings)
        statuses.push_back(each ? each->entrant + " " + each->status : "none");
    return statuses;
}

TEST(Crew, DoesEachOnceAndTellsOfIt) {
    std::multiset<std::string> told;
    const auto all = Crew{3, 100}.run(20, done, lost, kOn,
                                      [&](const Standing& each) { told.insert(each.entrant); });
    EXPECT_FALSE(all.someoneWasLeftBehind);
    EXPECT_EQ(told.size(), 20u);
    EXPECT_EQ(std::set(told.begin(), told.end()).size(), 20u);
    EXPECT_EQ(statusesOf(all).at(19), "19 graded");
    EXPECT_TRUE((Crew{2, 100}.run(0, done, lost, kOn, tellNobody).standings.empty()));
}

TEST(Crew, BeginsNothingOnceItIsToStop) {
    std::atomic<bool> stop = false;
    const auto all = Crew{1, 100}.run(
        4,
        [&](std::size_t piece) {
            stop = piece == 1;
            return done(piece);
        },
        lost, stop, tellNobody);
    EXPECT_THAT(statusesOf(all), ElementsAre("0 graded", "1 graded", "none", "none"));
}

TEST(Crew, LeavesBehindWhatHangsAndDoesTheRest) {
    std::promise<void> release, released;
    const std::shared_future<void> wait = release.get_future().share();
    const auto work = [&](std::size_t piece) {
        if (piece == 1) {
            wait.wait();
            released.set_value();
        }
        return done(piece);
    };
    std::vector<std::string> told;
    const auto begun = std::chrono::steady_clock::now();
    const auto all = Crew{1, 3}.run(3, work, lost, kOn,
                                    [&](const Standing& each) { told.push_back(each.entrant); });
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
    EXPECT_TRUE(all.someoneWasLeftBehind);
    EXPECT_THAT(statusesOf(all), ElementsAre("0 graded", "1 grader_error", "2 graded"));
    release.set_value();
    released.get_future().wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_THAT(told, ElementsAre("0", "1", "2")) << "who comes back later is not heard";
}

}  // namespace
