// A cache bounded in bytes that forgets what was used longest ago.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <unordered_map>
#include <utility>

#include "engine/core/check.h"

namespace luftpost::core {
/// Never holds more than `capacity()` bytes, not even while inserting: room is made first. Not thread safe.
template <class Key, class Value, class Hash = std::hash<Key>>
class LruCache {
public:
    explicit LruCache(std::size_t capacityBytes) : capacity_{capacityBytes} {}

    /// Puts `value`, replacing what was under `key`, and makes room by dropping the least recently used; each one dropped
    /// is passed to `onEvict(key, value)`. False, and nothing changes, when `bytes` alone exceed the capacity.
    template <class OnEvict>
    bool insert(Key const& key, Value value, std::size_t bytes, OnEvict onEvict) {
        if (bytes > capacity_) return false;
        erase(key);
        while (bytes_ + bytes > capacity_) evictOldest(onEvict);
        entries_.push_front(Entry{key, std::move(value), bytes});
        places_.emplace(key, entries_.begin());
        bytes_ += bytes;
        peak_ = bytes_ > peak_ ? bytes_ : peak_;
        return true;
    }
    bool insert(Key const& key, Value value, std::size_t bytes) {
        return insert(key, std::move(value), bytes, [](Key const&, Value&) {});
    }

    /// The value, marked as just used; null when there is none. Valid until the next insert or erase.
    Value* find(Key const& key) {
        auto const place = places_.find(key);
        if (place == places_.end()) return nullptr;
        entries_.splice(entries_.begin(), entries_, place->second);
        return &place->second->value;
    }
    /// The value, its age unchanged.
    Value const* peek(Key const& key) const {
        auto const place = places_.find(key);
        return place == places_.end() ? nullptr : &place->second->value;
    }
    bool contains(Key const& key) const { return places_.contains(key); }

    bool erase(Key const& key) {
        auto const place = places_.find(key);
        if (place == places_.end()) return false;
        bytes_ -= place->second->bytes;
        entries_.erase(place->second);
        places_.erase(place);
        return true;
    }

    std::size_t size() const { return entries_.size(); }
    std::size_t bytes() const { return bytes_; }
    std::size_t peakBytes() const { return peak_; }
    std::size_t capacity() const { return capacity_; }
    std::uint64_t evicted() const { return evicted_; }

private:
    struct Entry {
        Key key;
        Value value;
        std::size_t bytes;
    };

    template <class OnEvict>
    void evictOldest(OnEvict& onEvict) {
        CHECK(!entries_.empty(), "{} bytes are held by no entry", bytes_);
        Entry& oldest = entries_.back();
        onEvict(oldest.key, oldest.value);
        bytes_ -= oldest.bytes;
        places_.erase(oldest.key);
        entries_.pop_back();
        ++evicted_;
    }

    std::list<Entry> entries_;  // most recently used first
    std::unordered_map<Key, typename std::list<Entry>::iterator, Hash> places_;
    std::size_t capacity_;
    std::size_t bytes_ = 0, peak_ = 0;
    std::uint64_t evicted_ = 0;
};
}  // namespace luftpost::core
