#include "app/commands/dis_send.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <thread>

namespace npsee::commands {

Expected<LoopbackPort> parseLoopback(std::string_view text) {
  const std::string shown = "--send " + std::string(text);
  LoopbackPort out;
  const std::size_t colon = text.rfind(':');
  out.address = std::string(text.substr(0, colon));
  if (out.address == "localhost") out.address = "127.0.0.1";
  if (colon != std::string_view::npos) {
    const std::string_view port = text.substr(colon + 1);
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), out.port);
    if (error != std::errc() || end != port.data() + port.size() || out.port == 0) return fail(ErrorKind::usage, shown + ": \"" + std::string(port) + "\" is no port.", "Ports are 1 to 65535; DIS uses 3000.");
  }
  in_addr address{};
  if (inet_pton(AF_INET, out.address.c_str(), &address) != 1 || (ntohl(address.s_addr) >> 24) != 127)
    return fail(ErrorKind::usage, shown + ": packets are sent to this machine only.", "Give a loopback address, e.g. 127.0.0.1:3000; other machines can read the capture that -o writes.");
  return out;
}

Expected<void> sendPackets(std::span<const DisPacket> packets, const LoopbackPort& to, double speed) {
  const int descriptor = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return fail(ErrorKind::output, "no UDP socket can be opened: " + std::string(std::strerror(errno)) + ".");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(to.port);
  inet_pton(AF_INET, to.address.c_str(), &address.sin_addr);
  const auto start = std::chrono::steady_clock::now();
  int failure = 0;
  for (const DisPacket& packet : packets) {
    if (speed > 0.0) std::this_thread::sleep_until(start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(packet.t_s / speed)));
    const ssize_t sent = ::sendto(descriptor, packet.bytes.data(), packet.bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    // That nobody listens yet is no failure of ours: UDP tells it late, and others may join.
    if (sent < 0 && errno != ECONNREFUSED) failure = errno;
    if (failure != 0) break;
  }
  ::close(descriptor);
  if (failure != 0) return fail(ErrorKind::output, "a packet could not be sent to " + to.address + ": " + std::strerror(failure) + ".");
  return {};
}

}  // namespace npsee::commands
