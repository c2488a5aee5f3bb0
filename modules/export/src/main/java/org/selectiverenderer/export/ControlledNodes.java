package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/**
 * The enriched nodes of a scene, in its order, and the fields that are qualities of objects.
 * Choices and levels are numbered: first the choices of the objects, in their order, then the
 * levels of the fields.
 *
 * @param areas the ProximitySensors whose metadata name schemas
 * @param objects the Switches whose metadata describe versions
 * @param fields the fields whose levels metadata describe
 * @param order the numbers of choices and levels in the order of the scene, each object before its
 *     fields
 */
record ControlledNodes(
    List<Area> areas,
    List<VersionedObject> objects,
    List<ControlledField> fields,
    List<Integer> order) {
  /** Tells the random seeds of qualities apart, as in the controller. */
  private static final int SPREAD = 1_000_003;

  /** The names of the field of a Switch that says which child it shows, in ROUTEs. */
  static final Set<String> CHOICE_FIELDS =
      Set.of("whichChoice", "set_whichChoice", "whichChoice_changed");

  ControlledNodes {
    areas = List.copyOf(areas);
    objects = List.copyOf(objects);
    fields = List.copyOf(fields);
    order = List.copyOf(order);
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

  /**
   * The choices of one quality, of which the condition random draws a half.
   *
   * @param members their numbers, in the order of the scene
   * @param seed added to the random seed
   */
  record Lot(List<Integer> members, int seed) {
    Lot {
      members = List.copyOf(members);
    }
  }

  /**
   * Returns the enriched nodes of a document, all of which have DEF names.
   *
   * @param problems receives warnings of fields that cannot be set
   */
  static ControlledNodes of(
      DocumentEnrichment enrichment, NodeCatalogue catalogue, ProblemCollector problems) {
    List<Area> areas =
        enrichment.sensors().stream()
            .filter(EnrichedSensor::enriched)
            .map(sensor -> new Area(sensor.name(), sensor.schemas(), sensor.element().location()))
            .toList();
    List<VersionedObject> objects = new ArrayList<>();
    List<ControlledField> fields = new ArrayList<>();
    List<int[]> places = new ArrayList<>(); // of an object, or of a field and 1
    Set<String> routed = routed(enrichment);
    ControlledFieldFinder finder = new ControlledFieldFinder(enrichment, catalogue, problems);
    for (EnrichedSwitch node : enrichment.switches()) {
      if (node.schemas().isPresent()) {
        boolean more = routed.contains(node.name());
        places.add(new int[] {objects.size(), 0});
        objects.add(
            new VersionedObject(node.name(), node.schemas().get(), node.whichChoice(), more));
      }
      for (ControlledField field : finder.of(node)) {
        places.add(new int[] {fields.size(), 1});
        fields.add(field);
      }
    }
    List<Integer> order =
        places.stream().map(place -> place[0] + place[1] * objects.size()).toList();
    return new ControlledNodes(areas, objects, ControlledField.sharing(fields), order);
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

  /** Returns the schemas of all choices and levels, by their numbers. */
  List<SwitchSchemas> schemas() {
    List<SwitchSchemas> all = new ArrayList<>();
    objects.forEach(object -> all.add(object.schemas()));
    fields.forEach(field -> all.add(field.schemas()));
    return all;
  }

  /** Returns the choices of which the condition random draws, each quality by itself. */
  List<Lot> lots() {
    List<SwitchSchemas> schemas = schemas();
    Map<Quality, List<Integer>> members = new EnumMap<>(Quality.class);
    for (int number : order) {
      members
          .computeIfAbsent(schemas.get(number).quality(), quality -> new ArrayList<>())
          .add(number);
    }
    List<Lot> lots = new ArrayList<>();
    members.forEach((quality, numbers) -> lots.add(new Lot(numbers, SPREAD * quality.ordinal())));
    return lots;
  }

  /**
   * Returns the choice of each object, in their order, and then the level of each field, under a
   * condition that never changes them; nothing under one that does.
   */
  List<Integer> choices(Condition condition, long seed) {
    if (condition.switches()) {
      return List.of();
    }
    List<SwitchSchemas> schemas = schemas();
    Integer[] choices = new Integer[schemas.size()];
    for (Lot lot : lots()) {
      Map<Integer, SwitchSchemas> byNumber = new LinkedHashMap<>();
      lot.members().forEach(number -> byNumber.put(number, schemas.get(number)));
      condition
          .initialChoices(byNumber, activated(), seed + lot.seed())
          .forEach((number, choice) -> choices[number] = choice);
    }
    return Arrays.asList(choices);
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
