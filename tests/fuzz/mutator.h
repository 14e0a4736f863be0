// Broken inputs made from whole ones: seeded, so that a failure comes again. For every decoder's fuzz test.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace luftpost::test {
/// Gives one mutant after another: bits flipped, bytes exchanged, parts cut out, doubled, spliced from another sample, words of a
/// dictionary put in. At most `most` bytes each.
class Mutator {
public:
    Mutator(unsigned seed, std::vector<std::string> samples, std::vector<std::string> dictionary, std::size_t most = 65536)
        : random_{seed}, samples_{std::move(samples)}, dictionary_{std::move(dictionary)}, most_{most} {}

    std::string next() {
        std::string text = samples_[below(samples_.size())];
        for (std::size_t n = 1 + below(4); n-- > 0;) change(text);
        if (text.size() > most_) text.resize(most_);
        return text;
    }

private:
    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

    void change(std::string& text) {
        std::size_t const at = below(text.size() + 1), length = 1 + below(std::min<std::size_t>(text.size() + 1, 40));
        switch (below(8)) {
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
                std::string const& other = samples_[below(samples_.size())];
                text.insert(at, other.substr(below(other.size() + 1), length));
                break;
            }
            case 6: text.insert(at, dictionary_[below(dictionary_.size())]); break;
            default:  // another digit: the form stays, the figure does not
                for (std::size_t i = at; i < text.size(); ++i)
                    if (text[i] >= '0' && text[i] <= '9') {
                        text[i] = static_cast<char>('0' + below(10));
                        break;
                    }
        }
    }

    std::mt19937 random_;
    std::vector<std::string> samples_, dictionary_;
    std::size_t most_;
};

/// Runs `once` until LUFTPOST_FUZZ_SECONDS of the wall clock are over (without it, half a second); how often it ran.
template <class Once>
std::size_t fuzz(Once once) {
    char const* const text = std::getenv("LUFTPOST_FUZZ_SECONDS");
    double const seconds = text ? std::atof(text) : 0.5;
    auto const start = std::chrono::steady_clock::now();
    std::size_t count = 0;
    do {
        for (int i = 0; i < 64; ++i) once();
        count += 64;
    } while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < seconds);
    return count;
}
}  // namespace luftpost::test
