package org.selectiverenderer.validation.enrichment;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Checks the names of metadata anywhere in the scene: Fig 40's spelling, misspellings, and metadata
 * in the wrong place.
 */
final class MetadataVocabularyCheck implements EnrichedSceneCheck {
  private static final int SLIPS = 2;
  private static final List<String> NAMES =
      Stream.of(SchemaField.values()).map(SchemaField::spelling).toList();

  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    for (ParsedNode node : scene.nodes()) {
      FileOutline file = scene.file(node);
      boolean ours = EnrichedScene.isArea(node) || EnrichedScene.isObject(node);
      words(
          node,
          at -> {
            if (ours) {
              spelling(at, file, findings);
            } else if (SchemaField.of(at.name()).isPresent()) {
              misplaced(at, "only ProximitySensors and Switches can have schemas", file, findings);
            }
          });
    }
  }

  private static void spelling(NodeViewMetadata at, FileOutline file, FindingCollector findings) {
    String name = at.name().strip();
    Optional<SchemaField> field = SchemaField.of(name);
    if (field.isPresent()) {
      if (!field.get().spelling().equals(name)) {
        findings.addAt(
            SchemaRules.OTHER_SPELLING, file, at.node(), "name", name, field.get().spelling());
      }
    } else {
      SpellingSuggester.nearest(name, NAMES, SLIPS)
          .ifPresent(
              near ->
                  findings.addAt(SchemaRules.UNKNOWN_NAME, file, at.node(), "name", name, near));
    }
  }

  private static void misplaced(
      NodeViewMetadata at, String reason, FileOutline file, FindingCollector findings) {
    findings.addAt(SchemaRules.MISPLACED, file, at.node(), "name", at.name().strip(), reason);
  }

  /** Visits all metadata of a node except sets. */
  private static void words(ParsedNode node, Consumer<NodeViewMetadata> consumer) {
    if (!node.type().is("X3DMetadataObject")) {
      NodeViewMetadata.of(node).ifPresent(metadata -> words(metadata, new HashSet<>(), consumer));
    }
  }

  private static void words(
      NodeViewMetadata metadata, Set<NodeViewMetadata> seen, Consumer<NodeViewMetadata> consumer) {
    if (seen.add(metadata)) {
      if (!metadata.isSet()) {
        consumer.accept(metadata);
      }
      metadata.children().forEach(child -> words(child, seen, consumer));
    }
  }
}
