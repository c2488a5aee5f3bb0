package org.selectiverenderer.pages;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;

/** Tables of the keys that a JSON Schema of the program allows, in Markdown. */
final class SchemaTables {
  private static final String REFERENCE = "#/$defs/";

  private final JsonNode schema;
  private final String name;
  private final StringBuilder page = new StringBuilder();
  private final List<Runnable> later = new ArrayList<>();

  /**
   * @param name what the object is called in the headings of objects within it
   */
  SchemaTables(JsonNode schema, String name) {
    this.schema = schema;
    this.name = name;
  }

  /** The table of the whole, then one for each object in it, in the order in which they come. */
  String text() {
    table(schema, "");
    while (!later.isEmpty()) {
      later.remove(0).run();
    }
    for (Map.Entry<String, JsonNode> named : schema.path("$defs").properties()) {
      if (named.getValue().has("properties")) {
        heading(named.getKey());
        describe(named.getValue());
        table(named.getValue(), named.getKey());
        while (!later.isEmpty()) {
          later.remove(0).run();
        }
      }
    }
    return page.toString();
  }

  private void table(JsonNode object, String path) {
    List<String> needed = texts(object.path("required"));
    page.append("| key | value | says |\n| --- | --- | --- |\n");
    for (Map.Entry<String, JsonNode> key : object.path("properties").properties()) {
      if (!key.getKey().startsWith("$")) {
        row(key.getKey(), key.getValue(), path, needed.contains(key.getKey()));
      }
    }
    JsonNode choice = object.has("oneOf") ? object.path("oneOf") : object.path("anyOf");
    if (choice.isArray() && choice.path(0).has("required")) {
      String choices =
          StreamSupport.stream(choice.spliterator(), false)
              .map(one -> quoted(texts(one.path("required")), " and "))
              .collect(Collectors.joining(", or "));
      page.append('\n').append(object.has("oneOf") ? "One of these: " : "At least one of these: ");
      page.append(choices).append(".\n");
    }
  }

  private void row(String key, JsonNode value, String path, boolean needed) {
    String inner = path.isEmpty() ? key : path + "." + key;
    List<String> says = new ArrayList<>();
    if (needed) {
      says.add("**needed**");
    }
    if (value.has("description")) {
      says.add(value.path("description").asText().replace("|", "\\|"));
    }
    if (value.has("default")) {
      says.add("default: `" + value.path("default").asText() + "`");
    }
    page.append("| `%s` | %s | %s |\n".formatted(key, what(value, inner), String.join("; ", says)));
  }

  /** What a value may be, in words. */
  private String what(JsonNode value, String path) {
    if (value.has("$ref")) {
      String referred = value.path("$ref").asText().substring(REFERENCE.length());
      JsonNode definition = schema.path("$defs").path(referred);
      return definition.has("properties") ? link(referred) : words(referred);
    }
    if (value.has("enum")) {
      return quoted(texts(value.path("enum")), ", ");
    }
    JsonNode type = value.path("type");
    if (type.isArray()) {
      return String.join(" or ", texts(type)) + limits(value);
    }
    return switch (type.asText()) {
      case "array" -> "list: " + what(value.path("items"), path);
      case "object" -> {
        later.add(
            () -> {
              heading(path);
              table(value, path);
            });
        yield link(path);
      }
      case "string" -> value.has("pattern") ? pattern(value) : "text";
      case "boolean" -> "`true`, `false`";
      case "integer" -> "whole number" + limits(value);
      case "number" -> "number" + limits(value);
      default -> throw new IllegalStateException("a type that has no words: " + value);
    };
  }

  private static String pattern(JsonNode value) {
    return "text like `" + value.path("pattern").asText().replace("|", "\\|") + "`";
  }

  /** A definition that is no object of keys. */
  private String words(String definition) {
    return switch (definition) {
      case "name" -> pattern(schema.path("$defs").path(definition));
      case "text" -> "text, or one for each language";
      case "texts" -> "list of texts, or one for each language";
      case "trigger" -> "a byte, a column in braces, or an object: [triggers.md](triggers.md)";
      default -> throw new IllegalStateException("a definition that has no words: " + definition);
    };
  }

  private static String limits(JsonNode value) {
    if (!value.has("minimum")) {
      return "";
    }
    String least = value.path("minimum").asText();
    return value.has("maximum")
        ? ", %s to %s".formatted(least, value.path("maximum").asText())
        : ", %s or more".formatted(least);
  }

  private void describe(JsonNode object) {
    if (object.has("description")) {
      page.append(object.path("description").asText()).append(".\n\n");
    }
  }

  private void heading(String path) {
    page.append("\n### `%s.%s`\n\n".formatted(name, path));
  }

  private String link(String path) {
    return "[`%s.%s`](#%s)".formatted(name, path, (name + path).replace(".", ""));
  }

  private static String quoted(List<String> words, String between) {
    return words.stream().map(word -> "`" + word + "`").collect(Collectors.joining(between));
  }

  private static List<String> texts(JsonNode list) {
    List<String> texts = new ArrayList<>();
    list.forEach(text -> texts.add(text.asText()));
    return texts;
  }
}
