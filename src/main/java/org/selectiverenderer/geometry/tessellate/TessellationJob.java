package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** One node on its way to a mesh: where its fields, its problems and its tally are. */
final class TessellationJob {
  private final NodeView node;
  private final Problems problems;
  private int degenerate;

  TessellationJob(NodeView node, Problems problems) {
    this.node = node;
    this.problems = problems;
  }

  NodeView node() {
    return node;
  }

  /** Reports what is wrong with the node: {@code text} goes on where the node's name ends. */
  void problem(String text) {
    String name = node.name();
    String subject = name == null ? node.type().name() : node.type().name() + " " + name;
    problems.warning(node.location(), subject + " " + text);
  }

  void countDegenerate(int triangles) {
    degenerate += triangles;
  }

  int degenerate() {
    return degenerate;
  }

  /**
   * Whether the fields are finite and above zero; if not, says so and that the node is left out.
   */
  boolean positive(String... fields) {
    for (String field : fields) {
      Object value = node.value(field);
      float[] numbers = value instanceof float[] array ? array : new float[] {(Float) value};
      for (float number : numbers) {
        if (!(number > 0 && number < Float.POSITIVE_INFINITY)) {
          problem("has a " + field + " that is not above 0; it is left out");
          return false;
        }
      }
    }
    return true;
  }
}
