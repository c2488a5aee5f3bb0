package org.selectiverenderer.validation.enrichment;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Checks the field qualities of each Switch against the nodes of its file. */
final class FieldQualityCheck implements EnrichedSceneCheck {
  private final FieldParser parser = new FieldParser();

  @Override
  public void check(EnrichedScene scene, FindingCollector findings) {
    Map<FileOutline, Map<String, ParsedNode>> names = new IdentityHashMap<>();
    for (ParsedNode node : scene.nodes()) {
      if (EnrichedScene.isObject(node)) {
        NodeViewMetadata.of(node)
            .filter(metadata -> metadata.metadata().isPresent())
            .ifPresent(metadata -> check(metadata, scene.file(node), names, findings));
      }
    }
  }

  private void check(
      NodeViewMetadata metadata,
      FileOutline file,
      Map<FileOutline, Map<String, ParsedNode>> names,
      FindingCollector findings) {
    SchemaReader reader = new SchemaReader(problem -> report(problem, file, findings));
    for (FieldQuality quality : reader.fieldQualities(metadata)) {
      NodeViewMetadata set = setOf(metadata, quality.target()).orElse(metadata);
      Map<String, ParsedNode> named = names.computeIfAbsent(file, FieldQualityCheck::byName);
      Optional<ParsedNode> node = Optional.ofNullable(named.get(quality.target().node()));
      check(quality, node, set, file, findings);
    }
  }

  /** Returns the first node of each DEF name. */
  private static Map<String, ParsedNode> byName(FileOutline file) {
    Map<String, ParsedNode> nodes = new HashMap<>();
    for (ParsedNode node : file.nodes()) {
      String name = node.name();
      if (name != null) {
        nodes.putIfAbsent(name, node);
      }
    }
    return nodes;
  }

  private void check(
      FieldQuality quality,
      Optional<ParsedNode> node,
      NodeViewMetadata set,
      FileOutline file,
      FindingCollector findings) {
    FieldReference target = quality.target();
    if (node.isEmpty()) {
      boolean imported =
          file.scene().imports().stream().anyMatch(each -> each.as().equals(target.node()));
      if (!imported) {
        noField(set, file, "no node of the file has the DEF name " + target.node(), findings);
      }
      return;
    }
    Optional<FieldDefinition> field = node.get().type().field(target.field());
    if (field.filter(known -> known.access() == AccessType.INPUT_OUTPUT).isEmpty()) {
      noField(
          set,
          file,
          "%s has no inputOutput field %s".formatted(node.get().type().name(), target.field()),
          findings);
    } else if (!FieldQuality.TYPES.contains(field.get().type().name())) {
      noField(set, file, "metadata hold no value of type " + field.get().type(), findings);
    } else {
      values(quality, field.get().type(), set, file, findings);
    }
  }

  private void values(
      FieldQuality quality,
      FieldType type,
      NodeViewMetadata set,
      FileOutline file,
      FindingCollector findings) {
    List<NodeViewMetadata> values =
        set.children().stream()
            .filter(NodeViewMetadata::isSet)
            .flatMap(level -> named(level, "value").stream())
            .toList();
    for (int i = 0; i < Math.min(values.size(), quality.levels().size()); i++) {
      String text = String.join(" ", quality.levels().get(i).values()).strip();
      if (type.kind() != FieldType.Kind.STRING && !readable(type, text)) {
        findings.addAt(
            FieldQualityRules.NO_VALUE,
            file,
            values.get(i).node(),
            "value",
            "'%s' is no %s".formatted(text, type));
      }
    }
  }

  private boolean readable(FieldType type, String text) {
    FieldParser.Parsed parsed = parser.parse(type, text);
    return (type.multiple() || !text.isEmpty()) && parsed.flaws().isEmpty();
  }

  private static void noField(
      NodeViewMetadata set, FileOutline file, String reason, FindingCollector findings) {
    NodeViewMetadata at = named(set, "field").orElse(set);
    findings.addAt(FieldQualityRules.NO_FIELD, file, at.node(), "value", reason);
  }

  private static void report(SchemaProblem problem, FileOutline file, FindingCollector findings) {
    NodeViewMetadata at = (NodeViewMetadata) problem.metadata();
    switch (problem.kind()) {
      case UNKNOWN_QUALITY -> unknownQuality(at, file, findings);
      case UNKNOWN_FIELD ->
          findings.add(
              FieldQualityRules.NO_FIELD, at.node(), "it names no field, as in SofaTexture.url");
      case FIELD_TWICE ->
          findings.add(
              FieldQualityRules.FIELD_TWICE,
              at.node(),
              named(at, "field").map(FieldQualityCheck::text).orElse("a field"));
      case NO_VALUE ->
          findings.add(
              FieldQualityRules.NO_VALUE,
              at.node(),
              named(at, "field").isPresent() ? "there are no levels" : "there is no value");
      case NO_SCHEMA -> findings.add(FieldQualityRules.NO_SCHEMA, at.node());
      case UNKNOWN_DEGREE ->
          findings.addAt(SwitchRules.UNKNOWN_DEGREE, file, at.node(), "value", quoted(at));
      case UNKNOWN_TYPE ->
          findings.addAt(SwitchRules.UNKNOWN_TYPE, file, at.node(), "value", quoted(at), "");
      case SEVERAL_VALUES ->
          findings.addAt(SwitchRules.SEVERAL_VALUES, file, at.node(), "value", at.name().strip());
      default -> {
        // Others are about choices of the Switch.
      }
    }
  }

  /** Reports a word that is no quality, or a set without one. */
  static void unknownQuality(NodeViewMetadata at, FileOutline file, FindingCollector findings) {
    if (at.isSet()) {
      findings.add(FieldQualityRules.UNKNOWN_QUALITY, at.node(), "and is missing");
    } else {
      findings.addAt(
          FieldQualityRules.UNKNOWN_QUALITY, file, at.node(), "value", "not " + quoted(at));
    }
  }

  private static String quoted(NodeViewMetadata string) {
    return "'" + text(string) + "'";
  }

  private static String text(NodeViewMetadata string) {
    return string.values().stream().collect(Collectors.joining(" "));
  }

  /** Returns the set of the quality that sets a field. */
  private static Optional<NodeViewMetadata> setOf(NodeViewMetadata outer, FieldReference target) {
    return outer.metadata().stream()
        .flatMap(inner -> Stream.concat(inner.children().stream(), below(inner)))
        .filter(NodeViewMetadata::isSet)
        .filter(
            set ->
                named(set, "field")
                    .map(FieldQualityCheck::text)
                    .flatMap(FieldReference::of)
                    .filter(target::equals)
                    .isPresent())
        .findFirst();
  }

  private static Stream<NodeViewMetadata> below(NodeViewMetadata set) {
    return set.children().stream().flatMap(child -> child.children().stream());
  }

  private static Optional<NodeViewMetadata> named(NodeViewMetadata set, String name) {
    return set.children().stream()
        .filter(child -> !child.isSet() && child.name().strip().equals(name))
        .findFirst();
  }
}
