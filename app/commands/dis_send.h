#pragma once

#include <npsee/exports.h>

#include <span>
#include <string>
#include <string_view>

namespace npsee::commands {

/// A UDP port on this machine; nothing is ever sent to another one.
struct LoopbackPort {
  std::string address;  ///< 127.x.x.x
  std::uint16_t port = kDisPort;
};
/// HOST or HOST:PORT. Error kind usage: not a loopback address, no such port.
Expected<LoopbackPort> parseLoopback(std::string_view text);

/// Sends the packets as UDP datagrams, `speed` times as fast as they were recorded; 0 = as fast as they are taken. Error kind output.
Expected<void> sendPackets(std::span<const DisPacket> packets, const LoopbackPort& to, double speed);

}  // namespace npsee::commands
