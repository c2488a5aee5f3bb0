package org.selectiverenderer.validation.enrichment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks the metadata of each Switch against its children. */
final class SwitchMetadataCheck implements EnrichedSceneCheck {
  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isObject(node)) {
        NodeViewMetadata.of(node).ifPresent(metadata -> check(scene, node, metadata, findings));
      }
    }
  }

  private static void check(
      EnrichedScene scene, ParsedNode node, NodeViewMetadata metadata, FindingCollector findings) {
    List<NodeViewMetadata> sets =
        metadata.children().stream().filter(NodeViewMetadata::isSet).toList();
    int children = EnrichedScene.children(node);
    boolean[] ours = {false};
    SchemaReader reader =
        new SchemaReader(
            problem -> {
              ours[0] = true;
              report(problem, scene.file(node), sets, children, findings);
            });
    SwitchSchemas schemas = reader.switchNode(metadata, children).orElse(null);
    if (schemas != null) {
      claims(schemas, node, findings);
    }
    if (schemas != null || ours[0]) {
      range(scene, node, children, findings);
    }
  }

  private static void report(
      SchemaProblem problem,
      FileOutline file,
      List<NodeViewMetadata> sets,
      int children,
      FindingCollector findings) {
    NodeViewMetadata at = (NodeViewMetadata) problem.metadata();
    NodeView node = at.node();
    switch (problem.kind()) {
      case FEWER_SETS_THAN_CHOICES ->
          findings.add(
              SwitchRules.FEWER_SETS,
              node,
              CountPhrases.sets(sets),
              CountPhrases.children(children));
      case MORE_SETS_THAN_CHOICES ->
          findings.add(
              SwitchRules.MORE_SETS,
              node,
              CountPhrases.sets(sets),
              CountPhrases.children(children));
      case NO_SCHEMA -> findings.add(SwitchRules.NO_SCHEMA, node, Math.max(0, sets.indexOf(at)));
      case UNKNOWN_TYPE ->
          findings.addAt(SwitchRules.UNKNOWN_TYPE, file, node, "value", first(at), meant(at));
      case UNKNOWN_DEGREE ->
          findings.addAt(SwitchRules.UNKNOWN_DEGREE, file, node, "value", first(at));
      case SEVERAL_VALUES ->
          findings.addAt(SwitchRules.SEVERAL_VALUES, file, node, "value", at.name().strip());
      case MISPLACED ->
          findings.addAt(
              SchemaRules.MISPLACED,
              file,
              node,
              "name",
              at.name().strip(),
              MisplacedMetadataMessages.inSwitch(at));
      case UNKNOWN_QUALITY -> FieldQualityCheck.unknownQuality(at, file, findings);
      case SEVERAL_QUALITIES ->
          findings.add(FieldQualityRules.SEVERAL_QUALITIES, node, quality(at));
      case UNKNOWN_FIELD, FIELD_TWICE, NO_VALUE -> {
        // About field qualities, which have a check of their own.
      }
    }
  }

  private static String quality(NodeViewMetadata set) {
    return set.children().stream()
        .filter(child -> !child.isSet() && child.name().strip().equals("quality"))
        .flatMap(child -> child.values().stream())
        .findFirst()
        .orElse("another one");
  }

  private static String meant(NodeViewMetadata at) {
    List<String> known =
        Stream.of(ConsistencyType.values()).map(t -> t.name().toLowerCase(Locale.ROOT)).toList();
    return SpellingSuggester.nearest(at.values().get(0), known)
        .map(near -> "; did you mean " + near + "?")
        .orElse("");
  }

  private static String first(NodeViewMetadata at) {
    return "'" + at.values().get(0) + "'";
  }

  /** Finds schemas that several sets name. */
  private static void claims(SwitchSchemas schemas, ParsedNode node, FindingCollector findings) {
    Map<String, List<Integer>> claims = new LinkedHashMap<>();
    for (VersionMetadata choice : schemas.choices()) {
      for (String schema : choice.schemas()) {
        claims.computeIfAbsent(schema, key -> new ArrayList<>()).add(choice.index());
      }
    }
    claims.forEach(
        (schema, choices) -> {
          if (choices.size() > 1) {
            String list = choices.stream().map(String::valueOf).collect(Collectors.joining(", "));
            findings.add(SwitchRules.CLAIMED_TWICE, node, list, schema);
          }
        });
  }

  private static void range(
      EnrichedScene scene, ParsedNode node, int children, FindingCollector findings) {
    int choice = node.integer("whichChoice");
    if ((choice >= children || choice < -1) && !scene.driven(node, "whichChoice")) {
      findings.addAt(
          SwitchRules.OUT_OF_RANGE,
          scene.file(node),
          node,
          "whichChoice",
          choice,
          CountPhrases.children(children));
    }
  }

  /** Counts with their nouns, for messages. */
  private static final class CountPhrases {
    private CountPhrases() {}

    /**
     * Returns the number of sets in a Switch's metadata; metadata without sets count as one set for
     * the first child.
     */
    static String sets(List<NodeViewMetadata> sets) {
      int count = Math.max(1, sets.size());
      return count + (count == 1 ? " MetadataSet" : " MetadataSets");
    }

    static String children(int count) {
      return count + (count == 1 ? " child" : " children");
    }
  }
}
