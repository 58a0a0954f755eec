#pragma once

#include <npsee/recording.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace npsee {

/// A recording in the formats of other programs. The world has no place on the earth: where a format wants one, the world's middle
/// lies at latitude and longitude 0 and its plane is the tangent plane there.

struct ExportSetup {
  double step_s = 1.0;        ///< between two samples of what drives, s
  double shell_step_s = 0.25; ///< and of what flies, s
};
/// Most samples (and so lines or packets) of an export.
inline constexpr double kMaxExportSamples = 5e6;

/// Tacview ACMI 2.2 text: vehicles, guns, shells, bursts; calls, destroyed vehicles and ends of missions as its events. The fields
/// U and V carry x and -z, metres. Source: Tacview technical reference, ACMI flight recordings 2.2.
/// Error kind usage: too many samples, steps that are no times.
Expected<std::string> acmiText(const Recording& recording, const ExportSetup& setup = {});

/// Comma-separated values, one row per thing and sample (errors as of acmiText):
/// t_s,kind,id,name,side,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,heading_deg,state
Expected<std::string> csvText(const Recording& recording, const ExportSetup& setup = {});

/// A protocol data unit of Distributed Interactive Simulation, and when it is sent.
struct DisPacket {
  double t_s = 0.0;
  std::vector<std::uint8_t> bytes;
};
/// Entity State (144 bytes), Fire (96) and Detonation (104) PDUs of IEEE 1278.1, by time. Fire and Detonation of a shot share their
/// event and munition identifiers; timestamps are rounded to the nearest unit of 3600 s / 2^31. Errors as of acmiText.
Expected<std::vector<DisPacket>> disPackets(const Recording& recording, const ExportSetup& setup = {});

inline constexpr std::uint16_t kDisPort = 3000;
/// The packets as a capture file (pcap) of UDP datagrams on loopback, port 3000.
std::string pcapText(std::span<const DisPacket> packets);

}  // namespace npsee
