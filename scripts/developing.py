"""Cycles' pictures without its grain, within Blender: Debian's has no denoiser. For scripts that draw documents."""

import tempfile

import bpy
import numpy


def developed(scene, samples, picture):
    """Renders a scene by Cycles with so many samples a pixel, and saves it as a .png or .jpg, in the scene's size and
    tones."""
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = samples // 2, False, False
    scene.cycles.sample_clamp_indirect, scene.cycles.max_bounces = 3, 8
    scene.view_layers[0].cycles.denoising_store_passes = True
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    layers, files = nodes.new("CompositorNodeRLayers"), nodes.new("CompositorNodeOutputFile")
    files.format.file_format, files.format.color_depth = "OPEN_EXR", "32"
    files.file_slots.clear()
    for name, of in (("light", "Image"), ("albedo", "Denoising Albedo"), ("normal", "Denoising Normal")):
        files.file_slots.new(name)
        links.new(layers.outputs[of], files.inputs[name])
    with tempfile.TemporaryDirectory() as folder:
        files.base_path = folder
        pixels = without_grain(exposed(scene, 0, folder), exposed(scene, 1, folder))
    height, width, _ = pixels.shape
    image = bpy.data.images.new("developed", width, height, float_buffer=True)
    image.pixels = numpy.dstack([pixels, numpy.ones((height, width), numpy.float32)]).astype(numpy.float32).ravel()
    scene.render.image_settings.file_format = "JPEG" if picture.endswith(".jpg") else "PNG"
    scene.render.image_settings.quality = 92
    image.save_render(picture, scene=scene)


def exposed(scene, seed, folder):
    """One exposure with half of the samples: light, base colour and normals of all pixels, each height x width x 3,
    linear."""
    scene.cycles.seed = seed
    bpy.ops.render.render()
    layers = {}
    for name in ("light", "albedo", "normal"):
        image = bpy.data.images.load(f"{folder}/{name}0001.exr")
        pixels = numpy.array(image.pixels[:], numpy.float32).reshape(image.size[1], image.size[0], 4)
        layers[name] = pixels[:, :, :3]
        bpy.data.images.remove(image)
    return layers


def box_mean(values, radius):
    """Over squares of 2 radius + 1 pixels."""
    for axis in (0, 1):
        count = values.shape[axis]
        padding = [(radius + 1, radius) if k == axis else (0, 0) for k in range(values.ndim)]
        sums = numpy.cumsum(numpy.pad(values, padding, mode="edge"), axis=axis, dtype=numpy.float64)
        upper, lower = numpy.arange(2 * radius + 1, 2 * radius + 1 + count), numpy.arange(count)
        values = ((sums.take(upper, axis) - sums.take(lower, axis)) / (2 * radius + 1)).astype(numpy.float32)
    return values


def without_grain(first, second):
    """The mean of two exposures without the path tracer's grain: means of like neighbourhoods, whose likeness is
    judged on the one exposure and applied to the other [Rousselle et al. 2012]. Debian's Blender has no denoiser."""
    albedo = 0.5 * (first["albedo"] + second["albedo"]) + 0.03
    normal = 0.5 * (first["normal"] + second["normal"])
    one, two = (numpy.log1p(exposure["light"] / (exposure["albedo"] + 0.03)) for exposure in (first, second))
    spread = box_mean(0.5 * (one - two) ** 2, 2) + 1e-6
    sums, weights = [numpy.zeros_like(one), numpy.zeros_like(two)], [numpy.zeros(one.shape[:2] + (1,))] * 2
    reach, patch = 5, 2
    ways = [(down, right) for down in range(-reach, reach + 1) for right in range(-reach, reach + 1)]
    for way in ways:
        there = numpy.roll(spread, way, (0, 1))
        apart = ((normal - numpy.roll(normal, way, (0, 1))) ** 2).sum(2) / 0.05
        for k, (judged, used) in enumerate(((one, two), (two, one))):
            noise = spread + numpy.minimum(spread, there)
            unlike = ((judged - numpy.roll(judged, way, (0, 1))) ** 2 - noise) / (1e-6 + 0.45 * (spread + there))
            unlike = box_mean(unlike, patch).mean(2)
            weight = numpy.exp(-numpy.maximum(unlike, 0) - apart)[:, :, None]
            sums[k] = sums[k] + weight * numpy.roll(used, way, (0, 1))
            weights[k] = weights[k] + weight
    light = 0.5 * sum(total / weight for total, weight in zip(sums, weights))
    return numpy.expm1(light) * albedo
