package org.selectiverenderer.render.draw;

import java.util.Optional;
import org.selectiverenderer.browser.instance.Light;

/**
 * The light uniforms that custom shaders read: the members of GLSL 1.20's {@code gl_LightSource}
 * structure and of X_ITE's.
 */
final class BuiltInLightUniforms {
  private static final float[] NONE = new float[EyeSpaceLights.PER_LIGHT];

  private BuiltInLightUniforms() {}

  /** Reads one member of a light's structure. */
  interface Member {
    /**
     * @param all the packed lights, twenty numbers each, in the order of {@code light.glsl}
     * @param at the index of the light's first number
     */
    float[] of(float[] all, int at, Light.Kind kind);

    /**
     * Returns the member of the light of that index; of a dark light where there are fewer lights.
     */
    default float[] of(EyeSpaceLights.Packed lights, int index, int count) {
      if (index >= count) {
        return of(NONE, 0, Light.Kind.DIRECTIONAL);
      }
      Light.Kind kind =
          index < lights.counts().directional()
              ? Light.Kind.DIRECTIONAL
              : index < lights.counts().directional() + lights.counts().points()
                  ? Light.Kind.POINT
                  : Light.Kind.SPOT;
      return of(lights.numbers(), EyeSpaceLights.PER_LIGHT * index, kind);
    }
  }

  static Optional<Member> member(String name) {
    return Optional.ofNullable(
        switch (name) {
          case "ambient" -> (n, at, kind) -> color(n, at, n[at + 7]);
          case "diffuse", "specular" -> (n, at, kind) -> color(n, at, n[at + 15]);
          case "position" -> (n, at, kind) -> new float[] {n[at], n[at + 1], n[at + 2], n[at + 3]};
          case "halfVector" -> (n, at, kind) -> half(n, at);
          case "spotDirection", "direction" -> (n, at, kind) -> three(n, at + 12);
          case "spotExponent" -> (n, at, kind) -> new float[] {0};
          case "spotCutoff" ->
              (n, at, kind) ->
                  new float[] {kind == Light.Kind.SPOT ? (float) Math.toDegrees(n[at + 16]) : 180};
          case "spotCosCutoff" ->
              (n, at, kind) ->
                  new float[] {kind == Light.Kind.SPOT ? (float) Math.cos(n[at + 16]) : -1};
          case "constantAttenuation" ->
              (n, at, kind) -> new float[] {kind == Light.Kind.DIRECTIONAL ? 1 : n[at + 8]};
          case "linearAttenuation" -> (n, at, kind) -> new float[] {n[at + 9]};
          case "quadraticAttenuation" -> (n, at, kind) -> new float[] {n[at + 10]};
          case "type" -> (n, at, kind) -> new float[] {n == NONE ? 0 : 1 + kind.ordinal()};
          case "color" -> (n, at, kind) -> three(n, at + 4);
          case "intensity" -> (n, at, kind) -> new float[] {n[at + 15]};
          case "ambientIntensity" -> (n, at, kind) -> new float[] {n[at + 7]};
          case "attenuation" ->
              (n, at, kind) ->
                  kind == Light.Kind.DIRECTIONAL ? new float[] {1, 0, 0} : three(n, at + 8);
          case "location" -> (n, at, kind) -> three(n, at);
          case "radius" ->
              (n, at, kind) -> new float[] {kind == Light.Kind.DIRECTIONAL ? -1 : n[at + 11]};
          case "cutOffAngle" -> (n, at, kind) -> new float[] {n[at + 16]};
          case "beamWidth" ->
              (n, at, kind) ->
                  new float[] {n[at + 17] == 0 ? n[at + 16] : n[at + 16] + 1 / n[at + 17]};
          case "matrix" -> (n, at, kind) -> new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
          default -> null;
        });
  }

  private static float[] color(float[] n, int at, float factor) {
    return new float[] {n[at + 4] * factor, n[at + 5] * factor, n[at + 6] * factor, 1};
  }

  private static float[] three(float[] n, int at) {
    return new float[] {n[at], n[at + 1], n[at + 2]};
  }

  /**
   * Returns the half vector between the light and the eye, which OpenGL takes as infinitely far
   * along the Z axis (GLSL 1.20, 7.5).
   */
  private static float[] half(float[] n, int at) {
    double length = Math.sqrt(n[at] * n[at] + n[at + 1] * n[at + 1] + n[at + 2] * n[at + 2]);
    double scale = length == 0 ? 0 : 1 / length;
    double x = n[at] * scale;
    double y = n[at + 1] * scale;
    double z = n[at + 2] * scale + 1;
    double h = Math.sqrt(x * x + y * y + z * z);
    return h == 0
        ? new float[] {0, 0, 1, 0}
        : new float[] {(float) (x / h), (float) (y / h), (float) (z / h), 0};
  }
}
