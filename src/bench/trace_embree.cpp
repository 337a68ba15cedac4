// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/trace_embree.h"

#include "common/error.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

#if VIGIL_HAVE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace vigil::bench {

struct EmbreeTracer::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    ~State() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
};

namespace {

/// Embree asks for denormals to be flushed while it traces.
class FlushDenormals {
public:
    FlushDenormals() : saved_(_mm_getcsr()) {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~FlushDenormals() { _mm_setcsr(saved_); }

private:
    unsigned saved_;
};

RTCRay embree_ray(const shader::Ray& ray) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.tnear = ray.t_min;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.tfar = ray.t_max;
    result.mask = ~0u;
    return result;
}

/// One thread's calls, which Embree 3 gives a context and Embree 4 does not.
class Caller {
public:
#if VIGIL_HAVE_EMBREE >= 4
    void intersect(RTCScene scene, RTCRayHit& query) {
        rtcIntersect1(scene, &query);
    }
    void occlude(RTCScene scene, RTCRay& query) {
        rtcOccluded1(scene, &query);
    }
#else
    Caller() {
        rtcInitIntersectContext(&context_);
    }
    void intersect(RTCScene scene, RTCRayHit& query) {
        rtcIntersect1(scene, &context_, &query);
    }
    void occlude(RTCScene scene, RTCRay& query) {
        rtcOccluded1(scene, &context_, &query);
    }

private:
    RTCIntersectContext context_;
#endif
};

} // namespace

EmbreeTracer::EmbreeTracer(std::span<const BvhInputTriangle> triangles)
    : state_(std::make_unique<State>()) {
    state_->device = rtcNewDevice("threads=1");
    if (!state_->device) fail("Embree: no device");
    state_->scene = rtcNewScene(state_->device);
    RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), triangles.size()));
    if (!vertices || !indices) fail("Embree: out of memory");
    for (const BvhInputTriangle& triangle : triangles) {
        for (const glm::vec3& vertex : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int axis = 0; axis < 3; ++axis)
                *vertices++ = vertex[axis];
        }
    }
    for (std::uint32_t i = 0; i < 3 * triangles.size(); ++i)
        indices[i] = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(state_->scene, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(state_->scene);
    if (rtcGetDeviceError(state_->device) != RTC_ERROR_NONE) fail("Embree: the build failed");
}

EmbreeTracer::~EmbreeTracer() = default;

void EmbreeTracer::closest(std::span<const shader::Ray> rays, std::vector<float>& distances) const {
    const FlushDenormals flush;
    Caller caller;
    distances.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRayHit query{embree_ray(rays[i]), {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        caller.intersect(state_->scene, query);
        distances[i] = query.ray.tfar;
    }
}

void EmbreeTracer::occluded(std::span<const shader::Ray> rays,
                            std::vector<std::uint32_t>& answers) const {
    const FlushDenormals flush;
    Caller caller;
    answers.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRay query = embree_ray(rays[i]);
        caller.occlude(state_->scene, query);
        answers[i] = query.tfar < 0.0f ? 1 : 0; // Embree sets it to -infinity
    }
}

} // namespace vigil::bench
