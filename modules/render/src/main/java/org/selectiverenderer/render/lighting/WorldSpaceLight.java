package org.selectiverenderer.render.lighting;

import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;

/**
 * A light in the world's coordinates and units, with the values of the X3D lighting model.
 *
 * @param position the position of point and spot lights
 * @param axis the direction of directional and spot lights, a unit vector, or zero if none is given
 * @param color r, g, b
 * @param constant the constant term of the attenuation; {@code linear} per unit, {@code quadratic}
 *     per square unit
 * @param radius the distance beyond which a point or spot light does not reach
 * @param beamWidth the angle in radians within which a spot light has full intensity; less than
 *     {@code cutOff}
 * @param cutOff the angle in radians outside of which a spot light is dark; infinite for a point
 *     light
 */
public record WorldSpaceLight(
    Light.Kind kind,
    Vector3dc position,
    Vector3dc axis,
    Vector3dc color,
    double intensity,
    double ambientIntensity,
    double constant,
    double linear,
    double quadratic,
    double radius,
    double beamWidth,
    double cutOff) {
  /** The least width of a beam's edge in radians, because a sharp edge has no finite slope. */
  private static final double NARROWEST_EDGE = 1e-4;

  /** Returns a light node's light at its present place. */
  public static WorldSpaceLight of(LightInstance instance) {
    Light light = instance.light();
    Matrix4dc world = instance.world();
    // Distances count in the light's own coordinates (X3D 4.0, 17.2.2): taken to the world's here.
    double scale = Math.cbrt(Math.abs(world.determinant3x3()));
    double unit = scale > 0 ? scale : 1;
    Vector3d axis = world.transformDirection(vector(light.direction()));
    if (axis.lengthSquared() > 0) {
      axis.normalize();
    }
    boolean spot = light.kind() == Light.Kind.SPOT;
    double cutOff = spot ? light.cutOffAngle() : Double.POSITIVE_INFINITY;
    float[] fall = light.attenuation();
    return new WorldSpaceLight(
        light.kind(),
        world.transformPosition(vector(light.location())),
        axis,
        vector(light.color()),
        light.intensity(),
        light.ambientIntensity(),
        fall[0],
        fall[1] / unit,
        fall[2] / (unit * unit),
        light.radius() * unit,
        spot ? Math.min(light.beamWidth(), cutOff - NARROWEST_EDGE) : Double.POSITIVE_INFINITY,
        cutOff);
  }

  /** Returns whether the light has a position: a point or spot light. */
  public boolean positional() {
    return kind != Light.Kind.DIRECTIONAL;
  }

  private static Vector3d vector(float[] v) {
    return new Vector3d(v[0], v[1], v[2]);
  }
}
