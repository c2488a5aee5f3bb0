package org.selectiverenderer.runtime.render.draw;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.Surface;

/**
 * What the program of an author may ask for when a shape is drawn for an eye.
 *
 * @param toEye from the buffers' coordinates to the eye's
 * @param lights that are on and reach it, in the eye's coordinates
 * @param fog where the shape is
 */
record AuthorState(
    DrawItem item, Camera camera, Matrix4dc toEye, EyeLights.Packed lights, Fog fog) {

  Surface surface() {
    return item.surface();
  }

  /** The material of the back: that of the front unless it has its own. */
  Surface back() {
    Surface front = item.surface();
    return front.detail() != null && front.detail().back() != null ? front.detail().back() : front;
  }

  int lightCount() {
    return Math.min(AuthorValues.MOST_LIGHTS, lights.numbers().length / EyeLights.PER_LIGHT);
  }

  Matrix4dc projection() {
    return camera.projection();
  }

  Matrix4d normals() {
    return toEye.normal(new Matrix4d());
  }
}
