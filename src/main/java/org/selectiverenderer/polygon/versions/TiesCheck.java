package org.selectiverenderer.polygon.versions;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.SceneElement;

/**
 * Finds what would break if an object moved to a file of its own: names are known within one file
 * only.
 */
final class TiesCheck {
  private final SceneElement root;
  private final Problems problems;

  TiesCheck(SceneElement root, Problems problems) {
    this.root = root;
    this.problems = problems;
  }

  /**
   * Whether the elements can move; reports what hinders them.
   *
   * @param def the name that the author knows the object by
   */
  boolean free(String def, List<SceneElement> elements) {
    Set<String> names = new HashSet<>();
    for (SceneElement element : elements) {
      element.visit(inner -> inner.attribute("DEF").ifPresent(names::add));
    }
    boolean[] free = {true};
    root.visit(
        other -> {
          boolean inside = elements.stream().anyMatch(element -> element.contains(other));
          String tie = inside ? inside(other) : outside(other, def, names);
          if (!tie.isEmpty()) {
            problems.error(
                other.location(),
                "%s, so the object '%s' cannot be replaced; nothing has been changed"
                    .formatted(tie, def));
            free[0] = false;
          }
        });
    return free[0];
  }

  private static String inside(SceneElement element) {
    return switch (element.name()) {
      case "Script", "ProtoDeclare", "ExternProtoDeclare", "ROUTE", "IMPORT", "EXPORT" ->
          "a " + element.name() + " is part of it";
      default -> "";
    };
  }

  private static String outside(SceneElement element, String def, Set<String> names) {
    String used = element.attribute("USE").orElse("");
    if (used.equals(def) || names.contains(used)) {
      return "'" + used + "' is USEd here";
    }
    for (String end : List.of("fromNode", "toNode", "localDEF", "inlineDEF")) {
      String name = element.attribute(end).orElse("");
      if (names.contains(name)) {
        return "the " + element.name() + " here is about '" + name + "'";
      }
    }
    return "";
  }
}
