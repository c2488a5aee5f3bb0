package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
  private int depth;

  static String of(List<SceneItem> items) {
    ClassicVrmlSceneWriter writer = new ClassicVrmlSceneWriter();
    String version =
        items.stream()
            .filter(Element.class::isInstance)
            .map(root -> ((Element) root).text("version").strip())
            .findFirst()
            .orElse("");
    String given = version.matches("\\d+\\.\\d+") ? version : VERSION;
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
        statement("COMPONENT", element.text("name") + ":" + (level.isEmpty() ? "1" : level));
        comments(element);
      }
      case "unit" -> {
        String factor = element.text("conversionFactor");
        String conversion = factor.isEmpty() ? "1" : factor;
        statement("UNIT", element.text("category"), element.text("name"), conversion);
        comments(element);
      }
      case "meta" -> {
        statement("META", string(element.text("name")), string(element.text("content")));
        comments(element);
      }
      case "ROUTE" -> {
        String from = element.text("fromNode") + "." + element.text("fromField");
        String to = element.text("toNode") + "." + element.text("toField");
        statement("ROUTE", from, "TO", to);
        comments(element);
      }
      case "IMPORT" -> {
        String inline = element.text("inlineDEF");
        statement("IMPORT", inline + "." + element.text("importedDEF"));
        as(element);
      }
      case "EXPORT" -> {
        statement("EXPORT", element.text("localDEF"));
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
      text.append(" AS ").append(as).append('\n');
    }
    comments(element);
  }

  /** Writes the comments in a statement that is a line of its own. */
  private void comments(Element element) {
    for (SceneItem item : element.items()) {
      if (item instanceof Element inner) {
        comments(inner);
      } else {
        item(item);
      }
    }
  }

  private void prototype(Element element) {
    element.items().stream().filter(SceneItem.Words.class::isInstance).forEach(this::item);
    line().append("PROTO ").append(element.text("name")).append(" [\n");
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
    line().append("EXTERNPROTO ").append(element.text("name")).append(" [\n");
    depth++;
    for (SceneItem item : element.items()) {
      if (item instanceof Element field) {
        statement(field.text("accessType"), field.text("type"), field.text("name"));
        comments(field);
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
    String type = field.text("type");
    line().append(field.text("accessType")).append(' ').append(type).append(' ');
    text.append(field.text("name"));
    boolean initial = field.access().initialisable();
    if (!connected.isEmpty()) {
      text.append(" IS ").append(connected).append('\n');
      comments(field);
    } else if (initial) {
      content(field, type.startsWith("MF"));
    } else {
      text.append('\n');
      comments(field);
    }
  }

  /** Writes the value or the nodes of a field or fieldValue after its name. */
  private void content(Element field, boolean multiple) {
    Value value =
        field.values().stream().filter(v -> v.name().equals("value")).findFirst().orElse(null);
    if (value == null) {
      nodes(field.items(), multiple);
    } else {
      text.append(' ').append(written(value)).append('\n');
      comments(field);
    }
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
      if (item instanceof Element element) {
        text.append(' ');
        node(element);
        found = true;
      }
    }
    if (!found) {
      text.append(" NULL\n");
    }
    items.stream().filter(SceneItem.Words.class::isInstance).forEach(this::item);
  }

  private void node(Element element) {
    if (!element.use().isEmpty()) {
      text.append("USE ").append(element.use()).append('\n');
      comments(element);
      return;
    }
    if (!element.def().isEmpty()) {
      text.append("DEF ").append(element.def()).append(' ');
    }
    boolean instance = element.name().equals("ProtoInstance");
    text.append(instance ? element.text("name") : element.name()).append(" {\n");
    depth++;
    body(element, instance);
    depth--;
    line().append("}\n");
  }

  private void body(Element element, boolean instance) {
    Map<String, List<String>> connected = connections(element);
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
        List<String> outer = connected.getOrDefault(name, List.of(""));
        outer.forEach(one -> declared(field, one)); // repeated for each further IS
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
      comments(is);
    }
    connected.forEach((field, outer) -> outer.forEach(one -> statement(field, "IS", one)));
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

  /** Returns the fields of the prototype to which IS connects each field of a node. */
  private static Map<String, List<String>> connections(Element element) {
    Map<String, List<String>> connected = new LinkedHashMap<>();
    for (Element is : element.all("IS")) {
      for (Element connect : is.all("connect")) {
        connected
            .computeIfAbsent(connect.text("nodeField"), field -> new ArrayList<>())
            .add(connect.text("protoField"));
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
}
