package org.selectiverenderer.study.dataset;

import java.util.LinkedHashMap;
import java.util.Map;

/** Makes columns whose cells are conditions, with an explanation of each condition. */
final class ConditionColumnFactory {
  private ConditionColumnFactory() {}

  /** Returns a column named {@code condition}. */
  static TableColumn column(String meaning) {
    return column("condition", meaning);
  }

  static TableColumn column(String name, String meaning) {
    Map<String, String> levels = new LinkedHashMap<>();
    levels.put("high", "every object has all its polygons");
    levels.put(
        "high-low",
        "expected objects are reduced in every area, all others have all their polygons");
    levels.put(
        "selective", "which objects are reduced follows the areas that the participant enters");
    levels.put("random", "half of the objects, drawn at random, are reduced");
    return TableColumn.category(name, levels, meaning);
  }
}
