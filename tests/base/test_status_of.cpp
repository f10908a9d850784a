// Each exception becomes one status and one sentence, in both libraries.
#include "base/status_of.hpp"
#include "support/cmocka.hpp"

#include <string>

using namespace cleft;

namespace
{

struct Failure {
    cleft_status status = CLEFT_OK;
    std::string sentence;
};

template <class Thrown>
Failure failure_of(const Thrown& thrown)
{
    Failure failure;
    const cleft_status answer = status_of([&] { throw thrown; },
                                          [&](cleft_status status, const char* sentence) noexcept {
                                              failure = {status, sentence};
                                              return status;
                                          });
    assert_int_equal(answer, failure.status);
    return failure;
}

template <class Thrown>
void assert_becomes(const Thrown& thrown, cleft_status status, const char* sentence)
{
    const Failure failure = failure_of(thrown);
    assert_int_equal(failure.status, status);
    assert_string_equal(failure.sentence.c_str(), sentence);
}

void exceptions_become_statuses(void**)
{
    assert_becomes(Error(CLEFT_ERROR_FILE, "there is no 'a'"), CLEFT_ERROR_FILE, "there is no 'a'");
    assert_becomes(std::bad_alloc(), CLEFT_ERROR_OUT_OF_MEMORY, "there is not enough memory");
    assert_becomes(std::length_error("vector"), CLEFT_ERROR_OUT_OF_MEMORY, "there is not enough memory");
    assert_becomes(std::logic_error("a row is missing"), CLEFT_ERROR_INTERNAL, "a row is missing");
    assert_becomes(7, CLEFT_ERROR_INTERNAL, "an unknown exception was thrown");
}

void what_went_well_is_not_told(void**)
{
    const auto failed = [](cleft_status, const char*) noexcept -> cleft_status { return CLEFT_ERROR_INTERNAL; };
    assert_int_equal(status_of([] {}, failed), CLEFT_OK);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(exceptions_become_statuses),
        cmocka_unit_test(what_went_well_is_not_told),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
