package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Which schemas the areas of a scene activate and which its objects belong to.
 *
 * @param <N> stands for a node
 */
public final class SchemaUse<N> {
  /**
   * A schema that has an effect nowhere.
   *
   * @param node the first that names it
   * @param message what is wrong and what is done about it
   * @param meant a schema of the other side with nearly the same name; without one, the schema may
   *     well be as it is on purpose
   */
  public record Unmatched<N>(String schema, N node, String message, Optional<String> meant) {}

  private final Map<String, N> entered = new LinkedHashMap<>();
  private final Map<String, N> left = new LinkedHashMap<>();
  private final Map<String, N> known = new LinkedHashMap<>();
  private final Set<String> changing = new HashSet<>();

  /** Takes note of an area's schemas. */
  public void area(N sensor, SensorSchemas schemas) {
    schemas.enter().forEach(schema -> entered.putIfAbsent(schema, sensor));
    schemas.exit().forEach(schema -> left.putIfAbsent(schema, sensor));
  }

  /**
   * Takes note of the schemas that an object belongs to.
   *
   * @param atStart the choice that the scene shows at the start
   */
  public void object(N switchNode, List<List<String>> schemasOfChoices, int atStart) {
    for (int i = 0; i < schemasOfChoices.size(); i++) {
      choice(switchNode, schemasOfChoices.get(i), i == atStart);
    }
  }

  /**
   * Takes note of the schemas that one choice of an object belongs to.
   *
   * @param atStart whether the scene shows it at the start
   */
  public void choice(N switchNode, List<String> schemas, boolean atStart) {
    for (String schema : schemas) {
      known.putIfAbsent(schema, switchNode);
      if (!atStart) {
        changing.add(schema);
      }
    }
  }

  /** Whether all that the other one says of schemas and nodes is so here, too. */
  public boolean sameAs(SchemaUse<N> other) {
    return entered.equals(other.entered)
        && left.equals(other.left)
        && known.equals(other.known)
        && changing.equals(other.changing);
  }

  /** The schemas that areas activate. */
  public Set<String> activated() {
    Set<String> activated = new LinkedHashSet<>(entered.keySet());
    activated.addAll(left.keySet());
    return activated;
  }

  /** The schemas that objects belong to. */
  public Set<String> known() {
    return new LinkedHashSet<>(known.keySet());
  }

  /**
   * Schemas of objects that no area activates, then those that entering an area activates and that
   * no object belongs to. A schema that says of all its objects what they show from the start needs
   * no area (thesis 5.4.3: the kitchen has no sensor), and exit schemas are often activated for the
   * sake of order alone: neither is among them, but for slips in a name.
   */
  public List<Unmatched<N>> unmatched() {
    Set<String> activated = activated();
    List<Unmatched<N>> unmatched = new ArrayList<>();
    known.forEach(
        (schema, node) -> {
          if (!activated.contains(schema)) {
            String what = "no area of the scene activates the schema " + schema;
            Unmatched<N> found = unmatched(schema, node, what, activated);
            if (changing.contains(schema) || found.meant().isPresent()) {
              unmatched.add(found);
            }
          }
        });
    entered.forEach(
        (schema, node) -> {
          if (!known.containsKey(schema)) {
            String what = "no Switch of the scene belongs to the schema " + schema;
            unmatched.add(unmatched(schema, node, what, known.keySet()));
          }
        });
    left.forEach(
        (schema, node) -> {
          if (!known.containsKey(schema) && !entered.containsKey(schema)) {
            String what = "no Switch of the scene belongs to the schema " + schema;
            Unmatched<N> found = unmatched(schema, node, what, known.keySet());
            boolean told = // from the object's side
                unmatched.stream().anyMatch(o -> o.meant().filter(schema::equals).isPresent());
            if (found.meant().isPresent() && !told) {
              unmatched.add(found);
            }
          }
        });
    return unmatched;
  }

  private Unmatched<N> unmatched(String schema, N node, String what, Collection<String> others) {
    Optional<String> meant = SchemaNames.probablyMeant(schema, others);
    String message =
        meant
            .map(name -> what + "; is " + name + " meant? It has no effect")
            .orElse(what + "; it has no effect");
    return new Unmatched<>(schema, node, message, meant);
  }
}
