package org.selectiverenderer.radiosity.scene;

import java.util.List;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.trace.SceneTriangles;
import org.selectiverenderer.radiosity.trace.Versions;
import org.selectiverenderer.radiosity.trace.Visibility;

/**
 * What there is to be lit, and by what.
 *
 * @param bodies in document order
 * @param bodyOf body by triangle
 * @param lamps that are sampled directly
 * @param sampled per body: whether its glow is among the lamps
 * @param budgets polygons by region
 * @param extent the largest side of the box around it, metres
 * @param lumens what the lamps emit
 */
public record LightScene(
    List<Body> bodies,
    SceneTriangles triangles,
    int[] bodyOf,
    Versions versions,
    Visibility visibility,
    List<Lamp> lamps,
    boolean[] sampled,
    int[] budgets,
    double extent,
    double lumens) {

  public Body body(int triangle) {
    return bodies.get(bodyOf[triangle]);
  }

  /** Whether a triangle gives light to others: all do but those of versions that do not stand. */
  public boolean stands(int triangle) {
    return versions.isReference(triangles.version()[triangle]);
  }

  /** The same scene with only some bodies to be lit; all triangles stay where they are. */
  public LightScene only(List<Integer> numbers) {
    return new LightScene(
        numbers.stream().map(bodies::get).toList(),
        triangles,
        bodyOf,
        versions,
        visibility,
        lamps,
        sampled,
        budgets,
        extent,
        lumens);
  }

  /** How far rays start off a surface, so that they do not meet it. */
  public double offset() {
    return 1e-5 * extent;
  }
}
