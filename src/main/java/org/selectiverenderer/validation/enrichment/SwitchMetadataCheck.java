package org.selectiverenderer.validation.enrichment;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.selectiverenderer.schema.NodeMetadata;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneView;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;

/** The metadata of each Switch against its children. */
final class SwitchMetadataCheck implements SceneCheck {
  @Override
  public void check(SceneView scene, Findings findings) {
    Set<NodeView> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    for (ParsedNode node : scene.main().scene().nodes()) {
      visit(node, findings, seen);
    }
  }

  private static void visit(NodeView node, Findings findings, Set<NodeView> seen) {
    if (!seen.add(node)) {
      return;
    }
    if (node.type().name().equals("Switch")) {
      SchemaReader reader =
          new SchemaReader(
              problem -> {
                if (problem.kind() == SchemaProblem.Kind.FEWER_SETS_THAN_CHOICES) {
                  findings.add(EnrichmentRules.FEWER_SETS, node, problem.message());
                }
              });
      NodeMetadata.of(node)
          .ifPresent(metadata -> reader.switchNode(metadata, node.nodes("children").size()));
    }
    if (node.type().field("children").isPresent()) {
      node.nodes("children").forEach(child -> visit(child, findings, seen));
    }
  }
}
