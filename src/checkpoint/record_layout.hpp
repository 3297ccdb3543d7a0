// Where a record keeps what; shared by its writer and its reader.
#pragma once

namespace rupture::record_layout {

inline constexpr const char* kTime = "/series/time";
inline constexpr const char* kStep = "/series/step";
inline constexpr const char* kDrivingForce = "/series/F_T";
inline constexpr const char* kDrivePosition = "/series/x_drive";
inline constexpr const char* kPinned = "/series/pinned";
inline constexpr const char* kNormalForce = "/series/p";
inline constexpr const char* kFriction = "/series/tau";
inline constexpr const char* kDisplacement = "/series/u_x";
inline constexpr const char* kRuptureStep = "/ruptures/step";
inline constexpr const char* kRuptureTime = "/ruptures/time";
inline constexpr const char* kRuptureBlock = "/ruptures/block";

inline constexpr const char* kSeriesGroup = "/series/";
inline constexpr const char* kRupturesGroup = "/ruptures/";

}  // namespace rupture::record_layout
