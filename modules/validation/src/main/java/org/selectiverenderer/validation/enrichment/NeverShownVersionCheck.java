package org.selectiverenderer.validation.enrichment;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Finds versions that are never shown. */
final class NeverShownVersionCheck implements EnrichedSceneCheck {
  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    scene.objects().forEach((object, schemas) -> enriched(scene, object, schemas, findings));
    if (scene.model().isPresent()) {
      for (ParsedNode node : scene.nodes()) {
        if (EnrichedScene.isObject(node) && !scene.objects().containsKey(node)) {
          bare(scene, node, findings);
        }
      }
    }
  }

  /**
   * Finds versions whose schemas are only activated together with later ones that override them.
   */
  private static void enriched(
      EnrichedScene scene, ParsedNode object, SwitchSchemas schemas, FindingCollector findings) {
    Map<String, Integer> choices = schemas.choiceBySchema();
    List<List<String>> activations =
        scene.areas().values().stream()
            .flatMap(area -> Stream.of(area.enter(), area.exit()))
            .toList();
    for (VersionMetadata choice : schemas.choices()) {
      Set<String> own = new TreeSet<>(choice.schemas());
      own.removeIf(schema -> choices.get(schema) != choice.index());
      own.removeIf(schema -> activations.stream().noneMatch(list -> list.contains(schema)));
      boolean shown =
          choice.index() == object.integer("whichChoice")
              || activations.stream()
                  .flatMap(list -> SchemaPrecedence.choice(list, choices).stream())
                  .anyMatch(index -> index == choice.index());
      if (!own.isEmpty() && !shown && !scene.driven(object, "whichChoice")) {
        findings.add(
            ObjectVersionRules.NEVER_SHOWN,
            object,
            choice.index(),
            "later schemas of the same areas overrule " + String.join(", ", own));
      }
    }
  }

  /** Finds Switches whose children look like versions, but which nothing ever switches. */
  private static void bare(EnrichedScene scene, ParsedNode node, FindingCollector findings) {
    List<? extends NodeView> children = node.nodes("children");
    int choice = node.integer("whichChoice");
    boolean versions =
        children.size() > 1
            && children.stream().allMatch(child -> child.type().name().equals("Inline"));
    if (versions && choice >= 0 && !scene.driven(node, "whichChoice")) {
      for (int i = 0; i < children.size(); i++) {
        if (i != choice) {
          findings.add(
              ObjectVersionRules.NEVER_SHOWN, node, i, "the Switch has no schema metadata");
        }
      }
    }
  }
}
