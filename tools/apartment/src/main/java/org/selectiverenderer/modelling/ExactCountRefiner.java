package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.LongestEdgeBisection;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Refines a model to an exact number of triangles without changing its shape: the longest edge of
 * all is split in its middle, with the triangles on both sides of it, again and again. An edge
 * inside a surface adds two triangles, an edge on a border adds one; there are no T-junctions.
 * Deterministic.
 */
public final class ExactCountRefiner {

  private ExactCountRefiner() {}

  /**
   * @param polygons the number of triangles to reach, at least as many as the model has
   * @throws IllegalArgumentException if it has more, or if the difference is odd and no part has a
   *     border: the count of a closed surface is even
   */
  public static ParametricModel refine(ParametricModel model, int polygons) {
    int missing = polygons - model.polygons();
    if (missing < 0) {
      throw new IllegalArgumentException(
          model.name()
              + " has "
              + model.polygons()
              + " polygons, more than the "
              + polygons
              + " asked for");
    }
    List<EdgeSplitVertexBuffer> points =
        model.parts().stream().map(p -> new EdgeSplitVertexBuffer(p.mesh())).toList();
    List<LongestEdgeBisection> splitters = new ArrayList<>();
    for (int i = 0; i < points.size(); i++) {
      splitters.add(
          new LongestEdgeBisection(points.get(i), model.parts().get(i).mesh().triangles()));
    }
    while (missing > 0) {
      int most = missing;
      int added =
          splitters.stream()
              .reduce((a, b) -> b.longest(most) > a.longest(most) ? b : a)
              .map(longest -> longest.split(most))
              .orElse(0);
      if (added == 0) {
        throw new IllegalArgumentException(
            model.name()
                + " is closed everywhere, so it cannot have "
                + polygons
                + " polygons: an odd count needs a part with a border");
      }
      missing -= added;
    }
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < splitters.size(); i++) {
      TriangleMesh refined =
          new TriangleMesh(points.get(i).positions(), splitters.get(i).indices());
      parts.add(model.parts().get(i).with(refined));
    }
    return new ParametricModel(model.name(), parts);
  }
}
