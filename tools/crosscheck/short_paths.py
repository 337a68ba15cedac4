# SPDX-License-Identifier: GPL-2.0-or-later
"""Vigil's paths for what Mitsuba's own `path` cannot be told: gloss at the first hit alone, surfaces that let through a
share of the rays from the front and all from behind, faces that are a window to the sky whatever lies behind them, and a sun too
small for a panorama. Rays, textures, emitters, their sampling and the microfacet distribution are Mitsuba's; the choice between light and BRDF
samples is by multiple importance sampling, which Vigil does not do. Needs a vectorised variant."""

import drjit as dr
import mitsuba as mi
import numpy as np

# Most translucent layers that one ray may cross.
LAYERS = 64
# How far in front of a lamp something must be to shadow it: relative to the distance, and in map units.
SHADOW_GAP = (1e-4, 2e-3)


# Share of light samples that go to the sky where there are lamps too, and of those to lamps that are drawn by power alone.
SKY_SHARE = 0.3
POWER_SHARE = 0.2


class Tracer:
    """Paths in one scene. `exported`: what gltf_scene read; `materials`: per shape name, from mitsuba_scene.build."""

    def __init__(self, scene, exported, materials):
        self.scene = scene
        self.sky = scene.environment()
        self.sun = Sun(exported) if exported.sun_irradiance is not None else None
        # Tables by the number that a shape pointer holds.
        shapes = scene.shapes()
        numbers = [int(dr.reinterpret_array(mi.UInt32, mi.ShapePtr(shape))[0]) for shape in shapes]
        number_of = dict(zip((shape.id() for shape in shapes), numbers))
        size = max(numbers) + 1
        table = {key: np.full(size, value, np.float32)
                 for key, value in (("coverage", 1), ("f0", 0), ("alpha", 1), ("window", 0))}
        for name, material in materials.items():
            number = number_of[name]
            if material is None:
                table["window"][number] = 1
                continue
            table["coverage"][number] = material.coverage
            table["f0"][number] = material.f0
            table["alpha"][number] = max(material.roughness**2, 0.01)
        self.translucent = bool((table["coverage"] < 1).any())
        self.windows = bool(table["window"].any())
        self.glossy = bool((table["f0"] > 0).any())
        self.table = {key: mi.Float(values) for key, values in table.items()}
        self.collect_lamps(exported, number_of, size)

    def collect_lamps(self, exported, number_of, size):
        """All emissive triangles in one list; `first_lamp` leads there from a shape's number."""
        first, corners, radiances, coverages = np.zeros(size, np.uint32), [], [], []
        for index, surface in enumerate(exported.surfaces):
            if surface.material.radiance.any():
                first[number_of[f"surface{index}"]] = sum(map(len, corners))
                corners.append(surface.corners)
                coverages.append(np.full(len(surface.corners), surface.material.coverage))
                radiances.append(np.broadcast_to(surface.material.radiance, (len(surface.corners), 3)))
        self.first_lamp, self.lamp_count = mi.UInt32(first), sum(map(len, corners))
        self.sky_share = 0.0 if self.sky is None else SKY_SHARE if self.lamp_count else 1.0
        self.found = None
        if not self.lamp_count:
            return
        corners = np.concatenate(corners)
        edges = corners[:, 1:] - corners[:, :1]
        normals = np.cross(edges[:, 0], edges[:, 1])
        double_area = np.linalg.norm(normals, axis=1)
        self.lamp_corner = mi.Vector3f(corners[:, 0].T)
        self.lamp_edges = [mi.Vector3f(edges[:, i].T) for i in range(2)]
        self.lamp_normal = mi.Vector3f((normals / np.maximum(double_area, 1e-30)[:, None]).T)
        self.lamp_area = mi.Float(double_area / 2)
        self.lamp_coverage = mi.Float(np.concatenate(coverages))
        self.lamp_radiance = mi.Color3f(np.concatenate(radiances).T)
        power = double_area * np.concatenate(radiances).mean(1)
        self.power = power / power.sum()
        self.draw_lamps(self.power)

    def draw_lamps(self, chances):
        self.chances = mi.DiscreteDistribution(mi.Float(chances))

    def learn_lamps(self, sensor, width, height, spp):
        """Draws lamps by what they were seen to contribute: an extra picture with a seed of its own, thrown away."""
        if not self.lamp_count:
            return
        self.found = dr.zeros(mi.Float, self.lamp_count)
        self.picture(sensor, width, height, spp, 999983)
        found = np.array(self.found, dtype=np.float64)
        self.found = None
        if found.sum() > 0:
            self.draw_lamps(POWER_SHARE * self.power + (1 - POWER_SHARE) * found / found.sum())

    def of(self, key, si, active):
        return dr.gather(mi.Float, self.table[key], dr.reinterpret_array(mi.UInt32, si.shape), active)

    def stop(self, ray, sampler, active):
        """The surface that stops each ray, and whether it is the sky (a window to it, or nothing at all)."""
        si = self.scene.ray_intersect(ray, active)
        distance = mi.Float(si.t)
        if self.translucent:
            travelled = mi.Float(0)
            passes = active
            for _ in range(LAYERS):
                hit = passes & si.is_valid()  # what has stopped a ray does so for good
                coverage = dr.select(si.wi.z > 0, self.of("coverage", si, hit), 0)
                opaque = self.of("coverage", si, hit) >= 1
                passes = hit & ~opaque & (sampler.next_1d() >= coverage)
                dr.eval(passes, si, travelled)
                if not dr.any(passes):
                    break
                travelled = dr.select(passes, travelled + si.t, travelled)
                si[passes] = self.scene.ray_intersect(si.spawn_ray(ray.d), passes)
            else:
                raise RuntimeError(f"a ray crosses more than {LAYERS} translucent layers")
            distance = travelled + si.t
        sky = active & ~si.is_valid()
        if self.windows:
            sky |= active & si.is_valid() & (self.of("window", si, active & si.is_valid()) > 0)
        return si, distance, sky

    def sky_radiance(self, direction, active):
        if self.sky is None:
            return mi.Color3f(0)
        si = dr.zeros(mi.SurfaceInteraction3f, dr.width(direction))
        si.wi = -direction
        return self.sky.eval(si, active)

    def lamp_pdf(self, lamp, offset, active):
        """Density per steradian with which `lit_by_lights` draws a point of a lamp, seen along `offset`."""
        normal, area = dr.gather(mi.Vector3f, self.lamp_normal, lamp, active), dr.gather(mi.Float, self.lamp_area, lamp, active)
        distance = dr.norm(offset)
        cosine = -dr.dot(normal, offset) / distance
        chance = (1 - self.sky_share) * self.chances.eval_pmf_normalized(lamp, active)
        return dr.select(active & (cosine > 0) & (area > 0), chance * distance**2 / (cosine * area), 0)

    def emitted(self, si, sky, ray, ref, brdf_pdf, active):
        """Radiance that a ray found, weighted against light sampling at `ref` (None: not sampled there)."""
        found = active & ~sky & si.is_valid()
        lamp = found & (si.emitter(self.scene) != None)  # noqa: E711 (an array of pointers)
        value = dr.select(lamp, si.emitter(self.scene).eval(si, lamp), 0)
        value = dr.select(sky, self.sky_radiance(ray.d, sky), value)
        shines, sun_share = mi.Bool(False), mi.Float(1)
        if self.sun is not None:
            shines = active & sky & self.sun.in_disc(ray.d)
            if ref is not None:
                sun_share = brdf_pdf / (brdf_pdf + self.sun.pdf)
        sun = dr.select(shines, sun_share * self.sun.radiance, 0) if self.sun is not None else mi.Color3f(0)
        if ref is None:
            return dr.select(active, value, 0) + sun
        pdf = mi.Float(0)
        if self.lamp_count:
            index = dr.gather(mi.UInt32, self.first_lamp, dr.reinterpret_array(mi.UInt32, si.shape), lamp) + si.prim_index
            pdf = self.lamp_pdf(dr.select(lamp, index, 0), si.p - ref.p, lamp)
        if self.sky is not None:
            ds = dr.zeros(mi.DirectionSample3f, dr.width(ray.d))
            ds.d = ray.d
            pdf = dr.select(sky, self.sky_share * self.sky.pdf_direction(ref, ds, sky), pdf)
        return dr.select(active & (brdf_pdf > 0), value * brdf_pdf / (brdf_pdf + pdf) + sun, 0)

    def lit_by_sun(self, si, brdf, sampler, throughput, active):
        """Next event estimation of the sun, one ray more: a point of it from anywhere on its disc."""
        if self.sun is None:
            return mi.Color3f(0)
        direction = self.sun.direction_at(sampler.next_2d())
        value, brdf_pdf = brdf.evaluate(si.to_local(direction), active)
        active = active & (dr.max(value) > 0)
        _, _, sky = self.stop(si.spawn_ray(direction), sampler, active)
        share = 1 / (1 + brdf_pdf * self.sun.solid_angle)  # against rays that meet the disc
        return throughput * dr.select(active & sky, value * self.sun.flux * share, 0)

    def lit_by_lights(self, si, brdf, sampler, throughput, active):
        """Next event estimation: the sky or a lamp, one point, one ray."""
        if not self.lamp_count and self.sky is None:
            return mi.Color3f(0)
        choice, place = sampler.next_2d(), sampler.next_2d()
        endless, lamp = choice.y < self.sky_share, mi.UInt32(0)
        direction, far, pdf, radiance = mi.Vector3f(0, 0, 1), mi.Float(0), mi.Float(0), mi.Color3f(0)
        if self.sky is not None:
            ds, weight = self.sky.sample_direction(si, place, active & endless)
            direction, pdf = mi.Vector3f(ds.d), self.sky_share * ds.pdf
            radiance = mi.Color3f(weight) * ds.pdf
        if self.lamp_count:
            near = active & ~endless
            lamp = self.chances.sample(choice.x, near)
            bary = mi.warp.square_to_uniform_triangle(place)
            point = dr.gather(mi.Vector3f, self.lamp_corner, lamp, near)
            for weight, edge in zip((bary.x, bary.y), self.lamp_edges):
                point += weight * dr.gather(mi.Vector3f, edge, lamp, near)
            direction = dr.select(endless, direction, dr.normalize(point - si.p))
            pdf = dr.select(endless, pdf, self.lamp_pdf(lamp, point - si.p, near))
            radiance = dr.select(endless, radiance, dr.gather(mi.Color3f, self.lamp_radiance, lamp, near))
        value, brdf_pdf = brdf.evaluate(si.to_local(direction), active & (pdf > 0))
        active = active & (pdf > 0) & (dr.max(value) > 0)
        ray = si.spawn_ray(direction)
        if self.lamp_count:  # the ray starts a little off the surface: aim anew
            far = dr.norm(point - ray.o)
            ray.d = dr.select(endless, ray.d, (point - ray.o) / far)
        _, distance, sky = self.stop(ray, sampler, active)
        seen = dr.select(endless, sky, distance > far * (1 - SHADOW_GAP[0]) - SHADOW_GAP[1])
        if self.translucent and self.lamp_count:
            seen &= endless | (sampler.next_1d() < dr.gather(mi.Float, self.lamp_coverage, lamp, active & ~endless))
        result = throughput * dr.select(active & seen, value * radiance / (pdf + brdf_pdf), 0)
        if self.found is not None:
            dr.scatter_add(self.found, dr.mean(result), lamp, active & ~endless)
        return result

    def radiance(self, ray, sampler):
        """One path per ray: light at the camera's hit and at the next one; the sky one ray further, as lamps."""
        si, _, sky = self.stop(ray, sampler, mi.Bool(True))
        result = self.emitted(si, sky, ray, None, None, mi.Bool(True))
        throughput, active = mi.Color3f(1), mi.Bool(True)
        for bounce in range(2):
            active = active & ~sky & si.is_valid() & (si.wi.z > 0)
            albedo = si.bsdf().eval_diffuse_reflectance(si, active)
            if bounce == 0 and self.glossy:
                brdf = CoatedBrdf(albedo, si.wi, self.of("f0", si, active), self.of("alpha", si, active))
            else:
                brdf = LambertianBrdf(albedo)
            result += self.lit_by_lights(si, brdf, sampler, throughput, active)
            result += self.lit_by_sun(si, brdf, sampler, throughput, active)
            local = brdf.sample(sampler)
            value, pdf = brdf.evaluate(local, active)
            active = active & (pdf > 0)
            throughput *= dr.select(active, value / dr.maximum(pdf, 1e-20), 0)
            ref, ray = si, si.spawn_ray(si.to_world(local))
            si, _, sky = self.stop(ray, sampler, active)
            result += throughput * self.emitted(si, sky, ray, ref, pdf, active)
        return result

    def picture(self, sensor, width, height, spp, seed):
        """Mean radiance (height, width, 3) of spp paths per pixel, spread evenly over each."""
        sampler = mi.load_dict({"type": "independent", "sample_count": spp})
        sampler.seed(seed, width * height * spp)
        pixel = dr.arange(mi.UInt32, width * height * spp) // spp
        inside = sampler.next_2d()
        film = mi.Point2f((pixel % width + inside.x) / width, (pixel // width + inside.y) / height)
        ray, _ = sensor.sample_ray(0.0, 0.5, film, mi.Point2f(0.5))
        value = self.radiance(mi.Ray3f(ray.o, ray.d), sampler)
        columns = np.array(value).reshape(3, -1) if np.array(value).shape[0] == 3 else np.array(value).T
        return columns.reshape(3, height, width, spp).astype(np.float64).mean(-1).transpose(1, 2, 0)


class Sun:
    """A cone of directions, evenly bright; with an angle of 0 it is a direction, which no ray meets."""

    def __init__(self, exported):
        half = np.radians(exported.sun_diameter) / 2
        towards = np.asarray(exported.sun_direction, float)
        self.towards = mi.Vector3f(list(map(float, towards)))
        self.frame = mi.Frame3f(self.towards)
        self.height = float(2 * np.sin(half / 2)**2)  # of the cap: 1 - cos
        self.solid_angle = 2 * np.pi * self.height
        # A disc of radiance L lights a surface that faces it with pi sin(half)^2 L.
        irradiance = np.asarray(exported.sun_irradiance, float)
        self.flux = mi.Color3f(list(map(float, irradiance * 2 / (1 + np.cos(half)))))
        self.pdf = 1 / self.solid_angle if half > 0 else 0.0
        self.radiance = self.flux * self.pdf

    def in_disc(self, direction):
        """By the chord: the cosine of a small angle has no digits left."""
        return dr.squared_norm(direction - self.towards) < 2 * self.height

    def direction_at(self, place):
        fall, turn = place.x * self.height, 2 * dr.pi * place.y
        out = dr.sqrt(fall * (2 - fall))
        return dr.normalize(self.frame.to_world(mi.Vector3f(out * dr.cos(turn), out * dr.sin(turn), 1 - fall)))


class LambertianBrdf:
    def __init__(self, albedo):
        self.albedo = albedo

    def evaluate(self, light, active):
        """BRDF * cosine, and the density with which `sample` draws `light`."""
        cosine = dr.select(active, dr.maximum(light.z, 0) / dr.pi, 0)
        return self.albedo * cosine, cosine

    def sample(self, sampler):
        return mi.warp.square_to_cosine_hemisphere(sampler.next_2d())


class CoatedBrdf:
    """docs/internals/export.md, "Surfaces": a Lambertian base under GGX with Schlick's Fresnel and height-correlated masking."""

    def __init__(self, albedo, view, f0, alpha):
        self.albedo, self.view, self.f0, self.alpha = albedo, view, f0, alpha
        self.facets = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, alpha, True)
        self.share = dr.select(f0 > 0, 0.5, 0)  # of samples drawn from the coat

    @staticmethod
    def grazing(cosine):
        return dr.clip(1 - cosine, 0, 1)**5

    def evaluate(self, light, active):
        view, above = self.view, active & (light.z > 0) & (self.view.z > 0)
        coated = above & (self.f0 > 0)
        half = dr.normalize(view + light)
        fresnel = self.f0 + (1 - self.f0) * self.grazing(dr.dot(view, half))
        masking_view = self.facets.smith_g1(view, mi.Vector3f(0, 0, 1))
        masking_light = self.facets.smith_g1(light, mi.Vector3f(0, 0, 1))
        masking = 1 / (1 / masking_view + 1 / masking_light - 1)
        coat = fresnel * self.facets.eval(half) * masking / (4 * view.z)
        s = 1 / (1 + 12 * self.alpha**2)
        under = (0.994 / (1 - s / 21) * (1 - self.f0) * (1 - s * self.grazing(view.z)) *
                 (1 - s * self.grazing(light.z)))
        diffuse = light.z / dr.pi
        value = self.albedo * diffuse * dr.select(coated, under, 1) + dr.select(coated, coat, 0)
        facet_pdf = self.facets.pdf(view, half) / (4 * dr.dot(view, half))
        pdf = dr.select(coated, dr.lerp(diffuse, facet_pdf, self.share), diffuse)
        return dr.select(above, value, 0), dr.select(above, pdf, 0)

    def sample(self, sampler):
        base = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
        facet, _ = self.facets.sample(self.view, sampler.next_2d())
        mirrored = 2 * dr.dot(self.view, facet) * facet - self.view
        return dr.select(sampler.next_1d() < self.share, mirrored, base)
