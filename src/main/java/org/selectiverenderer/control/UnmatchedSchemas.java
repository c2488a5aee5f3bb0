package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.control.ControlProblem.Severity;
import org.selectiverenderer.schema.SchemaNames;
import org.web3d.x3d.sai.X3DNode;

/**
 * Schemas that have an effect nowhere: of objects, but activated by no area, or activated on entry,
 * but of no object. Both may be meant, so they are only mentioned, unless the other side has nearly
 * the same name. A schema that says of all its objects what they show from the start needs no area
 * (thesis 5.4.3: the kitchen has no sensor), and exit schemas are often activated for the sake of
 * order alone: neither is mentioned.
 */
final class UnmatchedSchemas {
  private record Namer(String name, X3DNode node) {}

  private UnmatchedSchemas() {}

  /** One problem for each such schema, at the first node that names it. */
  static List<ControlProblem> of(Collection<Area> areas, Collection<VersionedObject> objects) {
    Map<String, Area> entered = new LinkedHashMap<>();
    Set<String> activated = new TreeSet<>();
    for (Area area : areas) {
      area.schemas()
          .ifPresent(
              schemas -> {
                schemas.enter().forEach(schema -> entered.putIfAbsent(schema, area));
                activated.addAll(schemas.enter());
                activated.addAll(schemas.exit());
              });
    }
    Map<String, VersionedObject> known = new LinkedHashMap<>();
    for (VersionedObject object : objects) {
      object
          .schemas()
          .ifPresent(
              schemas ->
                  schemas
                      .choices()
                      .forEach(c -> c.schemas().forEach(s -> known.putIfAbsent(s, object))));
    }
    List<ControlProblem> problems = new ArrayList<>();
    known.forEach(
        (schema, object) -> {
          if (!activated.contains(schema)) {
            ControlProblem problem =
                problem(
                    new Namer(object.name(), object.node()),
                    "no area of the scene activates the schema " + schema,
                    schema,
                    activated);
            boolean meant = objects.stream().allMatch(o -> o.showedAtStart(schema));
            if (!meant || problem.severity() != Severity.INFO) {
              problems.add(problem);
            }
          }
        });
    entered.forEach(
        (schema, area) -> {
          if (!known.containsKey(schema)) {
            problems.add(
                problem(
                    new Namer(area.name(), area.sensor()),
                    "no Switch of the scene belongs to the schema " + schema,
                    schema,
                    known.keySet()));
          }
        });
    return problems;
  }

  private static ControlProblem problem(
      Namer namer, String what, String schema, Collection<String> others) {
    return SchemaNames.probablyMeant(schema, others)
        .map(meant -> warning(namer, what + "; is " + meant + " meant? It has no effect"))
        .orElseGet(
            () ->
                new ControlProblem(
                    namer.name(), namer.node(), Severity.INFO, what + "; it has no effect"));
  }

  private static ControlProblem warning(Namer namer, String message) {
    return ControlProblem.warning(namer.name(), namer.node(), message);
  }
}
