package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.export.ControlledNodes.Area;
import org.selectiverenderer.export.ControlledNodes.VersionedObject;
import org.selectiverenderer.polygon.SensorBox;

/**
 * The selective rendering controller without a Script, for browsers that run none: filters and
 * triggers (X3D 4.0, clause 30) turn entries into and exits out of areas into choices of Switches.
 * They remember nothing, so that no two areas may overlap that decide on the same object.
 */
final class ControllerRoutes {
  private final ControlledNodes nodes;
  private final UnaryOperator<String> names;

  /**
   * @param names turns a name into one that the scene does not have
   */
  ControllerRoutes(ControlledNodes nodes, UnaryOperator<String> names) {
    this.nodes = nodes;
    this.names = names;
  }

  /** Returns the types of the nodes in {@link #lines}. */
  static Set<String> types() {
    return Set.of("BooleanFilter", "IntegerTrigger");
  }

  /**
   * Reports the fields whose levels only a Script chooses.
   *
   * @return whether anything is left to do
   */
  static boolean carries(ControlledNodes nodes, ProblemCollector problems) {
    for (ControlledField field : nodes.fields()) {
      problems.warning(
          field.location(),
          "%s keeps its value, since only the Script sets fields; export without --without-script"
              .formatted(field.target()));
    }
    if (nodes.objects().isEmpty() && !nodes.fields().isEmpty()) {
      problems.error(
          nodes.fields().get(0).location(),
          "no object has versions, and only the Script sets fields;"
              + " export without --without-script");
      return false;
    }
    return true;
  }

  /**
   * Reports, as errors, the areas that only a Script can tell apart.
   *
   * @param places the areas whose positions the scene determines
   * @return whether there are none
   */
  boolean decided(List<AreaInstance> places, ProblemCollector problems) {
    boolean all = true;
    for (int i = 0; i < nodes.areas().size(); i++) {
      for (Area other : nodes.areas().subList(i + 1, nodes.areas().size())) {
        Area area = nodes.areas().get(i);
        Optional<String> contested = contested(area, other);
        if (contested.isEmpty()) {
          continue;
        }
        Optional<AreaInstance> one = place(area, places);
        Optional<AreaInstance> two = place(other, places);
        if (one.isEmpty() || two.isEmpty() || share(one.get(), two.get())) {
          problems.error(
              other.location(),
              "the areas %s and %s %s, and both decide on %s, for which only the Script keeps account;"
                      .formatted(
                          area.def(),
                          other.def(),
                          one.isEmpty() || two.isEmpty() ? "may overlap" : "overlap",
                          contested.get())
                  + " move them apart, or export without --without-script");
          all = false;
        }
      }
    }
    return all;
  }

  private static Optional<AreaInstance> place(Area area, List<AreaInstance> places) {
    List<AreaInstance> found =
        places.stream().filter(place -> place.name().equals(area.def())).toList();
    return found.size() == 1 && found.get(0).elsewhere().isEmpty()
        ? Optional.of(found.get(0))
        : Optional.empty();
  }

  private static boolean share(AreaInstance one, AreaInstance two) {
    return one.solid().isPresent()
        && two.solid().isPresent()
        && SensorBox.share(List.of(one.solid().get(), two.solid().get()));
  }

  /** Returns an object that one area would change while the other one claims it. */
  private Optional<String> contested(Area one, Area two) {
    return nodes.objects().stream()
        .filter(
            object ->
                claims(one, object) && changes(two, object)
                    || claims(two, object) && changes(one, object))
        .map(VersionedObject::def)
        .findFirst();
  }

  private static boolean claims(Area area, VersionedObject object) {
    return choice(object, area.schemas().enter()).isPresent();
  }

  private static boolean changes(Area area, VersionedObject object) {
    return claims(area, object) || choice(object, area.schemas().exit()).isPresent();
  }

  /** Returns the choice of an object for the last schema of a list that it has one for. */
  private static Optional<Integer> choice(VersionedObject object, List<String> schemas) {
    Map<String, Integer> choices = object.schemas().choiceBySchema();
    for (int i = schemas.size() - 1; i >= 0; i--) {
      Integer choice = choices.get(schemas.get(i));
      if (choice != null) {
        return Optional.of(choice);
      }
    }
    return Optional.empty();
  }

  /** Returns the nodes and their ROUTEs as lines of X3D XML. */
  List<String> lines() {
    List<String> declared = new ArrayList<>();
    Set<String> routes = new LinkedHashSet<>();
    for (Area area : nodes.areas()) {
      Map<Integer, List<String>> entered = objects(area.schemas().enter());
      Map<Integer, List<String>> left = objects(area.schemas().exit());
      if (entered.isEmpty() && left.isEmpty()) {
        continue;
      }
      String filter = names.apply(area.def() + "_Enters");
      declared.add(node("BooleanFilter", filter, ""));
      routes.add(ControllerScript.route(area.def(), "isActive", filter, "set_boolean"));
      triggers(area, "_Shows", filter, "inputTrue", entered, declared, routes);
      if (!left.isEmpty()) {
        // Some browsers trigger at TRUE only, so that the exit is turned into that.
        String exit = names.apply(area.def() + "_Leaves");
        declared.add(node("BooleanFilter", exit, ""));
        routes.add(ControllerScript.route(filter, "inputFalse", exit, "set_boolean"));
        triggers(area, "_Returns", exit, "inputNegate", left, declared, routes);
      }
    }
    List<String> lines = new ArrayList<>(declared);
    lines.addAll(routes);
    return lines;
  }

  /** Returns the objects that have a choice for one of the schemas, by this choice. */
  private Map<Integer, List<String>> objects(List<String> schemas) {
    Map<Integer, List<String>> found = new LinkedHashMap<>();
    for (VersionedObject object : nodes.objects()) {
      choice(object, schemas)
          .ifPresent(
              choice -> found.computeIfAbsent(choice, key -> new ArrayList<>()).add(object.def()));
    }
    return found;
  }

  private void triggers(
      Area area,
      String suffix,
      String filter,
      String output,
      Map<Integer, List<String>> objects,
      List<String> declared,
      Set<String> routes) {
    objects.forEach(
        (choice, switches) -> {
          String trigger = names.apply(area.def() + suffix + choice);
          declared.add(node("IntegerTrigger", trigger, " integerKey=\"" + choice + "\""));
          routes.add(ControllerScript.route(filter, output, trigger, "set_boolean"));
          for (String object : switches) {
            routes.add(ControllerScript.route(trigger, "triggerValue", object, "whichChoice"));
          }
        });
  }

  private static String node(String type, String def, String fields) {
    return "<%s DEF=\"%s\"%s/>".formatted(type, MarkupEscaper.attribute(def), fields);
  }
}
