package org.selectiverenderer.x3d.page;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.StatementNames;

/** The names of X3D for elements and attributes that a page writes in any case. */
final class PageNames {
  /** Attributes that are no fields, and those of statements. */
  private static final List<String> ATTRIBUTES =
      List.of(
          "DEF",
          "USE",
          "containerField",
          "name",
          "content",
          "version",
          "profile",
          "level",
          "category",
          "conversionFactor",
          "fromNode",
          "fromField",
          "toNode",
          "toField",
          "nodeField",
          "protoField",
          "type",
          "accessType",
          "value",
          "url",
          "inlineDEF",
          "importedDEF",
          "localDEF",
          "AS");

  private final NodeCatalogue catalogue;
  private final Map<String, String> elements = new HashMap<>();
  private final Map<String, String> common = new HashMap<>();
  private final Map<String, Map<String, String>> fields = new HashMap<>();

  PageNames(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
    catalogue.names().forEach(name -> elements.put(lower(name), name));
    StatementNames.all().forEach(name -> elements.put(lower(name), name));
    ATTRIBUTES.forEach(name -> common.put(lower(name), name));
  }

  static String lower(String name) {
    return name.toLowerCase(Locale.ROOT);
  }

  /** Returns the name of an element in X3D, or the given one if there is none. */
  String element(String written) {
    return elements.getOrDefault(lower(written), written);
  }

  /** Returns the name of an attribute in X3D, or the given one if there is none. */
  String attribute(String element, String written) {
    String lower = lower(written);
    String field = fields.computeIfAbsent(element, this::fieldsOf).get(lower);
    return field != null ? field : common.getOrDefault(lower, written);
  }

  private Map<String, String> fieldsOf(String element) {
    Map<String, String> names = new HashMap<>();
    NodeType type = catalogue.find(element).orElse(null);
    if (type != null) {
      for (FieldDefinition field : type.fields()) {
        names.put(lower(field.name()), field.name());
      }
    }
    return names;
  }

  /** Returns whether an attribute belongs to the page and not to the scene. */
  boolean ofPage(String element, String attribute) {
    String lower = lower(attribute);
    if (fields.computeIfAbsent(element, this::fieldsOf).containsKey(lower)) {
      return false; // such as the style of a FontStyle
    }
    return switch (element) {
      case "X3D" -> !lower.equals("version") && !lower.equals("profile");
      case "Scene" -> true;
      default ->
          lower.equals("id")
              || lower.equals("class")
              || lower.equals("style")
              || lower.equals("xmlns")
              || lower.startsWith("on")
              || lower.startsWith("data-")
              || lower.indexOf(':') >= 0;
    };
  }
}
