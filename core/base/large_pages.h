#pragma once
// Memory for pictures. A page of 4 KB takes the kernel a microsecond or two when it is first touched, which
// is a fifth of the time of a picture of one sample; a page of 2 MB takes it a quarter of that for the same
// bytes.

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace eyeray {

/// Uninitialised memory, in pages of 2 MB where it is as large and the system has them. Throws
/// std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory);

/// Allocator of allocateLarge. Elements without a value are left uninitialised where their type allows.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {} // NOLINT(google-explicit-constructor)

    T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocateLarge(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t) { freeLarge(memory); }

    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Values>
    void construct(U* place, Values&&... values) {
        std::construct_at(place, std::forward<Values>(values)...);
    }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}
