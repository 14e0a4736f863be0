// Broken inputs made from whole ones: seeded, so that a failure comes again. For every decoder's fuzz test.
// LUFTPOST_FUZZ_SECONDS: how long each test may take (half a second); LUFTPOST_FUZZ_INPUTS: how many inputs at most;
// LUFTPOST_FUZZ_SEED: another sequence. An input that fails is left in fuzz_failure.bin.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/file.h"

namespace luftpost::test {
/// Gives one mutant after another: bits flipped, bytes exchanged, parts cut out, doubled, spliced from another sample; in a
/// text words of a dictionary put in and numbers exchanged for them. At most `most` bytes each.
class Mutator {
public:
    enum class Kind { text, binary };

    Mutator(std::vector<std::string> samples, std::vector<std::string> dictionary, Kind kind = Kind::text,
            std::size_t most = 65536)
        : random_{seed()}, samples_{std::move(samples)}, dictionary_{std::move(dictionary)}, kind_{kind}, most_{most} {}

    std::string next() {
        std::string text = samples_[below(samples_.size())];
        for (std::size_t n = 1 + below(4); n-- > 0;) change(text);
        if (text.size() > most_) text.resize(most_);
        return text;
    }

private:
    static unsigned seed() {
        char const* const text = std::getenv("LUFTPOST_FUZZ_SEED");
        return text ? static_cast<unsigned>(std::atoi(text)) : 1u;
    }

    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }
    std::string const& word() { return dictionary_[below(dictionary_.size())]; }
    std::string const& other() { return samples_[below(samples_.size())]; }

    void change(std::string& text) {
        std::size_t const at = below(text.size() + 1), length = 1 + below(std::min<std::size_t>(text.size() + 1, 40));
        switch (below(kind_ == Kind::binary ? 8 : 12)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                break;
            case 1:
                if (at < text.size()) text[at] = static_cast<char>(below(256));
                break;
            case 2: text.erase(at, length); break;
            case 3: text.resize(at); break;
            case 4: {
                std::string const part = text.substr(at, length);
                for (std::size_t n = 1 + below(8); n-- > 0;) text.insert(at, part);
                break;
            }
            case 5: {
                std::string const& sample = other();
                text.insert(at, sample.substr(below(sample.size() + 1), length));
                break;
            }
            case 6: {
                std::string const& sample = other();
                text = text.substr(0, at) + sample.substr(std::min(at, sample.size()));
                break;
            }
            case 7:
                for (std::size_t i = 0; i < 4 && at + i < text.size(); ++i) text[at + i] = below(2) ? '\xff' : '\0';
                break;
            case 8: text.insert(at, word()); break;
            case 9: changeDigit(text, at); break;
            default: changeNumber(text, at);
        }
    }

    /// The form stays, the figure does not.
    void changeDigit(std::string& text, std::size_t at) {
        at = text.find_first_of("0123456789", at);
        if (at != text.npos) text[at] = static_cast<char>('0' + below(10));
    }

    void changeNumber(std::string& text, std::size_t at) {
        constexpr std::string_view kNumber = "0123456789.-";
        at = text.find_first_of(kNumber, at);
        if (at == text.npos) return;
        text.replace(at, std::min(text.find_first_not_of(kNumber, at), text.size()) - at, word());
    }

    std::mt19937 random_;
    std::vector<std::string> samples_, dictionary_;
    Kind kind_;
    std::size_t most_;
};

struct FuzzScore {
    std::size_t taken = 0, tried = 0;
};

/// Hands mutants to `take` (true: it was taken) until the time is over, the inputs are used up or one has failed.
template <class Take>
FuzzScore fuzz(Mutator mutator, Take take) {
    char const *const secondsText = std::getenv("LUFTPOST_FUZZ_SECONDS"), *const inputsText = std::getenv("LUFTPOST_FUZZ_INPUTS");
    double const seconds = secondsText ? std::atof(secondsText) : 0.5;
    std::size_t const inputs = inputsText ? std::strtoull(inputsText, nullptr, 10) : SIZE_MAX;
    auto const start = std::chrono::steady_clock::now();
    FuzzScore score;
    while (score.tried < inputs && !testing::Test::HasFailure() &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds) {
        std::string const bytes = mutator.next();
        try {
            score.taken += take(bytes);
        } catch (std::exception const& error) {
            ADD_FAILURE() << error.what();
        }
        ++score.tried;
        if (testing::Test::HasFailure()) core::writeFileAtomically("fuzz_failure.bin", bytes);
    }
    std::printf("%zu of %zu inputs were taken\n", score.taken, score.tried);
    return score;
}

/// Damage that is always or never noticed tests nothing.
inline void expectBoth(FuzzScore const& score, double least = 0.01) {
    EXPECT_GE(score.tried, 64u);
    EXPECT_GT(score.taken, static_cast<double>(score.tried) * least) << "mutants that are still whole";
    EXPECT_LT(score.taken, score.tried);
}
}  // namespace luftpost::test
