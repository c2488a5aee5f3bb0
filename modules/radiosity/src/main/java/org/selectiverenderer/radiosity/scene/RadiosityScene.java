package org.selectiverenderer.radiosity.scene;

import java.util.List;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;
import org.selectiverenderer.radiosity.trace.SceneIntersector;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/**
 * A scene prepared for radiosity: the bodies to light, their triangles and visibility, and the
 * lamps that light them.
 *
 * @param bodies the bodies in document order
 * @param bodyOf number of the body of each triangle
 * @param lamps the light sources that are sampled directly
 * @param sampled per body: whether its emission is one of the lamps
 * @param budgets number of polygons of each region
 * @param extent longest side of the scene's bounding box, metres
 * @param lumens luminous flux of all lamps, lm
 */
public record RadiosityScene(
    List<Body> bodies,
    SceneTriangles triangles,
    int[] bodyOf,
    ObjectVersionIndex versions,
    SceneIntersector visibility,
    List<LightSource> lamps,
    boolean[] sampled,
    int[] budgets,
    double extent,
    double lumens) {

  public Body body(int triangle) {
    return bodies.get(bodyOf[triangle]);
  }

  /**
   * Returns whether a triangle gives light to others: all do except those of versions that are not
   * the reference of their object.
   */
  public boolean stands(int triangle) {
    return versions.isReference(triangles.version()[triangle]);
  }

  /** Returns the same scene with only some bodies to light; all triangles stay. */
  public RadiosityScene only(List<Integer> numbers) {
    return new RadiosityScene(
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

  /**
   * Returns the distance from a surface at which rays start, so that they do not hit it, metres.
   */
  public double offset() {
    return 1e-5 * extent;
  }
}
