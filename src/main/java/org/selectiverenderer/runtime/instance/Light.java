package org.selectiverenderer.runtime.instance;

/**
 * The fields of a light node, in its local coordinates (X3D 4.0, 17.4).
 *
 * @param intensity 0..1 and above
 * @param location of point and spot lights
 * @param direction of directional and spot lights
 * @param attenuation constant, linear, quadratic
 * @param radius beyond which a point or spot light does not reach
 * @param beamWidth radians, full intensity within
 * @param cutOffAngle radians, dark outside
 * @param global whether it lights the whole scene, or only its parent group
 */
public record Light(
    Kind kind,
    boolean on,
    float[] color,
    float intensity,
    float ambientIntensity,
    float[] location,
    float[] direction,
    float[] attenuation,
    float radius,
    float beamWidth,
    float cutOffAngle,
    boolean global) {

  public enum Kind {
    DIRECTIONAL,
    POINT,
    SPOT
  }
}
