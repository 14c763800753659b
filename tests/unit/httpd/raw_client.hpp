#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <string_view>

/// A TCP client that sends any bytes, right or wrong.
namespace vicus::test {

class RawClient {
 public:
  RawClient() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {}
  explicit RawClient(std::uint16_t port) : RawClient() { connect(port); }
  ~RawClient() { close(); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool connect(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  void close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  /// How many bytes the other side took.
  std::size_t send(std::string_view bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const auto n = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) break;
      sent += static_cast<std::size_t>(n);
    }
    return sent;
  }
  void send_end() { ::shutdown(socket_, SHUT_WR); }

  /// What comes until the other side closes, or `patience` has passed without a byte.
  std::string read_all(std::chrono::milliseconds patience = std::chrono::seconds(20)) {
    std::string all;
    char buffer[65536];
    for (is_closed_ = false;;) {
      pollfd wait{socket_, POLLIN, 0};
      if (::poll(&wait, 1, static_cast<int>(patience.count())) <= 0) return all;
      const auto n = ::recv(socket_, buffer, sizeof buffer, 0);
      if (n <= 0) return is_closed_ = true, all;
      all.append(buffer, static_cast<std::size_t>(n));
    }
  }
  /// One answer with a Content-Length (none: no body).
  std::string read_answer(bool has_body = true) {
    std::string text;
    char byte = 0;
    while (text.find("\r\n\r\n") == text.npos && read_byte(byte)) text += byte;
    const auto at = text.find("Content-Length: ");
    std::size_t length = at == text.npos || !has_body ? 0 : std::stoul(text.substr(at + 16));
    for (; length > 0 && read_byte(byte); --length) text += byte;
    return text;
  }
  bool is_closed() const { return is_closed_; }  ///< by the other side, as read_all saw it

 private:
  bool read_byte(char& byte) {
    pollfd wait{socket_, POLLIN, 0};
    return ::poll(&wait, 1, 20'000) > 0 && ::recv(socket_, &byte, 1, 0) == 1;
  }
  int socket_ = -1;
  bool is_closed_ = false;
};

/// The three digits; 0: no answer.
inline int status_of(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 ") && answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0;
}

}  // namespace vicus::test
