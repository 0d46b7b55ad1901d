// Where the wind blows from, the way maps show it: north up.
#pragma once

#include <span>

namespace erg::ui {

/// A dial of `size` pixels whose hand stands where the wind blows FROM; the arrow in it shows where it blows to. Drag
/// anywhere on it (with Shift it snaps to the 16 points of the compass). A fan reaches over the swings of a wind with
/// this `spread` (degrees). True when the bearing changed.
bool wind_dial(const char* id, double& bearing, float size, double spread = 0);

/// A bearing to be typed: degrees or a point of the compass, with the nearest point shown beside. What cannot be read
/// is refused with a tooltip and the bearing stays. True when the bearing changed.
bool type_bearing(const char* id, double& bearing);

/// A wind rose: shares of the time that the wind blew from equal sectors, the first around north, then clockwise.
/// `blown` is filled, `coming` drawn as an outline, each to its own scale; either may be empty.
void draw_wind_rose(const char* id, std::span<const double> blown, std::span<const double> coming, float size);

}  // namespace erg::ui
