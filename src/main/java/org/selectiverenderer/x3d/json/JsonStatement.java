package org.selectiverenderer.x3d.json;

/** Recognizes the elements that are statements, which are not contained in a field of a node. */
final class JsonStatement {
  private JsonStatement() {}

  static boolean is(String element) {
    return switch (element) {
      case "ROUTE",
          "IMPORT",
          "EXPORT",
          "IS",
          "connect",
          "ProtoDeclare",
          "ProtoInterface",
          "ProtoBody",
          "ExternProtoDeclare",
          "field",
          "fieldValue" ->
          true;
      default -> false;
    };
  }
}
