package org.selectiverenderer.browser.instance;

/**
 * The field values of a light node, in its local coordinates (X3D 4.0, 17.4).
 *
 * @param intensity the intensity, 0..1 and above
 * @param location the position of a point or spot light
 * @param direction the direction of a directional or spot light
 * @param attenuation the attenuation coefficients: constant, linear, quadratic
 * @param radius the distance beyond which a point or spot light does not reach
 * @param beamWidth the angle, in radians, within which a spot light has its full intensity
 * @param cutOffAngle the angle, in radians, outside which a spot light gives no light
 * @param global whether the light reaches the whole scene, or only its parent group
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
