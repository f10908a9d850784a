// Access to plain values that several threads read and write at once: what std::atomic_ref does in C++20. Without any
// order between different values, but where it is said; threads see what others did when the loop is over.
#pragma once

namespace cleft
{

template <class T>
T load_shared(const T& value)
{
    T found;
    __atomic_load(&value, &found, __ATOMIC_RELAXED);
    return found;
}

template <class T>
void store_shared(T& value, T to)
{
    __atomic_store(&value, &to, __ATOMIC_RELAXED);
}

// Who loads what another thread has stored by these sees all that this thread did before.
template <class T>
T load_acquired(const T& value)
{
    T found;
    __atomic_load(&value, &found, __ATOMIC_ACQUIRE);
    return found;
}

template <class T>
void store_released(T& value, T to)
{
    __atomic_store(&value, &to, __ATOMIC_RELEASE);
}

template <class T>
void add_shared(T& value, T more)
{
    __atomic_fetch_add(&value, more, __ATOMIC_RELAXED);
}

// True if the value was `from`; only then it changes.
template <class T>
bool replace_shared(T& value, T from, T to)
{
    return __atomic_compare_exchange(&value, &from, &to, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
}

// To the lesser of both.
template <class T>
void lower_shared(T& value, T to)
{
    T before = load_shared(value);
    while (to < before && !__atomic_compare_exchange(&value, &before, &to, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
        ;
}

}  // namespace cleft
