// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "frame/stage.hpp"
#include "truth/fibre_rays.hpp"
#include "truth/opaque.hpp"

namespace pelage::truth {

/// Radiance with and without shadows, linear RGB.
struct radiance {
  glm::dvec3 lit{0.0};   ///< nothing stands before the lights
  glm::dvec3 full{0.0};  ///< all stands there

  radiance& operator+=(const radiance& other) {
    lit += other.lit;
    full += other.full;
    return *this;
  }
  friend radiance operator*(double share, const radiance& r) { return {share * r.lit, share * r.full}; }
};

/// What surfaces and fibres send to an eye, by rays to each light: the renderer's look (Kajiya-Kay's fibres, Lambert's
/// solids, the sky's share, haze and background) in text of its own. What a shadow ray meets is asked of `Shadows`,
/// `double operator()(const ray&, std::uint32_t own)`, the share that passes.
class lighting {
 public:
  /// Both must outlive it.
  lighting(const frame::stage& set, const fibre_rays& fibres) : set_(set), fibres_(fibres) {}

  /// The ray from a place to a light, and the light that comes along it.
  struct arrival {
    ray way;
    glm::dvec3 to_light;  ///< unit
    glm::dvec3 colour;    ///< linear RGB, shadows apart
  };
  [[nodiscard]] arrival arriving(const frame::light& from, const glm::dvec3& at) const;

  /// The place on the fibre's axis, where it is lit.
  [[nodiscard]] glm::dvec3 place_of(const fibre_hit& h) const;
  /// The place on a solid, lifted off its surface by 10⁻⁶ of the scene's radius.
  [[nodiscard]] glm::dvec3 place_of(const opaque_hit& h, const ray& seen) const;

  /// What passes to a place along a ray: the fibres' transmittance, 0 behind a solid.
  [[nodiscard]] double passing(const ray& way, std::uint32_t own) const;

  template <class Shadows>
  [[nodiscard]] radiance of(const fibre_hit& h, const ray& seen, const Shadows& shadows) const;

  /// `h` may be nothing: the background.
  template <class Shadows>
  [[nodiscard]] radiance of(const opaque_hit& h, const ray& seen, const Shadows& shadows) const;

  [[nodiscard]] const frame::stage& set() const { return set_; }
  [[nodiscard]] const fibre_rays& fibres() const { return fibres_; }

 private:
  struct fibre_surface {
    glm::dvec3 tangent, to_eye, colour;
  };
  [[nodiscard]] fibre_surface surface_of(const fibre_hit& h, const ray& seen) const;
  [[nodiscard]] static glm::dvec3 scattered(const fibre_surface& s, const arrival& in);
  [[nodiscard]] glm::dvec3 sky_on(const fibre_surface& s) const;
  [[nodiscard]] glm::dvec3 sky_on(const opaque_hit& h) const;
  [[nodiscard]] glm::dvec3 background(const glm::dvec3& direction) const;

  const frame::stage& set_;
  const fibre_rays& fibres_;
};

// ---------------------------------------------------------------------------------------------------------

template <class Shadows>
radiance lighting::of(const fibre_hit& h, const ray& seen, const Shadows& shadows) const {
  const fibre_surface s = surface_of(h, seen);
  const glm::dvec3 place = place_of(h);
  const glm::dvec3 sky = sky_on(s);
  radiance sum{sky, sky};
  for (const frame::light& from : set_.lights) {
    const arrival in = arriving(from, place);
    const glm::dvec3 sent = scattered(s, in);
    sum.lit += sent;
    if (sent != glm::dvec3(0.0)) sum.full += shadows(in.way, h.segment) * sent;
  }
  return sum;
}

template <class Shadows>
radiance lighting::of(const opaque_hit& h, const ray& seen, const Shadows& shadows) const {
  const glm::dvec3 far = background(seen.direction);
  if (!h.exists()) return {far, far};
  const glm::dvec3 place = place_of(h, seen);
  const glm::dvec3 sky = sky_on(h);
  radiance sum{sky, sky};
  for (const frame::light& from : set_.lights) {
    const arrival in = arriving(from, place);
    const double facing = glm::dot(h.soft_normal, in.to_light);
    if (!(facing > 0.0)) continue;
    const glm::dvec3 sent = facing * h.colour * in.colour;
    sum.lit += sent;
    sum.full += shadows(in.way, fibre_rays::nobody) * sent;
  }
  return {glm::mix(sum.lit, far, h.haze), glm::mix(sum.full, far, h.haze)};
}

}  // namespace pelage::truth
