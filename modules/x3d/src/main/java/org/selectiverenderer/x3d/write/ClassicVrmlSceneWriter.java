package org.selectiverenderer.x3d.write;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Place;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/** Writes a scene in ClassicVRML (ISO/IEC 19776-2), one field per line, indented by two blanks. */
final class ClassicVrmlSceneWriter {
  /** The version for a file that specifies none. */
  private static final String VERSION = "4.0";

  private final StringBuilder text = new StringBuilder();
  private final UniqueNames names = new UniqueNames();
  private int depth;

  static String of(List<SceneItem> items) {
    ClassicVrmlSceneWriter writer = new ClassicVrmlSceneWriter();
    String version =
        items.stream()
            .filter(Element.class::isInstance)
            .map(root -> ((Element) root).text("version").strip())
            .findFirst()
            .orElse("");
    String given = version.matches("\\d\\.\\d") ? version : VERSION;
    writer.text.append("#X3D V").append(given).append(" utf8\n");
    items.forEach(writer::item);
    return writer.text.toString();
  }

  private StringBuilder line() {
    return text.append("  ".repeat(depth));
  }

  private void comment(String words) {
    words.lines().forEach(line -> line().append("# ").append(line.strip()).append('\n'));
  }

  private void item(SceneItem item) {
    if (item instanceof SceneItem.Words words) {
      comment(words.text());
      return;
    }
    Element element = (Element) item;
    switch (element.name()) {
      case "X3D" -> {
        if (!element.text("profile").isEmpty()) {
          text.append("PROFILE ").append(element.text("profile").strip()).append('\n');
        }
        element.items().forEach(this::item);
      }
      case "head", "Scene" -> {
        text.append('\n');
        element.items().forEach(this::item);
      }
      case "component" -> {
        String level = element.text("level");
        line().append("COMPONENT ").append(element.text("name").strip()).append(':');
        text.append(level.isEmpty() ? "1" : level).append('\n');
      }
      case "unit" ->
          statement(
              "UNIT",
              element.text("category"),
              names.of(element.text("name")),
              element.text("conversionFactor"));
      case "meta" ->
          statement("META", string(element.text("name")), string(element.text("content")));
      case "ROUTE" -> {
        String from = names.of(element.text("fromNode")) + "." + element.text("fromField");
        String to = names.of(element.text("toNode")) + "." + element.text("toField");
        statement("ROUTE", from, "TO", to);
      }
      case "IMPORT" -> {
        String inline = names.of(element.text("inlineDEF"));
        statement("IMPORT", inline + "." + names.of(element.text("importedDEF")));
        as(element);
      }
      case "EXPORT" -> {
        statement("EXPORT", names.of(element.text("localDEF")));
        as(element);
      }
      case "ProtoDeclare" -> prototype(element);
      case "ExternProtoDeclare" -> external(element);
      default -> {
        if (element.node()) {
          line();
          node(element);
        }
      }
    }
  }

  private void statement(String... words) {
    line().append(String.join(" ", words)).append('\n');
  }

  private void as(Element element) {
    String as = element.text("AS");
    if (!as.isEmpty()) {
      text.setLength(text.length() - 1);
      text.append(" AS ").append(names.of(as)).append('\n');
    }
  }

  private void prototype(Element element) {
    element.items().stream().filter(SceneItem.Words.class::isInstance).forEach(this::item);
    line().append("PROTO ").append(names.of(element.text("name"))).append(" [\n");
    depth++;
    for (Element part : element.all("ProtoInterface")) {
      part.items().forEach(this::declared);
    }
    depth--;
    line().append("] {\n");
    depth++;
    for (Element part : element.all("ProtoBody")) {
      part.items().forEach(this::item);
    }
    depth--;
    line().append("}\n");
  }

  private void external(Element element) {
    line().append("EXTERNPROTO ").append(names.of(element.text("name"))).append(" [\n");
    depth++;
    for (SceneItem item : element.items()) {
      if (item instanceof Element field) {
        statement(field.text("accessType"), field.text("type").strip(), field.text("name"));
      } else {
        item(item);
      }
    }
    depth--;
    line().append("] [ ").append(element.text("url")).append(" ]\n");
  }

  /** Writes a field declaration of an interface, or a comment there. */
  private void declared(SceneItem item) {
    if (item instanceof Element field) {
      declared(field, "");
    } else {
      item(item);
    }
  }

  /**
   * Writes a field declaration of a prototype or Script.
   *
   * @param connected the prototype's field to which IS connects it; empty for none
   */
  private void declared(Element field, String connected) {
    String type = field.text("type").strip();
    line().append(field.text("accessType")).append(' ').append(type).append(' ');
    text.append(field.text("name"));
    boolean initial = field.access().initialisable();
    if (!connected.isEmpty()) {
      text.append(" IS ").append(connected).append('\n');
    } else if (initial) {
      content(field, type.startsWith("MF"));
    } else {
      text.append('\n');
    }
  }

  /** Writes the value or the nodes of a field or fieldValue after its name. */
  private void content(Element field, boolean multiple) {
    Value value =
        field.values().stream().filter(v -> v.name().equals("value")).findFirst().orElse(null);
    boolean nodes = field.items().stream().anyMatch(Element.class::isInstance);
    if (value != null && !nodes) {
      text.append(' ').append(written(value)).append('\n');
    } else if (nodes || value == null && !stored(field)) {
      nodes(field.items(), multiple);
    } else {
      FieldType type = FieldTypeResolver.of(field.text("type"));
      text.append(' ').append(type == null ? "NULL" : zero(type)).append('\n');
      field.items().forEach(this::item);
    }
  }

  /** Returns whether a field has a type other than nodes. */
  private static boolean stored(Element field) {
    FieldType type = FieldTypeResolver.of(field.text("type"));
    return type != null && !type.isNode();
  }

  private static String zero(FieldType type) {
    return written(
        new Value("", type, type == FieldType.SFString ? "" : FieldValueFormatter.of(type.zero())));
  }

  private void nodes(List<SceneItem> items, boolean multiple) {
    if (multiple) {
      text.append(" [\n");
      depth++;
      items.forEach(this::item);
      depth--;
      line().append("]\n");
      return;
    }
    boolean found = false;
    for (SceneItem item : items) {
      if (item instanceof SceneItem.Words words) {
        words.text().lines().forEach(line -> text.append(" # ").append(line.strip()).append('\n'));
      } else if (item instanceof Element element && element.node() && !found) {
        text.append(' ');
        node(element);
        found = true;
      }
    }
    if (!found) {
      text.append(" NULL\n");
    }
  }

  private void node(Element element) {
    if (!element.use().isEmpty()) {
      text.append("USE ").append(names.of(element.use())).append('\n');
      return;
    }
    if (!element.def().isEmpty()) {
      text.append("DEF ").append(names.of(element.def())).append(' ');
    }
    boolean instance = element.name().equals("ProtoInstance");
    text.append(instance ? names.of(element.text("name")) : element.name()).append(" {\n");
    depth++;
    body(element, instance);
    depth--;
    line().append("}\n");
  }

  private void body(Element element, boolean instance) {
    Map<String, String> connected = connections(element);
    ChildrenByField groups = ChildrenByField.of(element);
    for (Value value : instance ? List.<Value>of() : element.values()) {
      boolean code = value.name().equals("url") && !element.source().isEmpty();
      if (value.type() != null && !code) {
        line().append(value.name()).append(' ').append(written(value)).append('\n');
      }
    }
    boolean routes = false;
    for (SceneItem item : groups.statements()) {
      if (item instanceof Element field && field.name().equals("field")) {
        String name = field.text("name");
        declared(field, connected.getOrDefault(name, ""));
        connected.remove(name);
      } else if (item instanceof Element field && field.name().equals("fieldValue")) {
        line().append(field.text("name"));
        content(field, field.place().multiple());
      } else if (item instanceof Element last && last.name().equals("ROUTE")) {
        routes = true;
      } else {
        item(item);
      }
    }
    for (Element is : element.all("IS")) {
      is.items().stream().filter(SceneItem.Words.class::isInstance).forEach(this::item);
    }
    connected.forEach((field, outer) -> statement(field, "IS", outer));
    if (!element.source().isEmpty()) {
      String urls = InlineCodeConverter.urls(element.type(), element.text("url"), element.source());
      line().append("url [ ").append(urls).append(" ]\n");
    }
    groups.fields().forEach(this::group);
    groups.rest().forEach(this::item);
    if (routes) {
      element.all("ROUTE").forEach(this::item);
    }
  }

  private void group(Place place, List<SceneItem> items) {
    if (place.multiple()) {
      line().append(place.name());
      nodes(items, true);
      return;
    }
    items.stream().filter(SceneItem.Words.class::isInstance).forEach(this::item);
    line().append(place.name());
    nodes(items.stream().filter(Element.class::isInstance).toList(), false);
  }

  private static Map<String, String> connections(Element element) {
    Map<String, String> connected = new LinkedHashMap<>();
    for (Element is : element.all("IS")) {
      for (Element connect : is.all("connect")) {
        connected.put(connect.text("nodeField"), connect.text("protoField"));
      }
    }
    return connected;
  }

  private static String string(String content) {
    return FieldTokenizer.string(content);
  }

  /** Returns a value in the syntax of VRML. */
  private static String written(Value value) {
    FieldType type = value.type() == null ? FieldTypeResolver.guess(value.text()) : value.type();
    String plain = value.text();
    if (type == FieldType.SFString) {
      return string(plain);
    }
    if (type.kind() == FieldType.Kind.BOOLEAN) {
      plain = plain.toUpperCase(Locale.ROOT);
    }
    return !type.multiple() ? plain : plain.isEmpty() ? "[ ]" : "[ " + plain + " ]";
  }

  /**
   * Converts names to valid VRML names (ISO/IEC 19776-2, 4.3.2): invalid characters become
   * underscores, and different names remain different. For one file.
   */
  private static final class UniqueNames {
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
}
