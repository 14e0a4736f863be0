// A server of weather on this machine, for one test: tests/play/weather_server.py, begun and ended.
#pragma once
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "tests/play/program.h"

namespace luftpost::tests {
/// A certificate that nobody vouches for, with its key, good for 127.0.0.1 and an hour.
inline void writeCertificate(fs::path const& file) {
    std::unique_ptr<EVP_PKEY, void (*)(EVP_PKEY*)> const key{EVP_EC_gen("P-256"), EVP_PKEY_free};
    std::unique_ptr<X509, void (*)(X509*)> const certificate{X509_new(), X509_free};
    ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), 1);
    X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -60);
    X509_gmtime_adj(X509_getm_notAfter(certificate.get()), 3600);
    X509_set_pubkey(certificate.get(), key.get());
    X509_NAME* const name = X509_get_subject_name(certificate.get());
    X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, reinterpret_cast<unsigned char const*>("127.0.0.1"), -1, -1, 0);
    X509_set_issuer_name(certificate.get(), name);
    X509_sign(certificate.get(), key.get(), EVP_sha256());
    std::unique_ptr<FILE, int (*)(FILE*)> const out{std::fopen(file.c_str(), "w"), std::fclose};
    PEM_write_X509(out.get(), certificate.get());
    PEM_write_PrivateKey(out.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
}

class WeatherServer {
public:
    explicit WeatherServer(bool tls = false) : folder_{scratch() / "server"}, tls_{tls} {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        if (tls) writeCertificate(folder_ / "certificate.pem");
        std::string const script = std::string{LUFTPOST_SOURCE_DIR} + "/tests/play/weather_server.py";
        process_ = ::fork();
        if (process_ == 0) {
            ::execlp("python3", "python3", script.c_str(), folder_.c_str(), tls ? "--tls" : nullptr, nullptr);
            ::_exit(127);
        }
        for (int i = 0; i < 2000 && !fs::exists(folder_ / "port"); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{5});
        port_ = fileText(folder_ / "port");
        EXPECT_FALSE(port_.empty()) << "the server did not start";
    }
    ~WeatherServer() { stop(); }
    WeatherServer(WeatherServer const&) = delete;
    WeatherServer& operator=(WeatherServer const&) = delete;

    void stop() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = -1;
    }
    std::string url(std::string const& mode) const { return (tls_ ? "https://127.0.0.1:" : "http://127.0.0.1:") + port_ + "/" + mode; }
    /// A line for each request so far.
    std::string requests() const { return fileText(folder_ / "requests"); }
    std::ptrdiff_t requestCount() const {
        std::string const lines = requests();
        return std::count(lines.begin(), lines.end(), '\n');
    }

private:
    fs::path folder_;
    bool tls_;
    pid_t process_ = -1;
    std::string port_;
};
}  // namespace luftpost::tests
