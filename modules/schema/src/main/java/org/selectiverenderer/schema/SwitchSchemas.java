package org.selectiverenderer.schema;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The schema metadata of the versions of an object (thesis Figs 43, 52, 78). MetadataSet <i>i</i>
 * describes child <i>i</i> of the Switch, since Fig 49 sets {@code whichChoice} to the index of the
 * matching set.
 *
 * @param choices one for each MetadataSet, in order; at least one, at most as many as the Switch
 *     has children
 * @param quality what the versions differ in
 */
public record SwitchSchemas(List<VersionMetadata> choices, Quality quality) {
  /** Makes the schemas of versions that differ in their polygons, as the thesis's do. */
  public SwitchSchemas(List<VersionMetadata> choices) {
    this(choices, Quality.POLYGONS);
  }

  /** Checks that each choice is at the position of its index. */
  public SwitchSchemas {
    choices = List.copyOf(choices);
    for (int i = 0; i < choices.size(); i++) {
      if (choices.get(i).index() != i) {
        throw new IllegalArgumentException("choice " + choices.get(i).index() + " at place " + i);
      }
    }
  }

  /**
   * Returns the child that each schema shows. If several sets name the same schema, the last one
   * counts, since the loop of Fig 49 sets {@code whichChoice} for each in turn.
   */
  public Map<String, Integer> choiceBySchema() {
    Map<String, Integer> map = new LinkedHashMap<>();
    for (VersionMetadata choice : choices) {
      for (String schema : choice.schemas()) {
        map.put(schema, choice.index());
      }
    }
    return map;
  }

  /** Returns the schemas of each choice, in order. */
  public List<List<String>> byChoice() {
    return choices.stream().map(VersionMetadata::schemas).toList();
  }

  /** Returns the most detailed child: the least consistent one, the first of equals. */
  public int mostDetailed() {
    int best = 0;
    for (VersionMetadata choice : choices) {
      if (choice.consistency() < choices.get(best).consistency()) {
        best = choice.index();
      }
    }
    return best;
  }

  /** Returns the least detailed child: the most consistent one, the last of equals. */
  public int leastDetailed() {
    int best = 0;
    for (VersionMetadata choice : choices) {
      if (choice.consistency() >= choices.get(best).consistency()) {
        best = choice.index();
      }
    }
    return best;
  }
}
