// A manoeuvre reads as it is flown, one thing after the other, and waits for the next tick inside: a coroutine.
//     Manoeuvre pull(Hand& hand) {
//         for (double t = 0.0; t < 2.0; t += kTick) { ...; co_await hand.nextTick(); }
//         co_await recover(hand);  // one within the other
//     }
#pragma once
#include <coroutine>
#include <exception>
#include <utility>

namespace luftpost::bot {
class Manoeuvre {
public:
    struct promise_type {
        std::coroutine_handle<> after = std::noop_coroutine();  // who waits for the end

        Manoeuvre get_return_object() {
            return Manoeuvre{std::coroutine_handle<promise_type>::from_promise(*this)};
        }
        std::suspend_always initial_suspend() noexcept { return {}; }
        struct End {
            bool await_ready() noexcept { return false; }
            std::coroutine_handle<> await_suspend(std::coroutine_handle<promise_type> ended) noexcept {
                return ended.promise().after;
            }
            void await_resume() noexcept {}
        };
        End final_suspend() noexcept { return {}; }
        void return_void() {}
        [[noreturn]] void unhandled_exception() { std::terminate(); }
    };

    explicit Manoeuvre(std::coroutine_handle<promise_type> handle) : handle_{handle} {}
    Manoeuvre(Manoeuvre&& other) noexcept : handle_{std::exchange(other.handle_, nullptr)} {}
    Manoeuvre& operator=(Manoeuvre&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Manoeuvre() {
        if (handle_) handle_.destroy();
    }

    bool done() const { return handle_.done(); }
    std::coroutine_handle<> handle() const { return handle_; }

    // Awaited within another manoeuvre: begins at once, and the other goes on when it is over.
    bool await_ready() const noexcept { return false; }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> waiting) noexcept {
        handle_.promise().after = waiting;
        return handle_;
    }
    void await_resume() const noexcept {}

private:
    std::coroutine_handle<promise_type> handle_;
};

/// Where a running manoeuvre stands: goes on from its latest nextTick().
class Turn {
public:
    void begin(Manoeuvre const& manoeuvre) { at_ = manoeuvre.handle(); }
    void goOn() { at_.resume(); }

    struct NextTick {
        Turn& turn;
        bool await_ready() const noexcept { return false; }
        void await_suspend(std::coroutine_handle<> here) noexcept { turn.at_ = here; }
        void await_resume() const noexcept {}
    };
    NextTick nextTick() { return {*this}; }

private:
    std::coroutine_handle<> at_;
};
}  // namespace luftpost::bot
