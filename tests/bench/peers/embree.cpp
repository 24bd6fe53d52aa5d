// SPDX-License-Identifier: MIT
#include "depth_pass.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace peers {

struct embree_scene::state {
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    RTCScene scene = nullptr;
};

embree_scene::embree_scene() : state_(std::make_unique<state>()) {
    if (!state_->device) throw std::runtime_error("Embree does not start");
}

embree_scene::~embree_scene() {
    if (state_->scene) rtcReleaseScene(state_->scene);
    rtcReleaseDevice(state_->device);
}

void embree_scene::build(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
    if (state_->scene) rtcReleaseScene(state_->scene);
    state_->scene = rtcNewScene(state_->device);
    const RTCGeometry mesh = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                             positions.size());
    std::copy(positions.begin(), positions.end(), static_cast<glm::vec3*>(vertices));
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(), 0,
                               sizeof(glm::uvec3), triangles.size());
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(state_->scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(state_->scene);
}

void embree_scene::visibility(std::span<const glm::vec3> points, glm::vec3 to_light, std::span<float> lit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    constexpr std::size_t lanes = 16;
    for (std::size_t first = 0; first < points.size(); first += lanes) {
        RTCRay16 rays;
        alignas(64) int valid[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            const glm::vec3 p = points[std::min(first + i, points.size() - 1)];
            valid[i] = first + i < points.size() ? -1 : 0;
            rays.org_x[i] = p.x, rays.org_y[i] = p.y, rays.org_z[i] = p.z;
            rays.dir_x[i] = to_light.x, rays.dir_y[i] = to_light.y, rays.dir_z[i] = to_light.z;
            rays.tnear[i] = 0.0f, rays.tfar[i] = std::numeric_limits<float>::infinity();
            rays.time[i] = 0.0f, rays.mask[i] = ~0u, rays.flags[i] = 0;
        }
        rtcOccluded16(valid, state_->scene, &context, &rays);
        for (std::size_t i = 0; i < lanes && first + i < points.size(); ++i)
            lit[first + i] = rays.tfar[i] < 0.0f ? 0.0f : 1.0f;
    }
}

}  // namespace peers
