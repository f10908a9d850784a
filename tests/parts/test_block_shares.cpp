// Which rank gets which blocks: all of them once, in order, and as evenly as can be.
#include "blocks/block_shares.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cleft;
using namespace cleft_test;

namespace
{

double sum_of(const Array<double>& work, int32_t begin, int32_t end)
{
    double sum = 0;
    for (int32_t b = begin; b < end; ++b)
        sum += work[b];
    return sum;
}

// The least greatest work of all ways to cut a row of blocks: least[b] is that of the first b blocks.
double least_greatest_work(const Array<double>& work, int32_t ranks)
{
    const int32_t blocks = static_cast<int32_t>(work.size());
    std::vector<double> least(work.size() + 1, INFINITY);
    least[0] = 0;
    for (int32_t r = 0; r < ranks; ++r)
        for (int32_t end = blocks; end > 0; --end)
            for (int32_t begin = 0; begin < end; ++begin)
                least[static_cast<size_t>(end)] =
                    std::min(least[static_cast<size_t>(end)],
                             std::max(least[static_cast<size_t>(begin)], sum_of(work, begin, end)));
    return least.back();
}

void require_all_once(const BlockShares& shares, int32_t blocks, int32_t ranks)
{
    assert_int_equal(shares.blocks(), blocks);
    int32_t next = 0, most = 0;
    for (int32_t r = 0; r < ranks; ++r) {
        const OwnBlocks own = shares.of(r);
        assert_int_equal(own.first, next);
        for (int32_t b = own.first; b < own.end(); ++b)
            assert_int_equal(shares.owner(b), r);
        next = own.end();
        most = std::max(most, own.count);
    }
    assert_int_equal(next, blocks);
    assert_int_equal(shares.greatest_count(), most);
}

void equal_shares_differ_by_one(void**)
{
    for (const int32_t blocks : {1, 5, 8, 19})
        for (const int32_t ranks : {1, 2, 5, 7, 30}) {
            const BlockShares shares = BlockShares::equal(blocks, ranks);
            require_all_once(shares, blocks, ranks);
            assert_int_equal(shares.greatest_count(), (blocks + ranks - 1) / ranks);
        }
}

void balanced_shares_are_the_best(void**)
{
    Random random(7);
    for (int turn = 0; turn < 300; ++turn) {
        const auto blocks = static_cast<int32_t>(1 + 15 * random.unit());
        const auto ranks = static_cast<int32_t>(1 + 6 * random.unit());
        Array<double> work;
        for (int32_t b = 0; b < blocks; ++b)
            // Some blocks have no tetrahedra to speak of, and some very many.
            work.push_back(random.unit() < 0.2 ? 0 : std::exp(6 * random.unit()));
        const BlockShares shares = BlockShares::balanced(work, ranks);
        require_all_once(shares, blocks, ranks);
        double greatest = 0;
        for (int32_t r = 0; r < ranks; ++r)
            greatest = std::max(greatest, sum_of(work, shares.of(r).first, shares.of(r).end()));
        assert_true(greatest <= 1.0011 * least_greatest_work(work, ranks));
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(equal_shares_differ_by_one),
        cmocka_unit_test(balanced_shares_are_the_best),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
