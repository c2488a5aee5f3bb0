package org.selectiverenderer.render.draw;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.SurfaceMaterial;

/**
 * The state from which the built-in uniforms of a custom shader are computed, for one shape and one
 * eye.
 *
 * @param toEye the model-view matrix, from the coordinates in the buffers to the eye's
 * @param lights the lights that are on and reach the shape, in the eye's coordinates
 * @param fog the fog at the shape
 */
record UniformContext(
    DrawItem item, Camera camera, Matrix4dc toEye, EyeSpaceLights.Packed lights, Fog fog) {

  SurfaceMaterial surface() {
    return item.surface();
  }

  /** Returns the back material: the front one unless the surface has its own. */
  SurfaceMaterial back() {
    SurfaceMaterial front = item.surface();
    return front.detail() != null && front.detail().back() != null ? front.detail().back() : front;
  }

  int lightCount() {
    return Math.min(
        BuiltInUniforms.MOST_LIGHTS, lights.numbers().length / EyeSpaceLights.PER_LIGHT);
  }

  Matrix4dc projection() {
    return camera.projection();
  }

  Matrix4d normals() {
    return toEye.normal(new Matrix4d());
  }
}
