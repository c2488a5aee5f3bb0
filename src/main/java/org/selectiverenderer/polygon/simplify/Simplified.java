package org.selectiverenderer.polygon.simplify;

import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A reduced model.
 *
 * @param parts one mesh per part of the original, in its order; a part may have come out empty
 * @param vertices distinct positions, summed over the parts
 * @param polygons triangles, summed over the parts
 * @param error the largest deviation from the original, as a share of its largest extent
 * @param met whether the goal is met: counts within 1 % or 2 of it, errors at most as large
 */
public record Simplified(List<Mesh> parts, int vertices, int polygons, double error, boolean met) {
  /** Whether a count is as good as the one asked for: within 1 % or 2 of it. */
  public static boolean near(int count, int wanted) {
    return Math.abs(count - wanted) <= Math.max(2, wanted / 100);
  }
}
