package org.selectiverenderer.modelling;

import java.util.LinkedHashMap;
import java.util.Map;
import org.joml.Vector3d;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.x3d.write.TupleLines;

/**
 * Indexed texture coordinates of a mesh as X3D writes them: each pair once, and for every corner of
 * a triangle the number of its pair. Corners at one point have different pairs where faces of a box
 * meet.
 */
final class CladdingText {
  /** Decimals of texture coordinates: a fifth of a millimetre where an image is two metres wide. */
  private static final int DECIMALS = 4;

  private final Map<String, Integer> pairs = new LinkedHashMap<>();
  private final int[] corners;

  CladdingText(Cladding cladding, TriangleMesh mesh) {
    int[] t = mesh.triangles();
    corners = new int[t.length];
    for (int i = 0; i < t.length; i += 3) {
      Vector3d a = mesh.point(t[i]);
      Vector3d along = mesh.point(t[i + 1]).sub(a);
      Vector3d normal = along.cross(mesh.point(t[i + 2]).sub(a));
      for (int k = i; k < i + 3; k++) {
        double[] st = cladding.laying().at(mesh.point(t[k]), normal);
        String pair =
            DecimalText.rounded(st[0], DECIMALS) + " " + DecimalText.rounded(st[1], DECIMALS);
        corners[k] = pairs.computeIfAbsent(pair, key -> pairs.size());
      }
    }
  }

  /** Returns the numbers of the pairs, three for each triangle. */
  int[] corners() {
    return corners;
  }

  /** Appends the pairs to {@code out} and returns it. */
  TupleLines points(TupleLines out) {
    pairs.keySet().forEach(pair -> out.next().append(pair));
    return out;
  }
}
