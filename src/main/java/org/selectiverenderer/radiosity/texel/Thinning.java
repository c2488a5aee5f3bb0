package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.radiosity.sampling.PointSet;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;

/**
 * Thins out candidate texels for irradiance records: of texels that lie close together in space, as
 * those of many small charts do, only the first stays.
 */
final class Thinning {
  private final TexelPlace place;

  Thinning(LightScene scene, Solution solution, Texels texels) {
    place = new TexelPlace(scene, solution, texels);
  }

  int[] of(int[] all, int stride) {
    Set<Long> taken = new HashSet<>();
    int[] kept = new int[all.length];
    int count = 0;
    for (int texel : all) {
      place.at(texel);
      if (taken.add(cell(Math.max(1, stride / 2)))) {
        kept[count++] = texel;
      }
    }
    return Arrays.copyOf(kept, count);
  }

  /**
   * Returns a hash key of a grid cube of about this many texels, of the version and of the rounded
   * normal.
   */
  private long cell(int side) {
    double size = Math.scalb(1.0, Math.getExponent(Math.max(1e-6, place.size() * side)));
    long key = place.version;
    for (int axis = 0; axis < 3; axis++) {
      key = 0x9e3779b97f4a7c15L * key + (long) Math.floor(place.point[axis] / size);
    }
    for (int axis = 0; axis < 3; axis++) {
      key = 0x9e3779b97f4a7c15L * key + Math.round(2 * place.normal[axis]);
    }
    return key ^ (long) PointSet.hash((int) (key >>> 32)) << 7 ^ Math.getExponent(size);
  }
}
