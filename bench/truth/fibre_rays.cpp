// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/fibre_rays.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace pelage::truth {
namespace {

constexpr double least_transmittance = 1e-4;

/// What one query's filter needs; Embree hands it the address of the first member.
struct query {
  RTCIntersectContext context{};
  const frame::strands* fibres;
  std::uint32_t own = fibre_rays::nobody;
  std::vector<fibre_hit>* met = nullptr;
  double speed = 1;  ///< the length of the ray's direction
  double passed = 1;
  frame::random_stream* random = nullptr;
};

/// True for a segment and itself or its neighbour: a strand's points follow each other, the next strand's are two on.
bool adjacent(const frame::strands& fibres, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t first = fibres.segment[a];
  const std::uint32_t other = fibres.segment[b];
  return first <= other ? other - first <= 1 : first - other <= 1;
}

bool enters(const RTCRay& r, const RTCHit& h) {
  return h.Ng_x * r.dir_x + h.Ng_y * r.dir_y + h.Ng_z * r.dir_z < 0.0F;
}

/// The entry that Embree asks about, unless it is the ray's own fibre.
std::optional<fibre_hit> entry_of(const RTCFilterFunctionNArguments* asked) {
  const query& q = *reinterpret_cast<const query*>(asked->context);
  const RTCRay& r = *reinterpret_cast<const RTCRay*>(asked->ray);
  const RTCHit& h = *reinterpret_cast<const RTCHit*>(asked->hit);
  if (!enters(r, h)) return std::nullopt;
  if (q.own != fibre_rays::nobody && adjacent(*q.fibres, q.own, h.primID)) return std::nullopt;
  return fibre_hit{static_cast<double>(r.tfar), h.primID, std::clamp(h.u, 0.0F, 1.0F)};
}

/// The distance along the ray within which entries round a joint are one.
double joint_reach(const frame::strands& fibres, const fibre_hit& h, double speed) {
  return 4.0 * static_cast<double>(fibres.mix(fibres.radius, h.segment, h.along)) / speed;
}

/// Removes entries that follow one of the same fibre round a joint. `met`: nearest first.
void unite_joints(const frame::strands& fibres, double speed, std::vector<fibre_hit>& met) {
  std::size_t kept = 0;
  for (const fibre_hit& h : met) {
    const double from = h.distance - joint_reach(fibres, h, speed);
    bool known = false;
    for (std::size_t i = kept; i > 0 && met[i - 1].distance >= from && !known; --i)
      known = adjacent(fibres, met[i - 1].segment, h.segment);
    if (!known) met[kept++] = h;
  }
  met.resize(kept);
}

// Filters refuse every hit, so that Embree goes on, or accept one and it stops there.

void collect(const RTCFilterFunctionNArguments* asked) {
  const query& q = *reinterpret_cast<const query*>(asked->context);
  if (const auto found = entry_of(asked)) q.met->push_back(*found);
  asked->valid[0] = 0;
}

void attenuate(const RTCFilterFunctionNArguments* asked) {
  query& q = *reinterpret_cast<query*>(asked->context);
  asked->valid[0] = 0;
  const auto found = entry_of(asked);
  if (!found) return;
  const double reach = joint_reach(*q.fibres, *found, q.speed);
  const bool known = std::any_of(q.met->begin(), q.met->end(), [&](const fibre_hit& h) {
    return std::abs(h.distance - found->distance) <= reach && adjacent(*q.fibres, h.segment, found->segment);
  });
  if (known) return;
  q.met->push_back(*found);
  q.passed *= 1.0 - static_cast<double>(q.fibres->mix(q.fibres->opacity, found->segment, found->along));
  if (q.passed < least_transmittance) asked->valid[0] = -1;
}

void draw(const RTCFilterFunctionNArguments* asked) {
  query& q = *reinterpret_cast<query*>(asked->context);
  const auto found = entry_of(asked);
  const bool stops = found && q.random->unit() < q.fibres->mix(q.fibres->opacity, found->segment, found->along);
  asked->valid[0] = stops ? -1 : 0;
}

query ask(const frame::strands& fibres, RTCFilterFunctionN filter) {
  query q{};
  rtcInitIntersectContext(&q.context);
  q.context.filter = filter;
  q.fibres = &fibres;
  return q;
}

RTCRay ray_of(const ray& r) {
  const glm::vec3 o(r.origin);
  const glm::vec3 d(r.direction);
  RTCRay to{};
  to.org_x = o.x;
  to.org_y = o.y;
  to.org_z = o.z;
  to.dir_x = d.x;
  to.dir_y = d.y;
  to.dir_z = d.z;
  to.tfar = static_cast<float>(r.end);
  to.mask = 0xffffffffU;
  return to;
}

}  // namespace

struct fibre_rays::embree {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;

  embree() = default;
  ~embree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  embree(const embree&) = delete;
  embree& operator=(const embree&) = delete;

  void build(const frame::strands& fibres);
};

void fibre_rays::embree::build(const frame::strands& fibres) {
  const RTCGeometry curves = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t bytes, std::size_t count) {
    return rtcSetNewGeometryBuffer(curves, type, 0, format, bytes, count);
  };
  const std::size_t points = fibres.point.size();
  const std::size_t segments = fibres.segment.size();
  auto* const point = static_cast<float*>(buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, points));
  auto* const first = static_cast<std::uint32_t*>(buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 4, segments));
  auto* const joined = static_cast<std::uint8_t*>(buffer(RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, 1, segments));
  for (std::size_t i = 0; i < points; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      point[4 * i + static_cast<std::size_t>(axis)] = fibres.point[i][axis];
    point[4 * i + 3] = fibres.radius[i];
  }
  for (std::size_t s = 0; s < segments; ++s) {
    const std::uint32_t i = fibres.segment[s];
    first[s] = i;
    const bool begins = (fibres.end_of[i] & frame::strands::first) != 0;
    const bool ends = (fibres.end_of[i + 1] & frame::strands::last) != 0;
    joined[s] = static_cast<std::uint8_t>((begins ? 0 : RTC_CURVE_FLAG_NEIGHBOR_LEFT) |
                                          (ends ? 0 : RTC_CURVE_FLAG_NEIGHBOR_RIGHT));
  }
  rtcCommitGeometry(curves);
  rtcAttachGeometry(scene, curves);
  rtcReleaseGeometry(curves);
}

fibre_rays::fibre_rays(const frame::strands& fibres) : fibres_(fibres), embree_(std::make_unique<embree>()) {
  if (embree_->device == nullptr) throw std::runtime_error("Embree gives no device");
  const auto start = std::chrono::steady_clock::now();
  embree_->scene = rtcNewScene(embree_->device);
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  if (fibres.segment_count() > 0) embree_->build(fibres);
  rtcCommitScene(embree_->scene);
  build_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE) throw std::runtime_error("Embree takes not these fibres");
}

fibre_rays::~fibre_rays() = default;

void fibre_rays::find(const ray& r, std::vector<fibre_hit>& met) const {
  met.clear();
  query q = ask(fibres_, collect);
  q.met = &met;
  RTCRay to = ray_of(r);
  rtcOccluded1(embree_->scene, &q.context, &to);
  std::sort(met.begin(), met.end(), [](const fibre_hit& a, const fibre_hit& b) { return a.distance < b.distance; });
  unite_joints(fibres_, glm::length(r.direction), met);
}

double fibre_rays::transmittance(const ray& r, std::uint32_t own) const {
  static thread_local std::vector<fibre_hit> met;
  met.clear();
  query q = ask(fibres_, attenuate);
  q.met = &met;
  q.speed = glm::length(r.direction);
  q.own = own;
  RTCRay to = ray_of(r);
  rtcOccluded1(embree_->scene, &q.context, &to);
  return q.passed < least_transmittance ? 0.0 : q.passed;
}

std::optional<fibre_hit> fibre_rays::draw_nearest(const ray& r, frame::random_stream& random) const {
  query q = ask(fibres_, draw);
  q.random = &random;
  RTCRayHit to{ray_of(r), {}};
  to.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->scene, &q.context, &to);
  if (to.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return fibre_hit{static_cast<double>(to.ray.tfar), to.hit.primID, std::clamp(to.hit.u, 0.0F, 1.0F)};
}

bool fibre_rays::draw_blocked(const ray& r, std::uint32_t own, frame::random_stream& random) const {
  query q = ask(fibres_, draw);
  q.random = &random;
  q.own = own;
  RTCRay to = ray_of(r);
  rtcOccluded1(embree_->scene, &q.context, &to);
  return to.tfar < 0.0F;
}

}  // namespace pelage::truth
