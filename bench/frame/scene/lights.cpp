// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pelage::frame {
namespace {

/// The parts between separators, one more than there are of those; a part may be empty.
std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

float read_number(const std::string& text, const std::string& whole) {
  std::size_t used = 0;
  float value = 0;
  try {
    value = std::stof(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size() || !(std::abs(value) <= 1e6F)) {
    throw std::invalid_argument(fmt::format("light '{}': '{}' is not a number in [-1e6, 1e6]", whole, text));
  }
  return value;
}

glm::vec3 read_vector(const std::string& text, const std::string& whole) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) {
    throw std::invalid_argument(fmt::format("light '{}': '{}' is not three numbers X,Y,Z", whole, text));
  }
  return {read_number(parts[0], whole), read_number(parts[1], whole), read_number(parts[2], whole)};
}

light_kind read_kind(const std::string& text, const std::string& whole) {
  if (text == "directional") return light_kind::directional;
  if (text == "point") return light_kind::point;
  if (text == "spot") return light_kind::spot;
  throw std::invalid_argument(fmt::format("light '{}': '{}' is not directional, point or spot", whole, text));
}

}  // namespace

light parse_light(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  const light_kind kind = read_kind(parts[0], text);
  const std::size_t expected = kind == light_kind::spot ? 4 : 3;
  if (parts.size() != expected) {
    throw std::invalid_argument(fmt::format("light '{}': expected {} parts between ':'", text, expected));
  }
  light l{};
  l.kind = kind;
  l.position = read_vector(parts[1], text);
  l.colour = read_vector(parts[2], text);
  if (glm::any(glm::lessThan(l.colour, glm::vec3(0.0F)))) {
    throw std::invalid_argument(fmt::format("light '{}': a colour must not be negative", text));
  }
  const float distance = glm::length(l.position);
  if (distance == 0.0F) {
    throw std::invalid_argument(fmt::format("light '{}': it stands in the scene's centre", text));
  }
  if (!std::isfinite(distance)) throw std::invalid_argument(fmt::format("light '{}': it stands too far away", text));
  l.direction = -glm::normalize(l.position);
  if (kind == light_kind::spot) {
    const float degrees = read_number(parts[3], text);
    if (!(degrees > 0.0F && degrees < 170.0F)) {
      throw std::invalid_argument(fmt::format("light '{}': the spot's angle must be in (0, 170) degrees", text));
    }
    l.cos_outer = std::cos(glm::radians(0.5F * degrees));
    l.cos_inner = std::cos(glm::radians(0.4F * degrees));
  }
  return l;
}

light place_light(const light& relative, const sphere& scene) {
  light placed = relative;
  placed.position = scene.centre + scene.radius * relative.position;
  return placed;
}

view light_view(const light& placed, const sphere& fibres, int texels) {
  constexpr float slack = 1.02F;
  if (placed.kind == light_kind::directional) {
    return orthographic_view(fibres.centre, placed.direction, 2.0F * slack * fibres.radius, texels);
  }
  const float distance = glm::length(fibres.centre - placed.position);
  if (distance <= slack * fibres.radius) {
    throw std::invalid_argument("a point or spot light stands inside the model; move it out or make it directional");
  }
  const float sine = slack * fibres.radius / distance;
  const float tangent = sine / std::sqrt(1.0F - sine * sine);
  const float near_plane = 0.5F * (distance - fibres.radius);
  view from = perspective_view(placed.position, fibres.centre, tangent, texels, texels, near_plane);
  from.far_depth = distance + fibres.radius;
  return from;
}

}  // namespace pelage::frame
