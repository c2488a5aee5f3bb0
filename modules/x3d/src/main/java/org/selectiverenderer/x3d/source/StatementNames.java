package org.selectiverenderer.x3d.source;

import java.util.Set;

/** The names of the X3D elements that are statements, not nodes. */
public final class StatementNames {
  private static final Set<String> NAMES =
      Set.of(
          "X3D",
          "head",
          "component",
          "meta",
          "unit",
          "Scene",
          "ROUTE",
          "IMPORT",
          "EXPORT",
          "IS",
          "connect",
          "ProtoDeclare",
          "ProtoInterface",
          "ProtoBody",
          "ExternProtoDeclare",
          "ProtoInstance",
          "field",
          "fieldValue");

  private StatementNames() {}

  /** Returns the names of all statements. */
  public static Set<String> all() {
    return NAMES;
  }

  /** Returns whether an element is a statement. */
  public static boolean is(String element) {
    return NAMES.contains(element);
  }
}
