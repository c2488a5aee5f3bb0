package org.selectiverenderer.render.draw;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.render.gpu.LightCounts;
import org.selectiverenderer.render.gpu.ShapeProgram;
import org.selectiverenderer.render.lighting.WorldSpaceLight;

/** The lights of one eye's frame, packed for the shaders in that eye's coordinates. */
final class EyeSpaceLights {
  static final int PER_LIGHT = 20;

  /**
   * @param numbers twenty numbers per light
   * @param counts the number of lights of each kind, at most {@link ShapeProgram#MAX_LIGHTS}
   *     together
   */
  record Packed(float[] numbers, LightCounts counts) {}

  private record One(Light.Kind kind, float[] numbers) {}

  private final Camera camera;
  private final @Nullable Camera bearer;
  private final Map<List<LightInstance>, Packed> packed = new IdentityHashMap<>();

  /**
   * @param bearer the camera that carries the headlight, mostly {@code camera} itself; null for no
   *     headlight
   */
  EyeSpaceLights(Camera camera, @Nullable Camera bearer) {
    this.camera = camera;
    this.bearer = bearer;
  }

  /**
   * Returns the lights that are on, sorted by kind; within a kind the headlight first, then the
   * order of the scene.
   *
   * @param reaching the lights that reach a shape; the list is compared by identity
   */
  Packed of(List<LightInstance> reaching) {
    return packed.computeIfAbsent(reaching, this::pack);
  }

  private Packed pack(List<LightInstance> reaching) {
    List<One> lights = new ArrayList<>();
    if (bearer != null) {
      // X3D 4.0, 23.4.4: a white directional light along the bearer's line of sight.
      Vector3d from = new Vector3d(0, 0, 1);
      if (bearer != camera) {
        bearer.view().invertAffine(new Matrix4d()).transformDirection(from);
        camera.view().transformDirection(from).normalize();
      }
      float[] out = new float[PER_LIGHT];
      put(out, 0, from.x, from.y, from.z, 0);
      put(out, 4, 1, 1, 1, 0);
      put(out, 12, -from.x, -from.y, -from.z, 1);
      lights.add(new One(Light.Kind.DIRECTIONAL, out));
    }
    for (LightInstance light : reaching) {
      if (light.on() && lights.size() < ShapeProgram.MAX_LIGHTS) {
        lights.add(new One(light.light().kind(), numbers(WorldSpaceLight.of(light))));
      }
    }
    lights.sort(Comparator.comparing(One::kind));
    float[] numbers = new float[PER_LIGHT * lights.size()];
    for (int i = 0; i < lights.size(); i++) {
      System.arraycopy(lights.get(i).numbers(), 0, numbers, PER_LIGHT * i, PER_LIGHT);
    }
    return new Packed(
        numbers,
        new LightCounts(
            count(lights, Light.Kind.DIRECTIONAL),
            count(lights, Light.Kind.POINT),
            count(lights, Light.Kind.SPOT)));
  }

  private static int count(List<One> lights, Light.Kind kind) {
    return (int) lights.stream().filter(light -> light.kind() == kind).count();
  }

  private float[] numbers(WorldSpaceLight light) {
    Vector3d axis = camera.view().transformDirection(light.axis(), new Vector3d());
    float[] out = new float[PER_LIGHT];
    if (light.positional()) {
      Vector3d at = camera.view().transformPosition(light.position(), new Vector3d());
      put(out, 0, at.x, at.y, at.z, 1);
    } else {
      put(out, 0, -axis.x, -axis.y, -axis.z, 0);
    }
    put(out, 4, light.color().x(), light.color().y(), light.color().z(), light.ambientIntensity());
    put(
        out,
        8,
        light.constant(),
        light.linear(),
        light.quadratic(),
        Math.min(light.radius(), Float.MAX_VALUE));
    put(out, 12, axis.x, axis.y, axis.z, light.intensity());
    if (light.kind() == Light.Kind.SPOT) {
      put(out, 16, light.cutOff(), 1 / (light.beamWidth() - light.cutOff()), 0, 0);
    }
    return out;
  }

  private static void put(float[] out, int at, double x, double y, double z, double w) {
    out[at] = (float) x;
    out[at + 1] = (float) y;
    out[at + 2] = (float) z;
    out[at + 3] = (float) w;
  }
}
