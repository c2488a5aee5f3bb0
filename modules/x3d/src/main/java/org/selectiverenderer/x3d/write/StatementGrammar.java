package org.selectiverenderer.x3d.write;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The grammar of statements (ISO/IEC 19776-1, 4.3): which attributes they have and need, and what
 * may contain them.
 */
final class StatementGrammar {
  private static final Set<String> OF_HTML = Set.of("class", "id", "style");

  private static final Map<String, List<String>> ATTRIBUTES =
      Map.ofEntries(
          Map.entry("X3D", List.of("profile", "version")),
          Map.entry("component", List.of("name", "level")),
          Map.entry("unit", List.of("category", "name", "conversionFactor")),
          Map.entry("meta", List.of("name", "content", "dir", "http-equiv", "lang", "scheme")),
          Map.entry("ROUTE", List.of("fromNode", "fromField", "toNode", "toField")),
          Map.entry("IMPORT", List.of("inlineDEF", "importedDEF", "AS")),
          Map.entry("EXPORT", List.of("localDEF", "AS")),
          Map.entry("connect", List.of("nodeField", "protoField")),
          Map.entry("ProtoDeclare", List.of("name", "appinfo", "documentation")),
          Map.entry("ExternProtoDeclare", List.of("name", "url", "appinfo", "documentation")),
          Map.entry("ProtoInstance", List.of("name")),
          Map.entry(
              "field", List.of("name", "type", "accessType", "value", "appinfo", "documentation")),
          Map.entry("fieldValue", List.of("name", "value")));

  private static final Map<String, List<String>> NEEDED =
      Map.of(
          "component", List.of("name"),
          "unit", List.of("category", "name"),
          "ROUTE", List.of("fromNode", "fromField", "toNode", "toField"),
          "IMPORT", List.of("inlineDEF", "importedDEF"),
          "EXPORT", List.of("localDEF"),
          "connect", List.of("nodeField", "protoField"),
          "ProtoDeclare", List.of("name"),
          "ExternProtoDeclare", List.of("name"),
          "field", List.of("name", "type", "accessType"),
          "fieldValue", List.of("name"));

  private StatementGrammar() {}

  /** Returns whether an attribute is one of those that HTML gives to all elements. */
  static boolean ofHtml(String attribute) {
    return OF_HTML.contains(attribute);
  }

  static boolean has(String statement, String attribute) {
    return ATTRIBUTES.getOrDefault(statement, List.of()).contains(attribute);
  }

  /** Returns whether ClassicVRML has a place for an attribute of a statement. */
  static boolean inClassicVrml(String statement, String attribute) {
    return switch (attribute) {
      case "appinfo", "documentation" -> false;
      default ->
          has(statement, attribute)
              && (!statement.equals("meta")
                  || attribute.equals("name")
                  || attribute.equals("content"));
    };
  }

  /** Returns why a statement cannot be used; null if its attributes are complete and valid. */
  static @Nullable String fault(DocumentElement element) {
    List<String> needed = NEEDED.getOrDefault(element.name(), List.of());
    for (String attribute : needed) {
      boolean earlier = attribute.equals("importedDEF") && element.text("exportedDEF").isPresent();
      if (element.text(attribute).isEmpty() && !earlier) {
        return element.name() + " needs " + String.join(", ", needed) + "; this one is left out";
      }
    }
    return switch (element.name()) {
      case "field" -> {
        boolean valid =
            FieldTypeResolver.of(element.text("type").orElse("")) != null
                && access(element) != null;
        yield valid
            ? null
            : "a field needs a type such as SFFloat, and one of the accessTypes initializeOnly,"
                + " inputOnly, outputOnly and inputOutput; this one is left out";
      }
      case "ProtoInstance" ->
          element.text("name").isPresent() || element.use().isPresent()
              ? null
              : "a ProtoInstance needs a name; it is left out";
      case "ProtoDeclare" ->
          element.children().stream().anyMatch(child -> child.name().equals("ProtoBody"))
              ? null
              : "a ProtoDeclare needs a ProtoBody; this one is left out";
      default -> null;
    };
  }

  /** Returns the access type of a field declaration; null if it is invalid. */
  static @Nullable AccessType access(DocumentElement field) {
    String spelling = field.text("accessType").orElse("");
    for (AccessType access : AccessType.values()) {
      if (access.spelling().equals(spelling)) {
        return access;
      }
    }
    return null;
  }

  /**
   * Returns whether an element may contain another.
   *
   * @param parent the containing element; null around the root
   * @param type the node type of the parent; null if it is a statement
   */
  static boolean contains(@Nullable DocumentElement parent, @Nullable NodeType type, String child) {
    String in = parent == null ? "" : parent.name();
    boolean node = type != null;
    return switch (child) {
      case "X3D" -> parent == null;
      case "head", "Scene" -> in.equals("X3D");
      case "component", "meta", "unit" -> in.equals("head");
      case "ProtoInterface", "ProtoBody" -> in.equals("ProtoDeclare");
      case "fieldValue" -> in.equals("ProtoInstance");
      case "IS" -> node || in.equals("ProtoInstance");
      case "connect" -> in.equals("IS");
      case "field" ->
          in.equals("ProtoInterface")
              || in.equals("ExternProtoDeclare")
              || type != null && type.field("field").isPresent();
      default ->
          switch (in) {
            case "Scene", "ProtoBody", "field", "fieldValue" -> true;
            default -> node;
          };
    };
  }

  /** Returns the type of an attribute of a statement; null if it is not known. */
  static @Nullable FieldType type(DocumentElement element, String attribute, PrototypeScope known) {
    return switch (element.name() + " " + attribute) {
      case "component level" -> FieldType.SFInt32;
      case "unit conversionFactor" -> FieldType.SFDouble;
      case "ExternProtoDeclare url" -> FieldType.MFString;
      case "field value" -> PrototypeScope.declaredType(element);
      case "fieldValue value" -> known.type(element);
      default -> FieldType.SFString;
    };
  }
}
