package org.selectiverenderer.models.scene;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** Makes the names of a model valid and unique as DEF names of one scene. */
public final class DefNames {
  private static final int LONGEST = 200;

  private final Set<String> taken = new HashSet<>();
  private final Map<String, Integer> counts = new HashMap<>();

  /**
   * Returns a name that no other part has.
   *
   * @param name the name in the model, or ""
   * @param otherwise the name for a part without one
   */
  public String unique(String name, String otherwise) {
    String valid = valid(name.isBlank() ? otherwise : name);
    String unique = valid;
    while (!taken.add(unique)) {
      unique = valid + "_" + counts.merge(valid, 1, Integer::sum);
    }
    return unique;
  }

  private static String valid(String name) {
    StringBuilder valid = new StringBuilder();
    name.codePoints()
        .limit(LONGEST)
        .forEach(
            c -> {
              boolean letter = Character.isLetter(c) || c == '_';
              boolean later = Character.isDigit(c) || c == '-' || c == '.';
              if (valid.length() == 0 && later) {
                valid.append('_');
              }
              valid.appendCodePoint(letter || later ? c : '_');
            });
    return valid.toString();
  }
}
