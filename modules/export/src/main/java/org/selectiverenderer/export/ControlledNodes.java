package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * The enriched nodes of a scene, in its order.
 *
 * @param areas the ProximitySensors whose metadata name schemas
 * @param objects the Switches whose metadata describe versions
 */
record ControlledNodes(List<Area> areas, List<VersionedObject> objects) {
  /** The names of the field of a Switch that says which child it shows, in ROUTEs. */
  static final Set<String> CHOICE_FIELDS =
      Set.of("whichChoice", "set_whichChoice", "whichChoice_changed");

  ControlledNodes {
    areas = List.copyOf(areas);
    objects = List.copyOf(objects);
  }

  /**
   * An area.
   *
   * @param def DEF of the ProximitySensor
   * @param location where it stands
   */
  record Area(String def, SensorSchemas schemas, SourceLocation location) {}

  /**
   * An object in versions.
   *
   * @param def DEF of the Switch
   * @param whichChoice the choice that the file names; -1 for none
   * @param routed whether a ROUTE of the scene sets the choice, too
   */
  record VersionedObject(String def, SwitchSchemas schemas, int whichChoice, boolean routed) {}

  /** Returns the enriched nodes of a document, all of which have DEF names. */
  static ControlledNodes of(DocumentEnrichment enrichment) {
    List<Area> areas =
        enrichment.sensors().stream()
            .filter(EnrichedSensor::enriched)
            .map(sensor -> new Area(sensor.name(), sensor.schemas(), sensor.element().location()))
            .toList();
    List<VersionedObject> objects = new ArrayList<>();
    Set<String> routed = routed(enrichment);
    for (EnrichedSwitch node : enrichment.switches()) {
      node.schemas()
          .map(
              schemas ->
                  new VersionedObject(
                      node.name(), schemas, node.whichChoice(), routed.contains(node.name())))
          .ifPresent(objects::add);
    }
    return new ControlledNodes(areas, objects);
  }

  /** Returns the names of the nodes whose choice a ROUTE sets. */
  private static Set<String> routed(DocumentEnrichment enrichment) {
    Set<String> names = new LinkedHashSet<>();
    enrichment
        .document()
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              String field = element.text("toField").orElse("");
              if (element.name().equals("ROUTE") && CHOICE_FIELDS.contains(field)) {
                element.text("toNode").ifPresent(names::add);
              }
            });
    return names;
  }

  /** Returns the choice of each object, in their order, under a condition that never changes it. */
  List<Integer> choices(Condition condition, long seed) {
    Map<Integer, SwitchSchemas> byPlace = new LinkedHashMap<>();
    objects.forEach(object -> byPlace.put(byPlace.size(), object.schemas()));
    return List.copyOf(condition.initialChoices(byPlace, activated(), seed).values());
  }

  private Set<String> activated() {
    Set<String> activated = new LinkedHashSet<>();
    for (Area area : areas) {
      activated.addAll(area.schemas().enter());
      activated.addAll(area.schemas().exit());
    }
    return activated;
  }
}
