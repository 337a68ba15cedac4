// SPDX-License-Identifier: GPL-2.0-or-later
// The same text on the GPU: importances and random words equal the host's, under validation.
#include "gpu/validated.h"
#include "importance_gpu.h"
#include "shared/random.h"

#include <gtest/gtest.h>

namespace vigil::test {
namespace {

using namespace shader;

class ImportanceGpuTest : public testing::Test {
protected:
    ImportanceGpuTest() : device_(test::validated(), nullptr) {}
    ~ImportanceGpuTest() override { EXPECT_EQ(device_.validation_messages(), 0); }
    void expect_equal(bool glossy) {
        const ImportanceScene scene = make_importance_scene(4096, 500, glossy);
        ImportanceGpu gpu(device_, scene);
        const std::vector<float> got = gpu.answers(glossy ? IMPORTANCE_GLOSSY : IMPORTANCE_SHIPPED);
        int positive = 0;
        for (size_t i = 0; i < scene.queries.size(); ++i) {
            const LtcSurface surface = prepare_query(scene.queries[i], glossy);
            for (uint32_t k = 0; k < scene.lights_per_query; ++k) {
                const float host = ltc_importance(surface, scene.light(i, k), glossy);
                const float device = got[i * scene.lights_per_query + k];
                // Compilers contract and reorder differently: digits may differ, the decision "can
                // it shine?" may not, except at the very horizon.
                ASSERT_NEAR(device, host, 2e-3f * host + 1e-5f) << i << ' ' << k;
                if (host > 1e-6f) {
                    ASSERT_GT(device, 0.0f) << i << ' ' << k;
                }
                positive += host > 0.0f ? 1 : 0;
            }
        }
        EXPECT_GT(positive, 10000);
    }

    gpu::Device device_;
};

TEST_F(ImportanceGpuTest, DiffuseImportanceEqualsTheHosts) {
    expect_equal(false);
}

TEST_F(ImportanceGpuTest, GlossyImportanceEqualsTheHosts) {
    expect_equal(true);
}

TEST_F(ImportanceGpuTest, RandomWordsEqualTheHosts) {
    const ImportanceScene scene = make_importance_scene(4096, 10, false);
    ImportanceGpu gpu(device_, scene);
    const std::vector<glm::uvec3> words = gpu.random_words();
    for (uint32_t i = 0; i < words.size(); ++i) {
        Random random = random_begin(uvec2(i, 5), 6, 7);
        random_next(random);
        ASSERT_EQ(words[i], random_next_words(random)) << i;
    }
}

} // namespace
} // namespace vigil::test
