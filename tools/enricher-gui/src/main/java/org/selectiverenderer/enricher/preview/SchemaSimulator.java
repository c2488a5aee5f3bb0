package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.polygon.metadata.NodeViewMetadata;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * Shows a scene as if the viewer were in an area with a chosen set of schemas. As in the
 * controller, {@link SchemaActivation} decides what each Switch shows, starting from the scene's
 * initial choices.
 */
final class SchemaSimulator {
  private static final String AREA = "as if";

  private final Map<SwitchNode, Integer> atStart = new LinkedHashMap<>();
  private final Map<SwitchNode, SwitchSchemas> enriched = new LinkedHashMap<>();
  private final EventCascade cascade;

  /**
   * @param switches the Switches of the scene and of its inlined files
   */
  SchemaSimulator(Collection<SwitchNode> switches, EventCascade cascade) {
    this.cascade = cascade;
    SchemaReader reader = new SchemaReader(problem -> {}); // The document's findings report them.
    for (SwitchNode versions : switches) {
      atStart.put(versions, versions.whichChoice());
      Optional<SwitchSchemas> schemas =
          NodeViewMetadata.of(versions)
              .flatMap(metadata -> reader.switchNode(metadata, versions.children().size()));
      schemas.ifPresent(known -> enriched.put(versions, known));
    }
  }

  /** Resets every Switch to its initial choice. */
  void reset() {
    atStart.forEach(this::show);
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
  }

  /** Sets every enriched Switch to its most detailed version. */
  void detailed() {
    reset();
    enriched.forEach((node, known) -> show(node, known.mostDetailed()));
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
