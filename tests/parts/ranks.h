/* Ranks as threads of one process: an exchange through shared memory, and a run of the same function on each rank. */
#ifndef CLEFT_TESTS_PARTS_RANKS_H
#define CLEFT_TESTS_PARTS_RANKS_H

#include "cleft/cleft_parts.h"

#include <pthread.h>
#include <string.h>

enum { MOST_RANKS = 16 };

typedef struct {
    int32_t count;
    pthread_barrier_t barrier;
    const int64_t* numbers[MOST_RANKS];
    const char* bytes[MOST_RANKS];
    const int64_t* sizes[MOST_RANKS];
    int64_t messages, sent; /* between different ranks, and their bytes */
} ranks_shared;

typedef struct {
    ranks_shared* shared;
    int32_t rank;
    cleft_exchange exchange;
    void* user;
    pthread_t thread;
    void (*body)(const cleft_exchange* exchange, void* user);
} ranks_one;

static int ranks_numbers(const int64_t* send, int64_t* receive, void* user)
{
    const ranks_one* one = (const ranks_one*)user;
    ranks_shared* shared = one->shared;
    shared->numbers[one->rank] = send;
    pthread_barrier_wait(&shared->barrier);
    for (int32_t r = 0; r < shared->count; ++r)
        receive[r] = shared->numbers[r][one->rank];
    pthread_barrier_wait(&shared->barrier);
    return 0;
}

static int ranks_bytes(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes,
                       void* user)
{
    const ranks_one* one = (const ranks_one*)user;
    ranks_shared* shared = one->shared;
    char* out = (char*)receive;
    shared->bytes[one->rank] = (const char*)send;
    shared->sizes[one->rank] = send_sizes;
    pthread_barrier_wait(&shared->barrier);
    for (int32_t r = 0; r < shared->count; ++r) {
        int64_t offset = 0;
        for (int32_t before = 0; before < one->rank; ++before)
            offset += shared->sizes[r][before];
        if (receive_sizes[r] > 0)
            memcpy(out, shared->bytes[r] + offset, (size_t)receive_sizes[r]);
        out += receive_sizes[r];
    }
    if (one->rank == 0)
        for (int32_t from = 0; from < shared->count; ++from)
            for (int32_t to = 0; to < shared->count; ++to)
                if (from != to && shared->sizes[from][to] > 0) {
                    ++shared->messages;
                    shared->sent += shared->sizes[from][to];
                }
    pthread_barrier_wait(&shared->barrier);
    return 0;
}

static void* ranks_thread(void* user)
{
    ranks_one* one = (ranks_one*)user;
    one->body(&one->exchange, one->user);
    return NULL;
}

/* Runs body(exchange, users + rank * size) on `count` ranks, and waits for all of them. No assertion of CMocka may fail
 * within: it would leave the thread. */
static void ranks_run(int32_t count, void (*body)(const cleft_exchange*, void*), void* users, size_t size)
{
    ranks_shared shared;
    ranks_one all[MOST_RANKS];
    memset(&shared, 0, sizeof shared);
    memset(all, 0, sizeof all);
    shared.count = count;
    pthread_barrier_init(&shared.barrier, NULL, (unsigned)count);
    for (int32_t r = 0; r < count; ++r) {
        const cleft_exchange exchange = {sizeof(cleft_exchange), r, count, &all[r], ranks_numbers, ranks_bytes,
                                         r % 2 == 0 ? NULL : "." /* some keep their blocks in files */};
        all[r].shared = &shared;
        all[r].rank = r;
        all[r].exchange = exchange;
        all[r].user = (char*)users + (size_t)r * size;
        all[r].body = body;
    }
    for (int32_t r = 1; r < count; ++r)
        pthread_create(&all[r].thread, NULL, ranks_thread, &all[r]);
    ranks_thread(&all[0]);
    for (int32_t r = 1; r < count; ++r)
        pthread_join(all[r].thread, NULL);
    pthread_barrier_destroy(&shared.barrier);
}

#endif
