#include "batch/Crew.h"

#include <chrono>
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

/// Who works at what. Threads share it, because one that is left behind outlives the crew.
struct Shift {
    struct Worker {
        std::thread thread;
        std::size_t piece = 0;
        Clock::time_point began;
        bool ended = false, leftBehind = false;
    };

    std::mutex mutex;
    std::condition_variable changed;
    std::size_t next = 0;
    std::list<Worker> workers;
    Crew::Done done;
};

}  // namespace

Crew::Done Crew::run(std::size_t count, const std::function<Standing(std::size_t)>& work,
                     const std::function<Standing(std::size_t)>& lost,
                     const std::atomic<bool>& stop,
                     const std::function<void(const Standing&)>& tell) const {
    const auto shift = std::make_shared<Shift>();
    shift->done.standings.resize(count);
    const auto settle = [&tell](Shift& all, std::size_t piece, Standing standing) {
        tell(standing);
        all.done.standings[piece] = std::move(standing);
    };
    const auto labour = [shift, count, work, &stop, settle](Shift::Worker& self) {
        std::unique_lock lock(shift->mutex);
        while (!self.leftBehind && shift->next < count && !stop) {
            const std::size_t piece = self.piece = shift->next++;
            self.began = Clock::now();
            lock.unlock();
            Standing standing = work(piece);
            lock.lock();
            if (!self.leftBehind)
                settle(*shift, piece, std::move(standing));
        }
        self.ended = true;
        shift->changed.notify_all();
    };
    const auto hire = [&] {
        Shift::Worker& worker = shift->workers.emplace_back();
        worker.began = Clock::now();
        try {
            worker.thread = std::thread(labour, std::ref(worker));
        } catch (const std::system_error&) {  // the machine gives no more threads
            shift->workers.pop_back();
            if (shift->workers.empty())
                throw;
        }
    };

    std::unique_lock lock(shift->mutex);
    for (int i = 0; i < workers; ++i)
        hire();
    const auto patience =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patienceSeconds));
    for (;;) {
        auto soonest = Clock::time_point::max();
        std::size_t leaving = 0;
        for (Shift::Worker& each : shift->workers) {
            if (each.ended || each.leftBehind)
                continue;
            if (Clock::now() < each.began + patience) {
                soonest = std::min(soonest, each.began + patience);
                continue;
            }
            each.leftBehind = shift->done.someoneWasLeftBehind = true;
            each.thread.detach();
            settle(*shift, each.piece, lost(each.piece));
            ++leaving;
        }
        for (; leaving > 0; --leaving, soonest = Clock::now())
            hire();
        if (soonest == Clock::time_point::max())
            break;
        shift->changed.wait_until(lock, soonest);
    }
    lock.unlock();
    for (Shift::Worker& each : shift->workers)
        if (!each.leftBehind)
            each.thread.join();
    return std::move(shift->done);
}

}  // namespace grader
