package org.selectiverenderer.x3d.tessellate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** What the tests of the geometry nodes share. */
abstract class AbstractTessellatorTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  final Tessellator tessellator = new Tessellator();
  final ProblemCollector problems = new ProblemCollector();

  /** A node; fields alternate names and values. */
  static ParsedNode node(String typeName, Object... fields) {
    NodeType type = CATALOGUE.get(typeName);
    ParsedNode node = new ParsedNode(type, null, new SourceLocation("test.x3d", 1, 1));
    for (int i = 0; i < fields.length; i += 2) {
      node.put(type.indexOf((String) fields[i]), fields[i + 1]);
    }
    return node;
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
    MeshProperties.assertSound(mesh);
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
