package org.selectiverenderer.schema;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What the metadata says of the versions of an object (thesis Figs 43, 52, 78): MetadataSet
 * <i>i</i> describes child <i>i</i>, since Fig 49 sets {@code whichChoice} to the index of the
 * matching set.
 *
 * @param choices one for each MetadataSet, in order, so that the index is the place in the list; at
 *     least one, at most as many as there are children
 */
public record SwitchSchemas(List<Choice> choices) {
  /** Refuses choices that do not stand at the places of their indices. */
  public SwitchSchemas {
    choices = List.copyOf(choices);
    for (int i = 0; i < choices.size(); i++) {
      if (choices.get(i).index() != i) {
        throw new IllegalArgumentException("choice " + choices.get(i).index() + " at place " + i);
      }
    }
  }

  /**
   * Which child each schema shows. Where several sets name the same schema the last one counts: the
   * loop of Fig 49 sets {@code whichChoice} for each in turn.
   */
  public Map<String, Integer> choiceBySchema() {
    Map<String, Integer> map = new LinkedHashMap<>();
    for (Choice choice : choices) {
      for (String schema : choice.schemas()) {
        map.put(schema, choice.index());
      }
    }
    return map;
  }

  /** The child with the most detail: the least consistent one, the first of equals. */
  public int mostDetailed() {
    int best = 0;
    for (Choice choice : choices) {
      if (choice.consistency() < choices.get(best).consistency()) {
        best = choice.index();
      }
    }
    return best;
  }

  /** The child with the least detail: the most consistent one, the last of equals. */
  public int leastDetailed() {
    int best = 0;
    for (Choice choice : choices) {
      if (choice.consistency() >= choices.get(best).consistency()) {
        best = choice.index();
      }
    }
    return best;
  }
}
