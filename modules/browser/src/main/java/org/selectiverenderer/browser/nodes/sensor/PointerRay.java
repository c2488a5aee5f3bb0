package org.selectiverenderer.browser.nodes.sensor;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The ray of the pointing device in the world, and the place of the sensor that receives it (X3D
 * 4.0, 20.2.1).
 *
 * @param origin the origin of the ray, in world coordinates
 * @param direction the direction of the ray, of any length but 0, in world coordinates
 * @param place the matrix from the sensor's local coordinates to the world
 */
public record PointerRay(Vector3dc origin, Vector3dc direction, Matrix4dc place) {
  public PointerRay {
    origin = new Vector3d(origin);
    direction = new Vector3d(direction);
    place = new Matrix4d(place);
  }
}
