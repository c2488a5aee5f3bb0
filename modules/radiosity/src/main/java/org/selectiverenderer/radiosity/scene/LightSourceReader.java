package org.selectiverenderer.radiosity.scene;

import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.Light;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.radiosity.light.Attenuation;
import org.selectiverenderer.radiosity.light.DirectionalLightSource;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.light.PointLightSource;
import org.selectiverenderer.radiosity.light.RectangleLightSource;

/**
 * Converts X3D's light nodes to light sources with photometric units.
 *
 * <p>A MetadataSet {@code photometric} on a light states what it emits: {@code lumen}, {@code
 * candela} or, for a SpotLight with a {@code size} (width and height, metres), {@code luminance} in
 * cd/m2; for a DirectionalLight {@code lux}. A SpotLight with a {@code size} is a diffuse rectangle
 * that shines to its front, such as a window; its width is horizontal. Any other light has {@code
 * intensity} times {@link Photometry#WHITE} times pi candela (lux), so that a white surface a metre
 * away is as bright as X3D draws it.
 */
public final class LightSourceReader {
  private static final double[] DOWN = {0, -1, 0};

  private final boolean photometric;
  private final double unit;
  private final ProblemCollector problems;

  /**
   * @param photometric whether light falls with the square of the distance
   * @param unit metres per unit of length
   * @param problems receives warnings about photometric metadata that cannot be used
   */
  public LightSourceReader(boolean photometric, double unit, ProblemCollector problems) {
    this.photometric = photometric;
    this.unit = unit;
    this.problems = problems;
  }

  private static SortedSet<String> members(Light light) {
    return new TreeSet<>(
        switch (light.kind()) {
          case DIRECTIONAL -> Set.of("lux");
          case POINT -> Set.of("candela", "lumen");
          case SPOT -> Set.of("candela", "lumen", "luminance", "size");
        });
  }

  /**
   * Returns the light source of a light node; empty if it is off or its transform is not finite.
   */
  public Optional<LightSource> read(LightInstance instance) {
    Light light = instance.light();
    if (!light.on() || !(light.intensity() > 0)) {
      return Optional.empty();
    }
    Optional<PhotometricMetadata> wishes =
        PhotometricMetadata.of(instance.node(), "photometric", members(light), problems);
    float[] hue = Photometry.linear(light.color());
    double luminance = Photometry.luminance(hue);
    if (!(luminance > 0)) {
      return Optional.empty();
    }
    Matrix4dc world = instance.world();
    Vector3d axis = direction(light.direction(), world);
    Vector3d place =
        world
            .transformPosition(
                new Vector3d(light.location()[0], light.location()[1], light.location()[2]))
            .mul(unit);
    if (!axis.isFinite() || !place.isFinite()) {
      return Optional.empty();
    }
    double standard = light.intensity() * Photometry.WHITE * Math.PI;
    return Optional.of(
        switch (light.kind()) {
          case DIRECTIONAL -> {
            double lux = wishes.flatMap(w -> w.number("lux")).orElse(standard * luminance);
            yield new DirectionalLightSource(
                new double[] {-axis.x, -axis.y, -axis.z}, scaled(hue, lux / luminance), lux);
          }
          case POINT -> {
            double candela =
                wishes
                    .flatMap(
                        w ->
                            w.number("candela")
                                .or(() -> w.number("lumen").map(lm -> lm / (4 * Math.PI))))
                    .orElse(standard * luminance);
            yield new PointLightSource(
                array(place),
                scaled(hue, candela / luminance),
                DOWN,
                -1,
                -2,
                falloff(light),
                candela * 4 * Math.PI);
          }
          case SPOT ->
              wishes
                  .flatMap(w -> w.numbers("size").filter(size -> size.length >= 2))
                  .map(size -> rectangle(wishes.get(), size, light, world, axis, place, hue))
                  .orElseGet(() -> spot(wishes, light, axis, place, hue, standard));
        });
  }

  private LightSource spot(
      Optional<PhotometricMetadata> wishes,
      Light light,
      Vector3d axis,
      Vector3d place,
      float[] hue,
      double standard) {
    double luminance = Photometry.luminance(hue);
    double outer = StrictMath.cos(light.cutOffAngle());
    double inner = StrictMath.cos(Math.min(light.beamWidth(), light.cutOffAngle()));
    // The solid angle of the beam, with its border counted half.
    double solid = 2 * Math.PI * (1 - (inner + outer) / 2);
    double candela =
        wishes
            .flatMap(w -> w.number("candela").or(() -> w.number("lumen").map(lm -> lm / solid)))
            .orElse(standard * luminance);
    return new PointLightSource(
        array(place),
        scaled(hue, candela / luminance),
        array(axis),
        inner,
        outer,
        falloff(light),
        candela * solid);
  }

  private LightSource rectangle(
      PhotometricMetadata wishes,
      double[] size,
      Light light,
      Matrix4dc world,
      Vector3d axis,
      Vector3d place,
      float[] hue) {
    Vector3d local =
        new Vector3d(light.direction()[0], light.direction()[1], light.direction()[2]).normalize();
    Vector3d width =
        Math.abs(local.y) > 0.999 ? new Vector3d(1, 0, 0) : local.cross(0, 1, 0, new Vector3d());
    width = world.transformDirection(width).normalize();
    Vector3d height = axis.cross(width, new Vector3d()).normalize();
    width = height.cross(axis, new Vector3d()).normalize();
    double area = size[0] * size[1];
    double cdPerM2 =
        wishes
            .number("luminance")
            .or(() -> wishes.number("lumen").map(lm -> lm / (Math.PI * area)))
            .or(() -> wishes.number("candela").map(cd -> cd / area))
            .orElse(light.intensity() * Photometry.WHITE);
    return new RectangleLightSource(
        array(place),
        array(width.mul(size[0] / 2)),
        array(height.mul(size[1] / 2)),
        array(axis),
        scaled(hue, cdPerM2 / Photometry.luminance(hue)),
        area,
        Math.PI * area * cdPerM2);
  }

  private Attenuation falloff(Light light) {
    if (photometric) {
      return new Attenuation.InverseSquare();
    }
    float[] a = light.attenuation();
    return new Attenuation.X3dAttenuation(
        a[0], a[1] / unit, a[2] / (unit * unit), light.radius() * unit);
  }

  private static Vector3d direction(float[] local, Matrix4dc world) {
    return world.transformDirection(new Vector3d(local[0], local[1], local[2])).normalize();
  }

  private static float[] scaled(float[] rgb, double scale) {
    return new float[] {
      (float) (rgb[0] * scale), (float) (rgb[1] * scale), (float) (rgb[2] * scale)
    };
  }

  private static double[] array(Vector3d v) {
    return new double[] {v.x, v.y, v.z};
  }
}
