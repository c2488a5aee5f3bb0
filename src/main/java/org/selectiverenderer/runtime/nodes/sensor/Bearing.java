package org.selectiverenderer.runtime.nodes.sensor;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Where the pointing device points: a ray in the world, and where the sensor stands that is told
 * (X3D 4.0, 20.2.1).
 *
 * @param origin of the ray, in the world
 * @param direction of the ray, of any length but 0, in the world
 * @param place from the sensor's local coordinates to the world
 */
public record Bearing(Vector3dc origin, Vector3dc direction, Matrix4dc place) {
  public Bearing {
    origin = new Vector3d(origin);
    direction = new Vector3d(direction);
    place = new Matrix4d(place);
  }
}
