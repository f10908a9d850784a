// Counts go first, and carry the marks of those that have failed.
#include "parts/exchange.hpp"

#include "base/status_of.hpp"

#include <algorithm>
#include <cstring>

namespace cleft
{

namespace
{

// In the place of a count, which is never negative.
constexpr int64_t kFailed = -1;

}  // namespace

Exchange::Exchange(Messenger messenger)
    : messenger_(std::move(messenger)),
      marks_(to_size(ranks()), 0),
      heard_(to_size(ranks()), 0),
      sizes_of_failures_(to_size(ranks()), int64_t{sizeof(Failure)}),
      said_(to_size(ranks())),
      told_(to_size(ranks())),
      send_sizes_(to_size(ranks())),
      receive_sizes_(to_size(ranks()))
{
}

Exchange Exchange::alone()
{
    const auto numbers = [](const int64_t* send, int64_t* receive) {
        *receive = *send;
        return true;
    };
    const auto bytes = [](const void* send, const int64_t* send_size, void* receive, const int64_t*) {
        if (*send_size > 0)
            std::memcpy(receive, send, to_size(*send_size));
        return true;
    };
    return Exchange({0, 1, "", numbers, bytes});
}

void Exchange::together(const std::function<void()>& body)
{
    Failure own{CLEFT_OK, ""};
    status_of(
        [&] {
            body();
            agree();
        },
        [&](cleft_status status, const char* sentence) noexcept {
            own.status = status;
            std::strncpy(own.sentence, sentence, sizeof own.sentence - 1);
            return status;
        });
    if (own.status == CLEFT_OK)
        return;
    if (is_broken_)
        throw Error(own.status, own.sentence);
    // Who only heard of a failure has none of its own.
    if (heard_failure_)
        own = {CLEFT_OK, ""};
    else
        marks_.assign(marks_.size(), kFailed);
    if (!heard_failure_)
        numbers(marks_.data(), heard_.data());
    throw_first_failure(own);
}

void Exchange::throw_first_failure(const Failure& own)
{
    std::fill(said_.begin(), said_.end(), own);
    if (!messenger_.bytes(said_.data(), sizes_of_failures_.data(), told_.data(), sizes_of_failures_.data()))
        throw Error(CLEFT_ERROR_EXCHANGE, "a rank failed, and the ranks cannot reach each other");
    // What all say in the same words is no matter of one rank.
    const bool is_common = std::all_of(told_.begin(), told_.end(), [&](const Failure& f) {
        return f.status == told_[0].status && std::strcmp(f.sentence, told_[0].sentence) == 0;
    });
    for (int32_t r = 0; r < ranks(); ++r)
        if (told_[r].status != CLEFT_OK)
            throw Error(told_[r].status, (is_common ? "" : "rank " + std::to_string(r) + ": ") + told_[r].sentence);
    throw Error(CLEFT_ERROR_EXCHANGE, "the messages between ranks are not what they sent");
}

void Exchange::agree() { received_counts(Array<int64_t>(to_size(ranks()), 0)); }

Array<int64_t> Exchange::received_counts(const Array<int64_t>& counts)
{
    Array<int64_t> received(to_size(ranks()));
    numbers(counts.data(), received.data());
    if (std::any_of(received.begin(), received.end(), [](int64_t count) { return count < 0; })) {
        heard_failure_ = true;
        throw Error(CLEFT_ERROR_EXCHANGE, "another rank failed");
    }
    return received;
}

Array<int64_t> Exchange::starts_of(const Array<int64_t>& counts)
{
    Array<int64_t> start(counts.size() + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), start.begin() + 1);
    return start;
}

void Exchange::set_sizes(const Array<int64_t>& counts, const Array<int64_t>& start, int64_t item)
{
    for (size_t r = 0; r < counts.size(); ++r) {
        send_sizes_[r] = item * counts[r];
        receive_sizes_[r] = item * (start[r + 1] - start[r]);
    }
}

void Exchange::send_bytes(const void* send, void* receive)
{
    if (messenger_.bytes(send, send_sizes_.data(), receive, receive_sizes_.data()))
        return;
    is_broken_ = true;
    throw Error(CLEFT_ERROR_EXCHANGE, "the ranks cannot reach each other");
}

void Exchange::numbers(const int64_t* send, int64_t* receive)
{
    if (messenger_.numbers(send, receive))
        return;
    is_broken_ = true;
    throw Error(CLEFT_ERROR_EXCHANGE, "the ranks cannot reach each other");
}

}  // namespace cleft
