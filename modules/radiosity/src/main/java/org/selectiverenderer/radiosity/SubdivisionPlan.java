package org.selectiverenderer.radiosity;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.radiosity.mesh.AdaptiveSubdivision;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;

/**
 * The plan of the adaptive subdivision: which bodies are subdivided and to how many polygons. These
 * are the regions with a polygon budget or, in a scene without budgets, all bodies without
 * versions, unless light is stored in lightmaps.
 *
 * @param minMesh minimum mesh size, metres
 * @param maxMesh maximum mesh size, metres
 * @param regions the groups of bodies that share a polygon count; none when subdivision is off
 */
record SubdivisionPlan(double minMesh, double maxMesh, List<Region> regions) {

  /**
   * Default mesh sizes: the maximum as a share of the scene's largest extent, the minimum as a
   * share of the maximum.
   */
  private static final double MAX_SHARE = 1.0 / 40;

  private static final double MIN_SHARE = 0.1;

  /**
   * @param bodies numbers of the bodies in the scene
   * @param exact whether {@code polygons} is the exact number to reach, or an upper limit
   */
  record Region(List<Integer> bodies, int polygons, boolean exact) {}

  /**
   * @throws RadiosityException if a budget or the limit of polygons cannot be kept
   */
  static SubdivisionPlan of(RadiosityScene scene, RadiositySettings settings)
      throws RadiosityException {
    double max = settings.maxMesh().orElse(MAX_SHARE * scene.extent());
    double min = Math.min(max, settings.minMesh().orElse(MIN_SHARE * max));
    List<Region> regions = new ArrayList<>();
    if (scene.budgets().length > 0) {
      for (int i = 0; i < scene.budgets().length; i++) {
        budget(scene, i, settings, regions);
      }
    } else if (settings.globalSubdivision() && !settings.store().inTextures()) {
      free(scene, settings, max, regions);
    }
    return new SubdivisionPlan(min, max, regions);
  }

  /**
   * Brings a region to its exact number of polygons, if it has one.
   *
   * @throws RadiosityException if there is no such division
   */
  void require(Region region, AdaptiveSubdivision subdivision) throws RadiosityException {
    if (region.exact() && !subdivision.toNumber()) {
      throw new RadiosityException(
          ("the surfaces for which the scene asks for %d polygons can only have %d: all of them "
                      + "are closed, so")
                  .formatted(region.polygons(), subdivision.count())
              + " the number must be even");
    }
  }

  private static void budget(
      RadiosityScene scene, int number, RadiositySettings settings, List<Region> regions)
      throws RadiosityException {
    List<Integer> bodies = new ArrayList<>();
    int triangles = 0;
    for (int i = 0; i < scene.bodies().size(); i++) {
      if (scene.bodies().get(i).budget() == number) {
        bodies.add(i);
        triangles += scene.bodies().get(i).triangles();
      }
    }
    int polygons = scene.budgets()[number];
    if (bodies.isEmpty()) {
      return;
    }
    String place = String.valueOf(scene.bodies().get(bodies.get(0)).shape().node().location());
    if (triangles > polygons) {
      throw new RadiosityException(
          "%s: the scene asks for %d polygons here (metadata radiosity), fewer than the %d it has"
              .formatted(place, polygons, triangles));
    }
    if (polygons > settings.maxPolygons()) {
      throw new RadiosityException(
          "%s: the scene asks for %d polygons here (metadata radiosity), more than the %d allowed;"
                  .formatted(place, polygons, settings.maxPolygons())
              + " raise --max-polygons");
    }
    if (settings.globalSubdivision()) {
      regions.add(new Region(bodies, polygons, true));
    }
  }

  private static void free(
      RadiosityScene scene, RadiositySettings settings, double max, List<Region> regions)
      throws RadiosityException {
    List<Integer> bodies = new ArrayList<>();
    long triangles = 0;
    double needed = 0;
    double[] normal = new double[3];
    for (int i = 0; i < scene.bodies().size(); i++) {
      Body body = scene.bodies().get(i);
      if (body.version() != ObjectVersionIndex.FIXED) {
        continue;
      }
      bodies.add(i);
      triangles += body.triangles();
      for (int k = 0; k < body.triangles(); k++) {
        // Counts right-angled halves of squares whose diagonal is the maximum mesh size.
        double parts = scene.triangles().normal(body.firstTriangle() + k, normal) / (max * max / 4);
        needed += Math.max(1, parts);
      }
    }
    if (bodies.isEmpty()) {
      return;
    }
    if (needed > settings.maxPolygons() && needed > 1.05 * triangles) {
      throw new RadiosityException(
          "a maximum mesh size of %s m takes about %.0f polygons, more than the %d allowed; raise"
                  .formatted(RadiositySettings.shortest(max), needed, settings.maxPolygons())
              + " --max-mesh or --max-polygons");
    }
    int limit = (int) Math.min(settings.maxPolygons(), Math.max(2 * triangles, 4 * (long) needed));
    if (limit > triangles) {
      regions.add(new Region(bodies, limit, false));
    }
  }
}
