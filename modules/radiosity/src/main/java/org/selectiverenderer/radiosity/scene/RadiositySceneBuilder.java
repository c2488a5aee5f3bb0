package org.selectiverenderer.radiosity.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.radiosity.light.EmissiveMeshLightSource;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.trace.SceneIntersector;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** Builds the {@link RadiosityScene} of a loaded scene. */
public final class RadiositySceneBuilder {
  /** Coordinates beyond which single precision cannot tell neighbouring points apart, metres. */
  private static final double FARTHEST = 100_000;

  /** Emissive surfaces with less than this share of all light are found by indirect rays only. */
  private static final double WEAK = 0.002;

  private static final int MOST_GLOWS = 48;

  /**
   * Emissive surfaces with more area than this share of the square of the scene's extent are hit by
   * indirect rays often enough, and are so near to other surfaces that sample points of them would
   * show as spots.
   */
  private static final double WIDE = 0.1;

  private final boolean photometric;
  private final ProblemCollector problems;

  /**
   * @param photometric whether light falls with the square of the distance
   * @param problems receives warnings about content that cannot be used
   */
  public RadiositySceneBuilder(boolean photometric, ProblemCollector problems) {
    this.photometric = photometric;
    this.problems = problems;
  }

  /**
   * @param unit metres per unit of length
   * @throws RadiosityException if nothing can be lit, before any long computation
   */
  public RadiosityScene read(InstanceTree tree, double unit) throws RadiosityException {
    BodyCollector gatherer = new BodyCollector(unit, problems);
    gatherer.gather(tree.root());
    List<Body> bodies = gatherer.bodies();
    check(bodies, gatherer.triangles());
    SceneTriangles triangles = triangles(bodies, gatherer.triangles());
    int[] bodyOf = new int[triangles.count()];
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      java.util.Arrays.fill(
          bodyOf, body.firstTriangle(), body.firstTriangle() + body.triangles(), i);
    }
    List<LightSource> lamps = new ArrayList<>();
    LightSourceReader reader = new LightSourceReader(photometric, unit, problems);
    for (LightInstance light : tree.lights()) {
      reader.read(light).ifPresent(lamps::add);
    }
    boolean[] sampled = new boolean[bodies.size()];
    glows(bodies, triangles, gatherer, extent(triangles), lamps, sampled);
    double lumens = lamps.stream().mapToDouble(LightSource::lumens).sum();
    if (lamps.isEmpty() && bodies.stream().noneMatch(Body::glows)) {
      throw new RadiosityException(
          "the scene has no light: add a light that is on, or an emissive material");
    }
    return new RadiosityScene(
        List.copyOf(bodies),
        triangles,
        bodyOf,
        gatherer.versions(),
        new SceneIntersector(triangles, gatherer.versions()),
        List.copyOf(lamps),
        sampled,
        gatherer.budgets(),
        extent(triangles),
        lumens);
  }

  private static void check(List<Body> bodies, int count) throws RadiosityException {
    if (count == 0) {
      throw new RadiosityException(
          "there is nothing to light: the scene has no triangles with a Material");
    }
    MemoryEstimator.ofTriangles(count);
    for (Body body : bodies) {
      for (float coordinate : body.positions()) {
        if (Math.abs(coordinate) > FARTHEST) {
          throw new RadiosityException(
              body.shape().node().location()
                  + ": a shape is more than 100 km from the origin, where points "
                  + "cannot be distinguished; move the scene to its origin or state "
                  + "another unit of length");
        }
      }
    }
  }

  private static SceneTriangles triangles(List<Body> bodies, int count) {
    float[] corners = new float[9 * count];
    boolean[] twoSided = new boolean[count];
    float[] transmittance = new float[count];
    int[] version = new int[count];
    for (Body body : bodies) {
      int first = body.firstTriangle();
      for (int i = 0; i < body.triangles(); i++) {
        for (int corner = 0; corner < 3; corner++) {
          System.arraycopy(
              body.positions(),
              3 * body.vertex(i, corner),
              corners,
              9 * (first + i) + 3 * corner,
              3);
        }
        twoSided[first + i] = !body.mesh().solid();
        transmittance[first + i] = body.transmittance();
        version[first + i] = body.version();
      }
    }
    return new SceneTriangles(corners, twoSided, transmittance, version);
  }

  /** Makes the brightest emissive surfaces of reference versions lamps. */
  private static void glows(
      List<Body> bodies,
      SceneTriangles triangles,
      BodyCollector gatherer,
      double extent,
      List<LightSource> lamps,
      boolean[] sampled) {
    record Glow(int body, EmissiveMeshLightSource lamp) {}
    List<Glow> glows = new ArrayList<>();
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      if (body.glows() && gatherer.versions().isReference(body.version())) {
        glows.add(
            new Glow(
                i,
                new EmissiveMeshLightSource(
                    triangles, body.firstTriangle(), body.triangles(), body.emission())));
      }
    }
    double all =
        lamps.stream().mapToDouble(LightSource::lumens).sum()
            + glows.stream().mapToDouble(glow -> glow.lamp().lumens()).sum();
    glows.stream()
        .filter(glow -> glow.lamp().lumens() > WEAK * all)
        .filter(glow -> glow.lamp().area() <= WIDE * extent * extent)
        .sorted(
            Comparator.comparingDouble((Glow glow) -> -glow.lamp().lumens())
                .thenComparingInt(Glow::body))
        .limit(MOST_GLOWS)
        .forEach(
            glow -> {
              lamps.add(glow.lamp());
              sampled[glow.body()] = true;
            });
  }

  private static double extent(SceneTriangles triangles) {
    double extent = 0;
    for (int axis = 0; axis < 3; axis++) {
      float low = Float.POSITIVE_INFINITY;
      float high = Float.NEGATIVE_INFINITY;
      for (int i = axis; i < triangles.corners().length; i += 3) {
        low = Math.min(low, triangles.corners()[i]);
        high = Math.max(high, triangles.corners()[i]);
      }
      extent = Math.max(extent, (double) high - low);
    }
    return extent;
  }
}
