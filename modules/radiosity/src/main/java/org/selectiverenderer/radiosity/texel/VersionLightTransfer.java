package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.atlas.BilinearTexelLookup;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;

/**
 * Transfers the light of an object's reference version to its other versions. A texel of another
 * version takes the light of the closest point with a like normal on the reference version, so that
 * switching versions changes the outline and not the light. Where there is no such point near, the
 * texel is gathered itself.
 */
public final class VersionLightTransfer implements TexelSelection {
  private static final int CHUNK = 4096;

  /**
   * Least cosine of the angle between the interpolated normal and the triangle's own for which the
   * interpolated one is used.
   */
  private static final double LEAST_BENT = 0.3;

  private final BilinearTexelLookup lookup;

  /** Per page: the surface points to take light from; null for a page without any. */
  private final @Nullable Places[] pages;

  private final long count;

  private record Places(int[] triangle, float[] u, float[] v) {}

  private VersionLightTransfer(BilinearTexelLookup lookup, @Nullable Places[] pages, long count) {
    this.lookup = lookup;
    this.pages = pages;
    this.count = count;
  }

  /** Finds the points to take light from; only some of them if the work is cancelled. */
  public static VersionLightTransfer find(
      RadiosityScene scene, Atlas atlas, RadiosityProgress progress) {
    BilinearTexelLookup lookup = new BilinearTexelLookup(scene, atlas);
    @Nullable ReferenceSurface[] surfaces = surfaces(scene, lookup);
    @Nullable Places[] pages = new Places[atlas.pages().size()];
    int[] first = new int[pages.length + 1];
    for (int i = 0; i < pages.length; i++) {
      AtlasPage map = atlas.pages().get(i);
      boolean shares = IntStream.of(map.triangle()).anyMatch(t -> shares(scene, t));
      first[i + 1] = first[i] + (shares ? (map.texels() + CHUNK - 1) / CHUNK : 0);
      if (shares) {
        int[] triangle = new int[map.texels()];
        Arrays.fill(triangle, AtlasPage.NONE);
        pages[i] = new Places(triangle, new float[map.texels()], new float[map.texels()]);
      }
    }
    AtomicLong found = new AtomicLong();
    ParallelFor.run(
        first[pages.length],
        1,
        progress,
        share -> {},
        (from, to) -> {
          for (int chunk = from; chunk < to; chunk++) {
            int page = pageOf(first, chunk);
            AtlasPage map = atlas.pages().get(page);
            int begin = (chunk - first[page]) * CHUNK;
            found.addAndGet(
                search(
                    scene,
                    surfaces,
                    map,
                    pages[page],
                    begin,
                    Math.min(map.texels(), begin + CHUNK)));
          }
        });
    return new VersionLightTransfer(lookup, pages, found.get());
  }

  /** Returns the number of texels that take their light from the reference version. */
  public long count() {
    return count;
  }

  @Override
  public boolean wanted(int page, int texel) {
    Places places = pages[page];
    return places == null || places.triangle()[texel] == AtlasPage.NONE;
  }

  @Override
  public void rest(List<float[]> irradiance) {
    IntStream.range(0, pages.length)
        .parallel()
        .filter(page -> pages[page] != null)
        .forEach(page -> copy(pages[page], irradiance, irradiance.get(page)));
  }

  private void copy(Places places, List<float[]> irradiance, float[] out) {
    int[] texels = new int[4];
    float[] weights = new float[4];
    for (int i = 0; i < places.triangle().length; i++) {
      int triangle = places.triangle()[i];
      if (triangle == AtlasPage.NONE) {
        continue;
      }
      float[] light = irradiance.get(lookup.page(triangle));
      int count = lookup.find(triangle, places.u()[i], places.v()[i], texels, weights);
      for (int c = 0; c < 3; c++) {
        float sum = 0;
        for (int k = 0; k < count; k++) {
          sum += weights[k] * light[3 * texels[k] + c];
        }
        out[3 * i + c] = sum;
      }
    }
  }

  private static boolean shares(RadiosityScene scene, int triangle) {
    return triangle != AtlasPage.NONE
        && !scene.versions().isReference(scene.triangles().version()[triangle]);
  }

  /** Returns for each version the surface of its object's reference version, if that has texels. */
  private static @Nullable ReferenceSurface[] surfaces(
      RadiosityScene scene, BilinearTexelLookup lookup) {
    ObjectVersionIndex versions = scene.versions();
    int[] version = scene.triangles().version();
    int[] sizes = new int[versions.count()];
    int objects = IntStream.range(0, versions.count()).map(versions::object).max().orElse(0);
    int[] standsFor = new int[objects + 1];
    for (int v = 1; v < versions.count(); v++) {
      if (versions.isReference(v)) {
        standsFor[versions.object(v)] = v;
      }
    }
    for (int t = 0; t < version.length; t++) {
      if (has(versions, version[t]) && lookup.page(t) != AtlasPage.NONE) {
        sizes[version[t]]++;
      }
    }
    int[][] members = new int[sizes.length][];
    for (int v = 0; v < sizes.length; v++) {
      members[v] = new int[sizes[v]];
    }
    Arrays.fill(sizes, 0);
    for (int t = 0; t < version.length; t++) {
      if (has(versions, version[t]) && lookup.page(t) != AtlasPage.NONE) {
        members[version[t]][sizes[version[t]]++] = t;
      }
    }
    @Nullable ReferenceSurface[] made = new ReferenceSurface[versions.count()];
    IntStream.range(1, made.length)
        .parallel()
        .filter(v -> versions.isReference(v) && members[v].length > 0)
        .forEach(v -> made[v] = new ReferenceSurface(scene.triangles(), members[v]));
    @Nullable ReferenceSurface[] byVersion = new ReferenceSurface[versions.count()];
    for (int v = 1; v < byVersion.length; v++) {
      byVersion[v] = made[standsFor[versions.object(v)]];
    }
    return byVersion;
  }

  private static boolean has(ObjectVersionIndex versions, int version) {
    return version != ObjectVersionIndex.FIXED && versions.isReference(version);
  }

  private static int pageOf(int[] first, int chunk) {
    int page = 0;
    while (first[page + 1] <= chunk) {
      page++;
    }
    return page;
  }

  private static int search(
      RadiosityScene scene,
      @Nullable ReferenceSurface[] surfaces,
      AtlasPage map,
      Places places,
      int from,
      int to) {
    ReferenceSurface surface = null;
    ReferenceSurface.Search search = null;
    double[] point = new double[3];
    double[] normal = new double[3];
    int found = 0;
    for (int i = from; i < to; i++) {
      int triangle = map.triangle()[i];
      if (!shares(scene, triangle)) {
        continue;
      }
      ReferenceSurface own = surfaces[scene.triangles().version()[triangle]];
      if (own == null) {
        continue;
      }
      if (own != surface) {
        surface = own;
        search = own.new Search();
      }
      scene.triangles().point(triangle, map.u()[i], map.v()[i], point);
      scene.triangles().normal(triangle, normal);
      bend(scene.body(triangle), triangle, map.u()[i], map.v()[i], normal);
      if (search.find(point, normal)) {
        places.triangle()[i] = search.triangle();
        places.u()[i] = (float) search.u();
        places.v()[i] = (float) search.v();
        found++;
      }
    }
    return found;
  }

  /**
   * Replaces a triangle's normal by the interpolated vertex normal, which on a version of few
   * triangles is closer to the normals of the reference version. An interpolated normal far from
   * the triangle's own is ignored.
   */
  private static void bend(Body body, int triangle, float u, float v, double[] normal) {
    float[] all = body.normals();
    double[] bent = new double[3];
    for (int corner = 0; corner < 3; corner++) {
      int at = 3 * body.vertex(triangle - body.firstTriangle(), corner);
      double weight = corner == 0 ? 1 - u - v : corner == 1 ? u : v;
      for (int axis = 0; axis < 3; axis++) {
        bent[axis] += weight * all[at + axis];
      }
    }
    TriangleMath.normalize(bent);
    double cosine = bent[0] * normal[0] + bent[1] * normal[1] + bent[2] * normal[2];
    if (cosine > LEAST_BENT) {
      System.arraycopy(bent, 0, normal, 0, 3);
    }
  }
}
