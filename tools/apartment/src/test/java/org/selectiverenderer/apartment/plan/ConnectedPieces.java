package org.selectiverenderer.apartment.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ParametricModel;

/** The pieces of a model that hang together: the legs of a table, each book of a row. */
final class ConnectedPieces {

  private ConnectedPieces() {}

  /** The boxes around them, in the model's frame. */
  static List<BoundingBox> boxes(ParametricModel model) {
    TriangleMesh mesh = model.mesh();
    int[] parent = new int[mesh.pointCount()];
    for (int i = 0; i < parent.length; i++) {
      parent[i] = i;
    }
    int[] t = mesh.triangles();
    for (int i = 0; i < t.length; i += 3) {
      parent[root(parent, t[i])] = root(parent, t[i + 1]);
      parent[root(parent, t[i + 1])] = root(parent, t[i + 2]);
    }
    Map<Integer, BoundingBox> boxes = new HashMap<>();
    for (int index : t) {
      float x = mesh.positions()[3 * index];
      float y = mesh.positions()[3 * index + 1];
      float z = mesh.positions()[3 * index + 2];
      boxes.merge(root(parent, index), new BoundingBox(x, y, z, x, y, z), BoundingBox::union);
    }
    return new ArrayList<>(boxes.values());
  }

  private static int root(int[] parent, int i) {
    int at = i;
    while (parent[at] != at) {
      parent[at] = parent[parent[at]];
      at = parent[at];
    }
    return at;
  }
}
