package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** The context of tessellating one node: its fields, its problems and its statistics. */
final class TessellationContext {
  private final NodeView node;
  private final ProblemCollector problems;
  private int degenerate;

  TessellationContext(NodeView node, ProblemCollector problems) {
    this.node = node;
    this.problems = problems;
  }

  NodeView node() {
    return node;
  }

  /** Reports a problem of the node; {@code text} is the predicate after the node's name. */
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
   * Returns whether the fields are finite and above zero; otherwise reports that the node is left
   * out.
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
