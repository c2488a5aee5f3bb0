package org.selectiverenderer.x3d.write;

import org.selectiverenderer.base.decimal.DecimalText;

/**
 * Writes an IndexedFaceSet of triangles: each index field on a line of its own, then the nodes of
 * the values. To be called in that order.
 */
public final class FaceSetWriter {
  private final X3dWriter out;

  /**
   * Begins the node, in the container that is usual.
   *
   * @param creaseAngle radians; 0 is left out, as it is the standard's
   */
  public FaceSetWriter(X3dWriter out, double creaseAngle, boolean solid) {
    this.out = out.open("IndexedFaceSet");
    if (creaseAngle > 0) {
      out.attribute("creaseAngle", DecimalText.rounded(creaseAngle, 3));
    }
    if (!solid) {
      out.attribute("solid", "false");
    }
  }

  /**
   * A field of indices.
   *
   * @param triangles filled with a corner per vertex of each
   */
  public FaceSetWriter index(String field, TupleLines triangles) {
    out.ownLine().numbers(field, triangles.text());
    return this;
  }

  /** A node of values: {@code Coordinate point}, {@code Color color} and so on. */
  public FaceSetWriter values(String node, String field, TupleLines values) {
    out.open(node).numbers(field, values.text()).close();
    return this;
  }

  /** Ends the node. */
  public void close() {
    out.close();
  }
}
