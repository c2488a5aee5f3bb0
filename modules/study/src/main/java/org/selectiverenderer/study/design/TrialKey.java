package org.selectiverenderer.study.design;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A trial in a recorded order.
 *
 * @param levels names of its levels by factor
 * @param line line of its stimulus in the list, from 1; 0 without a list
 */
public record TrialKey(Map<String, String> levels, int line) {
  public TrialKey {
    levels = new LinkedHashMap<>(levels);
  }
}
