package org.selectiverenderer.x3d.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.Problem;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.TestNodes;

/** What the tests of the geometry nodes share. */
abstract class GeometryTest {
  private static final TestNodes NODES = new TestNodes();

  final Tessellator tessellator = new Tessellator();
  final Problems problems = new Problems();

  static NodeView node(String type, Object... fields) {
    return NODES.node(type, fields);
  }

  static NodeView coordinate(float... point) {
    return node("Coordinate", "point", point);
  }

  static NodeView color(float... color) {
    return node("Color", "color", color);
  }

  /** The node's mesh, sound. */
  Mesh mesh(NodeView node) {
    Mesh mesh = tessellator.tessellate(node, problems).orElseThrow();
    Measures.assertSound(mesh);
    return mesh;
  }

  /** The mesh of a node of which nothing is to be said. */
  Mesh mesh(String type, Object... fields) {
    Mesh mesh = mesh(node(type, fields));
    assertThat(problems.list()).isEmpty();
    return mesh;
  }

  List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }
}
