package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * Shows a scene as if the viewer were in an area with a chosen set of schemas. As in the
 * controller, {@link SchemaActivation} decides what each Switch shows and which values the fields
 * have that are qualities of objects, starting from those of the scene.
 */
final class SchemaSimulator {
  private static final String AREA = "as if";

  private final Map<SwitchNode, Integer> atStart = new LinkedHashMap<>();
  private final Map<SwitchNode, SwitchSchemas> enriched = new LinkedHashMap<>();
  private final List<SimulatedField> fields = new ArrayList<>();
  private final EventCascade cascade;

  /** Finds the node of a name in the scope of a Switch. */
  interface Scope {
    Optional<Node> named(SwitchNode object, String name);
  }

  /**
   * @param switches the Switches of the scene and of its inlined files
   * @param scope finds the nodes whose fields are qualities
   */
  SchemaSimulator(Collection<SwitchNode> switches, Scope scope, EventCascade cascade) {
    this.cascade = cascade;
    SchemaReader reader = new SchemaReader(problem -> {}); // The document's findings report them.
    for (SwitchNode versions : switches) {
      atStart.put(versions, versions.whichChoice());
      Optional<SwitchSchemas> schemas =
          NodeViewMetadata.of(versions)
              .flatMap(metadata -> reader.switchNode(metadata, versions.children().size()));
      schemas.ifPresent(known -> enriched.put(versions, known));
      NodeViewMetadata.of(versions).map(reader::fieldQualities).orElse(List.of()).stream()
          .flatMap(
              quality ->
                  scope
                      .named(versions, quality.target().node())
                      .flatMap(node -> SimulatedField.of(quality, node))
                      .stream())
          .forEach(fields::add);
    }
  }

  /** Resets every Switch to its initial choice. */
  void reset() {
    atStart.forEach(this::show);
    fields.forEach(field -> field.show(SimulatedField.AT_START, cascade));
  }

  /**
   * Shows the scene as under some active schemas.
   *
   * @param schemas active schemas, of which later ones overrule earlier ones; none for the initial
   *     choices
   */
  void apply(List<String> schemas) {
    reset();
    SchemaActivation<String, SwitchNode> activation = new SchemaActivation<>();
    activation.putArea(AREA, new SensorSchemas(schemas, List.of()));
    enriched.forEach((node, known) -> activation.putSwitch(node, known, atStart.get(node)));
    for (SchemaActivation.Change<SwitchNode> change : new ArrayList<>(activation.enter(AREA))) {
      show(change.switchKey(), change.to());
    }
    SchemaActivation<String, SimulatedField> levels = new SchemaActivation<>();
    levels.putArea(AREA, new SensorSchemas(schemas, List.of()));
    fields.forEach(field -> levels.putSwitch(field, field.schemas(), SimulatedField.AT_START));
    for (SchemaActivation.Change<SimulatedField> change : new ArrayList<>(levels.enter(AREA))) {
      change.switchKey().show(change.to(), cascade);
    }
  }

  /** Sets every enriched Switch to its most detailed version, and fields to their best levels. */
  void detailed() {
    reset();
    enriched.forEach((node, known) -> show(node, known.mostDetailed()));
    fields.forEach(field -> field.show(field.schemas().mostDetailed(), cascade));
  }

  /** Shows a version of one object, until another method is called. */
  void version(SwitchNode node, int choice) {
    show(node, choice);
  }

  private void show(SwitchNode node, int choice) {
    if (node.whichChoice() != choice) {
      cascade.send(node, node.type().indexOf("whichChoice"), choice);
    }
  }
}
