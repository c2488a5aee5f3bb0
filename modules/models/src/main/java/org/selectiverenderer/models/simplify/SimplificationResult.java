package org.selectiverenderer.models.simplify;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * The result of a simplification.
 *
 * @param parts one mesh per part of the original, in its order; a part may have come out empty
 * @param vertices number of distinct positions, summed over the parts
 * @param polygons number of triangles, summed over the parts
 * @param error the largest deviation from the original, as a share of its largest extent
 * @param met whether the target is met: counts within 1 % or 2 of the target, errors at most as
 *     large
 */
public record SimplificationResult(
    List<Mesh> parts, int vertices, int polygons, double error, boolean met) {
  /** Returns whether a count meets the one wanted: it differs by at most 1 % or by at most 2. */
  public static boolean near(int count, int wanted) {
    return Math.abs(count - wanted) <= Math.max(2, wanted / 100);
  }
}
