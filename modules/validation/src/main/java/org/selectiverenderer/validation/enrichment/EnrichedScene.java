package org.selectiverenderer.validation.enrichment;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.EnrichmentPolygonModel;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FileOutlineAdapter;
import org.selectiverenderer.validation.SceneContext;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * A scene with its areas and versioned objects, as the controller sees it.
 *
 * @param files the scene's own file and those that it inlines, by the name in their locations
 * @param nodes all nodes of these files, parents first, the scene's own file first
 * @param areas the ProximitySensors that name schemas
 * @param objects the Switches that name schemas
 * @param qualities the field qualities of Switches that have any
 * @param scripted whether there is a script, which may set any field and observe any node
 * @param counts the enrichment with polygon counts; null if there is neither area nor object
 */
record EnrichedScene(
    SceneContext view,
    Map<String, FileOutline> files,
    List<ParsedNode> nodes,
    Map<ParsedNode, SensorSchemas> areas,
    Map<ParsedNode, SwitchSchemas> objects,
    Map<ParsedNode, List<FieldQuality>> qualities,
    boolean scripted,
    @Nullable EnrichmentPolygonModel counts) {

  static EnrichedScene of(SceneContext view) {
    SchemaReader reader = new SchemaReader(problem -> {});
    Map<ParsedNode, SensorSchemas> areas = new LinkedHashMap<>();
    Map<ParsedNode, SwitchSchemas> objects = new LinkedHashMap<>();
    Map<ParsedNode, List<FieldQuality>> qualities = new LinkedHashMap<>();
    Map<String, FileOutline> files = new LinkedHashMap<>();
    view.files().forEach(file -> files.put(file.scene().source(), file));
    List<ParsedNode> nodes =
        files.values().stream().flatMap(file -> file.nodes().stream()).toList();
    for (ParsedNode node : nodes) {
      NodeViewMetadata metadata = isArea(node) || isObject(node) ? metadata(node) : null;
      if (metadata != null && isArea(node)) {
        reader.sensor(metadata).ifPresent(schemas -> areas.put(node, schemas));
      } else if (metadata != null) {
        reader.switchNode(metadata, children(node)).ifPresent(s -> objects.put(node, s));
        List<FieldQuality> found = reader.fieldQualities(metadata);
        if (!found.isEmpty()) {
          qualities.put(node, found);
        }
      }
    }
    boolean nothing = areas.isEmpty() && objects.isEmpty();
    return new EnrichedScene(
        view,
        files,
        nodes,
        areas,
        objects,
        qualities,
        nodes.stream().anyMatch(node -> node.type().name().equals("Script")),
        nothing ? null : FileOutlineAdapter.model(view));
  }

  private static @Nullable NodeViewMetadata metadata(ParsedNode node) {
    return NodeViewMetadata.of(node).orElse(null);
  }

  static boolean isArea(ParsedNode node) {
    return node.type().name().equals("ProximitySensor");
  }

  static boolean isObject(ParsedNode node) {
    return node.type().name().equals("Switch");
  }

  static int children(ParsedNode object) {
    return object.nodes("children").size();
  }

  /** Returns the file that contains a node. */
  FileOutline file(ParsedNode node) {
    return files.getOrDefault(node.location().file(), view.main());
  }

  /** Returns the enrichment with polygon counts; present if there is an area or an object. */
  Optional<EnrichmentPolygonModel> model() {
    return Optional.ofNullable(counts);
  }

  /** Returns whether a route or a script may set a field. */
  boolean driven(ParsedNode node, String field) {
    int index = node.type().indexOf(field);
    return scripted
        || file(node).scene().routes().stream()
            .anyMatch(route -> route.to() == node && route.toField() == index);
  }

  /** Returns whether a route starts at a node, or a script may observe it. */
  boolean heard(ParsedNode node) {
    return scripted
        || file(node).scene().routes().stream().anyMatch(route -> route.from() == node)
        || file(node).scene().exports().stream().anyMatch(e -> e.localDef().equals(node.name()));
  }
}
