package org.selectiverenderer.app.walk;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.schema.NodeMetadata;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * Mentions files that are inlined and hold enriched nodes: the SAI shows no node of an Inline's
 * scene (X3D 4.0, 9.4.2), so that the controller cannot render them selectively.
 */
final class InlinedEnrichment {
  private InlinedEnrichment() {}

  /** One INFO for each such file, at the first Inline that holds it. */
  static void report(Scene scene, Problems problems) {
    Set<String> seen = new HashSet<>();
    Deque<InlineNode> open = new ArrayDeque<>(visit(scene).inlines().values());
    while (!open.isEmpty()) {
      InlineNode inline = open.pop();
      Scene content = inline.content().orElse(null);
      if (content == null || !seen.add(content.url())) {
        continue;
      }
      Visit visit = visit(content);
      if (visit.enriched()) {
        problems.info(
            inline.location(),
            "the inlined file contains enriched nodes, which the controller cannot "
                + "see; move them into the scene itself, or they will not change");
      }
      open.addAll(visit.inlines().values());
    }
  }

  private record Visit(Map<String, InlineNode> inlines, boolean enriched) {}

  /** Looks at every node of a file: its Inlines, the first of each file, and its enrichment. */
  private static Visit visit(Scene scene) {
    Map<String, InlineNode> inlines = new LinkedHashMap<>();
    boolean enriched = false;
    Set<Node> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Node> open = new ArrayDeque<>();
    open.add(scene.root());
    while (!open.isEmpty()) {
      Node node = open.pop();
      if (!seen.add(node) || node.type().is("X3DShapeNode")) {
        continue;
      }
      if (node instanceof InlineNode inline) {
        inline.content().ifPresent(content -> inlines.putIfAbsent(content.url(), inline));
      }
      enriched |= isEnriched(node);
      for (FieldDefinition field : node.type().fields()) {
        if (field.type() == FieldType.MFNode) {
          open.addAll(node.nodes(field.name()));
        } else if (field.type() == FieldType.SFNode
            && node.value(field.index()) instanceof Node child) {
          open.add(child);
        }
      }
    }
    return new Visit(inlines, enriched);
  }

  private static boolean isEnriched(Node node) {
    SchemaReader reader = new SchemaReader(problem -> {});
    return switch (node.type().name()) {
      case "Switch" ->
          NodeMetadata.of(node)
              .flatMap(m -> reader.switchNode(m, node.nodes("children").size()))
              .isPresent();
      case "ProximitySensor" -> NodeMetadata.of(node).flatMap(reader::sensor).isPresent();
      default -> false;
    };
  }
}
