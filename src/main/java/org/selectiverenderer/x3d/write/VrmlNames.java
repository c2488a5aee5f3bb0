package org.selectiverenderer.x3d.write;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Converts names to valid VRML names (ISO/IEC 19776-2, 4.3.2): invalid characters become
 * underscores, and different names remain different. For one file.
 */
final class VrmlNames {
  private final Map<String, String> written = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  String of(String name) {
    return written.computeIfAbsent(name, this::make);
  }

  private String make(String name) {
    StringBuilder text = new StringBuilder();
    for (char c : name.toCharArray()) {
      boolean ends = c <= ' ' || "\"#',.[\\]{}\u007f".indexOf(c) >= 0;
      text.append(ends ? '_' : c);
    }
    String plain = text.isEmpty() ? "_" : text.toString();
    String unique = plain;
    for (int i = 2; !taken.add(unique); i++) {
      unique = plain + "_" + i;
    }
    return unique;
  }
}
