// The array of the stages: a std::vector that the integers of a mesh index. Points, tetrahedra, voxels and materials
// are numbered by int32_t and int64_t, a vector counts by size_t; without this type every access would need a cast.
#pragma once

#include "base/to_size.hpp"

#include <cstdint>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace cleft
{

// operator[] takes any integer, and checks the range in builds with assertions. The rest is std::vector: functions that
// index by size_t alone take and return that, and both move into each other. A copy of a vector has to be asked for, so
// that no reference to an Array is one to a temporary copy by mistake.
template <class T>
class Array : public std::vector<T>
{
    using Vector = std::vector<T>;
    template <class Integer>
    using IfInteger = std::enable_if_t<std::is_integral_v<Integer>, int>;

public:
    Array() = default;
    Array(std::initializer_list<T> values) : Vector(values) {}
    Array(Vector&& values) noexcept : Vector(std::move(values)) {}
    explicit Array(const Vector& values) : Vector(values) {}
    template <class Integer, IfInteger<Integer> = 0>
    explicit Array(Integer count) : Vector(to_size(count))
    {
    }
    template <class Integer, IfInteger<Integer> = 0>
    Array(Integer count, const T& value) : Vector(to_size(count), value)
    {
    }
    template <class Iterator, std::enable_if_t<!std::is_integral_v<Iterator>, int> = 0>
    Array(Iterator first, Iterator last) : Vector(first, last)
    {
    }

    template <class Integer>
    T& operator[](Integer i)
    {
        CLEFT_ASSERT(to_size(i) < this->size());
        return Vector::operator[](to_size(i));
    }
    template <class Integer>
    const T& operator[](Integer i) const
    {
        CLEFT_ASSERT(to_size(i) < this->size());
        return Vector::operator[](to_size(i));
    }

    // size() as int64_t, the type by which points, tetrahedra and voxels are counted.
    int64_t count() const { return static_cast<int64_t>(this->size()); }

    template <class Integer>
    void reserve(Integer count)
    {
        Vector::reserve(to_size(count));
    }
    template <class Integer>
    void resize(Integer count)
    {
        Vector::resize(to_size(count));
    }
    template <class Integer>
    void resize(Integer count, const T& value)
    {
        Vector::resize(to_size(count), value);
    }
    using Vector::assign;
    template <class Integer, IfInteger<Integer> = 0>
    void assign(Integer count, const T& value)
    {
        Vector::assign(to_size(count), value);
    }
};

}  // namespace cleft
