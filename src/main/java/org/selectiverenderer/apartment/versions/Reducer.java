package org.selectiverenderer.apartment.versions;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.modelling.ExactCount;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Rounding;
import org.selectiverenderer.modelling.TriangleMesh;
import org.selectiverenderer.modelling.Welding;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.simplify.Simplified;
import org.selectiverenderer.polygon.simplify.Simplifier;
import org.selectiverenderer.x3d.geometry.Mesh;

/**
 * Reduces models to exact counts: the simplifier comes close from below, splitting edges does the
 * rest.
 */
final class Reducer {
  /**
   * Reduced surfaces bend by more from face to face: edges up to this angle look smooth, degrees.
   */
  private static final double CREASE = 50;

  private final Simplifier simplifier = new Simplifier();
  private final FileMeshes meshes = new FileMeshes();

  /**
   * @throws IllegalArgumentException if no reduction comes out with at most so many polygons
   */
  Model reduce(ObjectFile original, int polygons) {
    List<Mesh> parts = meshes.of(original);
    int less = 0;
    while (less < polygons) {
      Model reduced =
          model(original.model(), simplifier.simplify(parts, new Goal.Polygons(polygons - less)));
      int missing = polygons - reduced.polygons();
      if (missing >= 0) {
        return ExactCount.refine(odd(reduced, missing), polygons);
      }
      less = Math.max(-missing, 2 * less);
    }
    throw new IllegalArgumentException(
        original.name() + " cannot be reduced to " + polygons + " polygons");
  }

  private static Model odd(Model reduced, int missing) {
    boolean possible = missing % 2 == 0 || ExactCount.hasBorder(reduced);
    return possible ? reduced : Undersides.open(reduced);
  }

  private static Model model(Model original, Simplified simplified) {
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < original.parts().size(); i++) {
      Mesh mesh = simplified.parts().get(i);
      if (!mesh.isEmpty()) {
        Part part = original.parts().get(i);
        TriangleMesh welded = Welding.weld(new TriangleMesh(mesh.positions(), mesh.indices()));
        parts.add(part.with(welded).crease(Math.max(CREASE, part.creaseAngle())));
      }
    }
    return Rounding.toGrid(new Model(original.name(), parts));
  }
}
