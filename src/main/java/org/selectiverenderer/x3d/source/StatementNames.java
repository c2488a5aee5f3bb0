package org.selectiverenderer.x3d.source;

import java.util.Set;

/** The elements of X3D that are no nodes. */
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

  /** Whether an element is a statement and no node. */
  public static boolean is(String element) {
    return NAMES.contains(element);
  }
}
