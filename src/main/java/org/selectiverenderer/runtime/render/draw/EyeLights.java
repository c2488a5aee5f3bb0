package org.selectiverenderer.runtime.render.draw;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.instance.Light;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.render.gpu.ShapeProgram;

/** The lights of one eye's frame as the fragment shader wants them: in that eye's coordinates. */
final class EyeLights {
  private static final int PER_LIGHT = 20;

  /**
   * @param numbers twenty per light
   * @param count lights, at most {@link ShapeProgram#MAX_LIGHTS}
   */
  record Packed(float[] numbers, int count) {}

  private final Camera camera;
  private final boolean headlight;
  private final Map<List<LightInstance>, Packed> packed = new IdentityHashMap<>();

  EyeLights(Camera camera, boolean headlight) {
    this.camera = camera;
    this.headlight = headlight;
  }

  /**
   * The lights that are on, the headlight first, then in the order of the scene.
   *
   * @param scope compared by identity
   */
  Packed of(List<LightInstance> scope) {
    return packed.computeIfAbsent(scope, this::pack);
  }

  private Packed pack(List<LightInstance> scope) {
    List<float[]> lights = new ArrayList<>();
    if (headlight) {
      // X3D 4.0, 23.4.4: a white directional light along the line of sight.
      float[] out = new float[PER_LIGHT];
      put(out, 0, 0, 0, 1, 0);
      put(out, 4, 1, 1, 1, 0);
      put(out, 8, 1, 0, 0, Float.MAX_VALUE);
      put(out, 12, 0, 0, -1, 1);
      everywhere(out);
      lights.add(out);
    }
    for (LightInstance light : scope) {
      if (light.on() && lights.size() < ShapeProgram.MAX_LIGHTS) {
        lights.add(pack(light));
      }
    }
    float[] numbers = new float[PER_LIGHT * lights.size()];
    for (int i = 0; i < lights.size(); i++) {
      System.arraycopy(lights.get(i), 0, numbers, PER_LIGHT * i, PER_LIGHT);
    }
    return new Packed(numbers, lights.size());
  }

  private float[] pack(LightInstance instance) {
    Light light = instance.light();
    Matrix4d toEye = camera.view().mul(instance.world(), new Matrix4d());
    Vector3d beam =
        toEye.transformDirection(
            new Vector3d(light.direction()[0], light.direction()[1], light.direction()[2]));
    if (beam.lengthSquared() > 0) {
      beam.normalize();
    }
    float[] out = new float[PER_LIGHT];
    if (light.kind() == Light.Kind.DIRECTIONAL) {
      put(out, 0, -beam.x, -beam.y, -beam.z, 0);
    } else {
      Vector3d at =
          toEye.transformPosition(
              new Vector3d(light.location()[0], light.location()[1], light.location()[2]));
      put(out, 0, at.x, at.y, at.z, 1);
    }
    float[] color = light.color();
    put(out, 4, color[0], color[1], color[2], light.ambientIntensity());
    // Distances count in the light's own coordinates (X3D 4.0, 17.2.2): taken to the world's here.
    double scale = Math.cbrt(Math.abs(instance.world().determinant3x3()));
    double unit = scale > 0 ? scale : 1;
    float[] fall = light.attenuation();
    put(
        out,
        8,
        fall[0],
        fall[1] / unit,
        fall[2] / (unit * unit),
        Math.min(light.radius() * unit, Float.MAX_VALUE));
    put(out, 12, beam.x, beam.y, beam.z, light.intensity());
    if (light.kind() == Light.Kind.SPOT) {
      double cutOff = light.cutOffAngle();
      double width = Math.min(light.beamWidth(), cutOff - 1e-4);
      put(out, 16, cutOff, 1 / (width - cutOff), 0, 0);
    } else {
      everywhere(out);
    }
    return out;
  }

  /** A beam whose factor is 1 at every angle. */
  private static void everywhere(float[] out) {
    put(out, 16, 1e6, -1, 0, 0);
  }

  private static void put(float[] out, int at, double x, double y, double z, double w) {
    out[at] = (float) x;
    out[at + 1] = (float) y;
    out[at + 2] = (float) z;
    out[at + 3] = (float) w;
  }
}
