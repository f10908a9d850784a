// Each thread has a place of its own, where the work for it is put, and which is empty when it is done.
#include "base/team.hpp"

#include "base/to_size.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

namespace cleft
{

namespace
{

// To put a thread to sleep and to wake it takes some ten microseconds, and the loops of a local search come faster
// than that.
constexpr std::chrono::microseconds kAwake{50};

// True if done() was true soon enough.
template <class Done>
bool is_soon(const Done& done)
{
    const auto end = std::chrono::steady_clock::now() + kAwake;
    do {
        for (int i = 0; i < 64; ++i)
            if (done())
                return true;
    } while (std::chrono::steady_clock::now() < end);
    return false;
}

}  // namespace

class Team::Member
{
public:
    Member(int number, bool waits_awake)
        : number_(number), waits_awake_(waits_awake), thread_([this] { work_until_dismissed(); })
    {
    }
    ~Member()
    {
        put(&none_);
        thread_.join();
    }
    Member(const Member&) = delete;
    Member& operator=(const Member&) = delete;

    void begin(const Work& work) { put(&work); }
    void wait_until_done()
    {
        wait_until([this] { return work_.load(std::memory_order_acquire) == nullptr; });
    }

private:
    void put(const Work* work)
    {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_.store(work, std::memory_order_release);
        }
        changed_.notify_one();
    }

    template <class Done>
    void wait_until(const Done& done)
    {
        if (waits_awake_ && is_soon(done))
            return;
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, done);
    }

    void work_until_dismissed()
    {
        for (;;) {
            wait_until([this] { return work_.load(std::memory_order_acquire) != nullptr; });
            const Work& work = *work_.load(std::memory_order_acquire);
            if (!work)
                return;
            work(number_);
            put(nullptr);
        }
    }

    const int number_;
    const bool waits_awake_;
    const Work none_;  // a thread that finds it ends
    std::mutex mutex_;
    std::condition_variable changed_;
    std::atomic<const Work*> work_{nullptr};
    std::thread thread_;  // begins when all else is there
};

// Where there are more threads than cores, one that waits awake would keep a core from one that works.
Team::Team(int threads) : waits_awake_(threads <= static_cast<int>(std::thread::hardware_concurrency())) {}
Team::~Team() = default;

void Team::dismiss() { members_.clear(); }

void Team::hire(int wanted)
{
    try {
        while (static_cast<int>(members_.size()) < wanted)
            members_.push_back(std::make_unique<Member>(static_cast<int>(members_.size()) + 1, waits_awake_));
    } catch (const std::exception&) {
        // No more threads to be had, or no memory for one: the others do the work.
    }
}

bool Team::run(int count, const Work& work)
{
    if (is_at_work_.exchange(true))
        return false;
    hire(count - 1);
    const int helpers = std::min(count - 1, static_cast<int>(members_.size()));
    for (int i = 0; i < helpers; ++i)
        members_[to_size(i)]->begin(work);
    work(0);
    for (int i = 0; i < helpers; ++i)
        members_[to_size(i)]->wait_until_done();
    is_at_work_ = false;
    return true;
}

}  // namespace cleft
