package org.selectiverenderer.x3d.json;

/** The elements that are in no field of a node, wherever they stand. */
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
