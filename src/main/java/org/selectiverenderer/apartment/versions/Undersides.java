package org.selectiverenderer.apartment.versions;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.modelling.MeshMeasures;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.TriangleMesh;

/**
 * Opens closed models where nobody looks: closed surfaces have even counts, and some of the
 * thesis's are odd.
 */
final class Undersides {

  private Undersides() {}

  /** The model without its lowest triangle that faces down. */
  static Model open(Model model) {
    int part = -1;
    int triangle = -1;
    double lowest = Double.POSITIVE_INFINITY;
    for (int p = 0; p < model.parts().size(); p++) {
      TriangleMesh mesh = model.parts().get(p).mesh();
      for (int t = 0; t < mesh.triangleCount(); t++) {
        Vector3d normal = MeshMeasures.normal(mesh, t);
        double height = middle(mesh, t) + 10 * (1 + normal.y / normal.length());
        if (height < lowest) {
          lowest = height;
          part = p;
          triangle = t;
        }
      }
    }
    List<Part> parts = new ArrayList<>(model.parts());
    parts.set(part, parts.get(part).with(without(parts.get(part).mesh(), triangle)));
    return new Model(model.name(), parts);
  }

  private static double middle(TriangleMesh mesh, int triangle) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
      sum += mesh.point(mesh.triangles()[3 * triangle + k]).y;
    }
    return sum / 3;
  }

  private static TriangleMesh without(TriangleMesh mesh, int triangle) {
    int[] all = mesh.triangles();
    int[] kept = Arrays.copyOf(all, all.length - 3);
    System.arraycopy(all, 3 * triangle + 3, kept, 3 * triangle, kept.length - 3 * triangle);
    return new TriangleMesh(mesh.positions(), kept);
  }
}
