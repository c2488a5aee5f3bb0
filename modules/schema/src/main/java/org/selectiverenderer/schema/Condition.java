package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.ToIntFunction;

/**
 * The experimental condition: which versions of objects a participant sees (thesis 6.1.2, and 7.2
 * for the random condition).
 */
public enum Condition {
  /**
   * Selective rendering: objects follow the schemas of the areas that the viewer enters; at first
   * they are as in the scene.
   */
  SELECTIVE,
  /** All objects have all their polygons. */
  HIGH,
  /**
   * Consistent objects have few polygons; inconsistent ones, and those whose consistency varies
   * with the area, have all. Nothing changes.
   */
  HIGH_LOW,
  /** A random half of the objects has few polygons, regardless of schemas. */
  RANDOM;

  /**
   * Spreads seeds, because the first numbers of {@link Random} hardly differ for close seeds such
   * as 1 and 2.
   */
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  /** Returns the name on the command line, for example {@code high-low}. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns the condition of a name on the command line. */
  public static Optional<Condition> of(String spelling) {
    for (Condition condition : values()) {
      if (condition.spelling().equals(spelling)) {
        return Optional.of(condition);
      }
    }
    return Optional.empty();
  }

  /** Returns whether objects change as the viewer walks. */
  public boolean switches() {
    return this == SELECTIVE;
  }

  /**
   * Returns the choices that the condition sets before the first frame.
   *
   * @param switches the Switches in the order of the scene, on which the random choice depends
   * @param activated the schemas that entering or leaving some area activates
   * @param seed the random seed; the same seed and scene give the same choices on every machine
   * @return a choice for each switch, or none at all if the scene is to be left as it is
   */
  public <S> Map<S, Integer> initialChoices(
      Map<S, SwitchSchemas> switches, Set<String> activated, long seed) {
    return switch (this) {
      case SELECTIVE -> Map.of();
      case HIGH -> choose(switches, SwitchSchemas::mostDetailed);
      case HIGH_LOW -> choose(switches, schemas -> highLow(schemas, activated));
      case RANDOM -> lot(switches, new Random(seed * SPREAD));
    };
  }

  private static <S> Map<S, Integer> choose(
      Map<S, SwitchSchemas> switches, ToIntFunction<SwitchSchemas> rule) {
    Map<S, Integer> choices = new LinkedHashMap<>();
    switches.forEach((key, schemas) -> choices.put(key, rule.applyAsInt(schemas)));
    return choices;
  }

  /**
   * An object is consistent if all its versions that belong to a schema are of the same degree of
   * consistency, and of a high one. Only schemas that some area activates count; an object all of
   * whose schemas are activated by none, as in the kitchen (thesis 5.4.3), is judged by all of
   * them.
   */
  private static int highLow(SwitchSchemas schemas, Set<String> activated) {
    List<VersionMetadata> judged =
        schemas.choices().stream().filter(c -> !c.schemas().isEmpty()).toList();
    List<VersionMetadata> reachable =
        judged.stream().filter(c -> !Collections.disjoint(c.schemas(), activated)).toList();
    double[] degrees =
        (reachable.isEmpty() ? judged : reachable)
            .stream().mapToDouble(VersionMetadata::consistency).distinct().toArray();
    return degrees.length == 1 && degrees[0] > 0.5
        ? schemas.leastDetailed()
        : schemas.mostDetailed();
  }

  private static <S> Map<S, Integer> lot(Map<S, SwitchSchemas> switches, Random random) {
    List<S> drawn = new ArrayList<>(switches.keySet());
    int low = drawn.size() / 2;
    if (drawn.size() % 2 == 1 && random.nextBoolean()) {
      low++; // the odd one goes either way
    }
    Collections.shuffle(drawn, random);
    Set<S> lows = Set.copyOf(drawn.subList(0, low));
    Map<S, Integer> choices = new LinkedHashMap<>();
    switches.forEach(
        (key, schemas) ->
            choices.put(
                key, lows.contains(key) ? schemas.leastDetailed() : schemas.mostDetailed()));
    return choices;
  }
}
