// Threads that share the loops of one call of the library.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace cleft
{

// Its threads wait for the next loop between two: to make a thread takes as long as many a loop. They end with it, so
// that none is left where a program forks between two calls.
class Team
{
public:
    using Work = std::function<void(int worker)>;  // throws nothing

    // `threads`: how many there are to be in all, with the calling one.
    explicit Team(int threads);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    // work(0) on the calling thread, and work(1) to work(count - 1) on others, as far as they can be had. Returns when
    // all are done. False, and nothing is done, if it is at work already: in a loop within a loop.
    bool run(int count, const Work& work);
    // Ends the threads. The next loop makes them anew.
    void dismiss();

private:
    class Member;
    // As many as are wanted, or fewer.
    void hire(int wanted);

    const bool waits_awake_;
    std::vector<std::unique_ptr<Member>> members_;
    std::atomic<bool> is_at_work_{false};
};

}  // namespace cleft
