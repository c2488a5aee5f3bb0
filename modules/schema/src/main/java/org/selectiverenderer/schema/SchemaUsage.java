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
 * Compares the schemas that the areas of a scene activate with those that its objects belong to.
 *
 * @param <N> the type that represents a node
 */
public final class SchemaUsage<N> {
  /**
   * A schema without any effect.
   *
   * @param node the first node that names it
   * @param message a sentence for the author
   * @param meant a similar name among the schemas of the areas or objects to compare with; without
   *     one, the schema may be intended
   */
  public record Unmatched<N>(String schema, N node, String message, Optional<String> meant) {}

  private final Map<String, N> entered = new LinkedHashMap<>();
  private final Map<String, N> left = new LinkedHashMap<>();
  private final Map<String, N> known = new LinkedHashMap<>();
  private final Set<String> changing = new HashSet<>();

  /** Records the schemas of an area. */
  public void area(N sensor, SensorSchemas schemas) {
    schemas.enter().forEach(schema -> entered.putIfAbsent(schema, sensor));
    schemas.exit().forEach(schema -> left.putIfAbsent(schema, sensor));
  }

  /**
   * Records the schemas that an object belongs to.
   *
   * @param atStart the choice shown at the start of the scene
   */
  public void object(N switchNode, List<List<String>> schemasOfChoices, int atStart) {
    for (int i = 0; i < schemasOfChoices.size(); i++) {
      choice(switchNode, schemasOfChoices.get(i), i == atStart);
    }
  }

  /**
   * Records the schemas that one choice of an object belongs to.
   *
   * @param atStart whether it is shown at the start of the scene
   */
  public void choice(N switchNode, List<String> schemas, boolean atStart) {
    for (String schema : schemas) {
      known.putIfAbsent(schema, switchNode);
      if (!atStart) {
        changing.add(schema);
      }
    }
  }

  /** Returns whether both have recorded the same schemas and nodes. */
  public boolean sameAs(SchemaUsage<N> other) {
    return entered.equals(other.entered)
        && left.equals(other.left)
        && known.equals(other.known)
        && changing.equals(other.changing);
  }

  /** Returns the schemas that areas activate. */
  public Set<String> activated() {
    Set<String> activated = new LinkedHashSet<>(entered.keySet());
    activated.addAll(left.keySet());
    return activated;
  }

  /** Returns the schemas that objects belong to. */
  public Set<String> known() {
    return new LinkedHashSet<>(known.keySet());
  }

  /**
   * Returns the schemas of objects that no area activates, then the enter schemas of areas that no
   * object belongs to. A schema whose choices are shown from the start needs no area (thesis 5.4.3:
   * the kitchen has no sensor), and exit schemas are often activated for the sake of order alone;
   * both are included only if the name seems to be misspelt.
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
            boolean told = // already reported for the object
                unmatched.stream().anyMatch(o -> o.meant().filter(schema::equals).isPresent());
            if (found.meant().isPresent() && !told) {
              unmatched.add(found);
            }
          }
        });
    return unmatched;
  }

  private Unmatched<N> unmatched(String schema, N node, String what, Collection<String> others) {
    Optional<String> meant = SchemaNameMatcher.probablyMeant(schema, others);
    String message =
        meant
            .map(name -> what + "; is " + name + " meant? It has no effect")
            .orElse(what + "; it has no effect");
    return new Unmatched<>(schema, node, message, meant);
  }
}
