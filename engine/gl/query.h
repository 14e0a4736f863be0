// Owners of queries and fences: what the GPU tells about time.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>

namespace luftpost::gl {
/// A GL_TIMESTAMP query.
class Query {
public:
    Query() = default;
    /// An object ready to record; Query{} is empty.
    static Query timestamp();
    ~Query();
    Query(Query&& other) noexcept : id_{std::exchange(other.id_, 0u)} {}
    Query& operator=(Query&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    unsigned id() const { return id_; }
    /// Asks for the time at which all commands so far are done.
    void record();
    /// The recorded time in nanoseconds; nothing while the GPU is not there yet.
    std::optional<std::uint64_t> poll() const;
    /// The recorded time in nanoseconds; waits for it.
    std::uint64_t wait() const;

private:
    unsigned id_ = 0;
};

/// A GL fence: passed once the GPU has done all that was asked before it.
class Fence {
public:
    Fence() = default;
    static Fence insert();
    ~Fence();
    Fence(Fence&& other) noexcept : sync_{std::exchange(other.sync_, nullptr)} {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    bool empty() const { return sync_ == nullptr; }
    bool passed() const;
    /// Waits up to `nanoseconds`; true when passed.
    bool wait(std::uint64_t nanoseconds) const;

private:
    void* sync_ = nullptr;
};
}  // namespace luftpost::gl
