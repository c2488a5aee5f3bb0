package org.selectiverenderer.x3d.write;

import org.selectiverenderer.base.decimal.DecimalFormatter;

/**
 * Writes an IndexedFaceSet of triangles: first the index fields, each on a line of its own, then
 * the nodes of values.
 */
public final class IndexedFaceSetWriter {
  private final X3dWriter out;

  /**
   * Begins the node, with the default containerField.
   *
   * @param creaseAngle in radians; 0, the default of the standard, is not written
   */
  public IndexedFaceSetWriter(X3dWriter out, double creaseAngle, boolean solid) {
    this.out = out.open("IndexedFaceSet");
    if (creaseAngle > 0) {
      out.attribute("creaseAngle", DecimalFormatter.rounded(creaseAngle, 3));
    }
    if (!solid) {
      out.attribute("solid", "false");
    }
  }

  /**
   * Writes a field of indices.
   *
   * @param triangles the indices of the triangles
   */
  public IndexedFaceSetWriter index(String field, TupleListBuilder triangles) {
    out.ownLine().numbers(field, triangles.text());
    return this;
  }

  /** Writes a node of values: {@code Coordinate point}, {@code Color color} and so on. */
  public IndexedFaceSetWriter values(String node, String field, TupleListBuilder values) {
    out.open(node).numbers(field, values.text()).close();
    return this;
  }

  /** Ends the node. */
  public void close() {
    out.close();
  }
}
