package org.selectiverenderer.x3d.write;

import com.fasterxml.jackson.core.io.JsonStringEncoder;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Value;
import org.selectiverenderer.x3d.write.SceneItem.Words;

/**
 * Writes a scene in X3D's JSON encoding, with {@code "@name"} for values, {@code "-field"} for
 * nodes, {@code "#comment"} and {@code "#sourceCode"}; one member per line, indented by two blanks.
 */
final class JsonSceneWriter {
  private final StringBuilder text = new StringBuilder();
  private int depth;
  private boolean first = true;

  static String of(List<SceneItem> items) {
    JsonSceneWriter writer = new JsonSceneWriter();
    writer.open('{');
    writer.comments(items);
    for (SceneItem item : items) {
      if (item instanceof Element root) {
        writer.member(root.name());
        writer.root(root);
      }
    }
    writer.close('}');
    return writer.text.append('\n').toString();
  }

  private void open(char bracket) {
    text.append(bracket);
    depth++;
    first = true;
  }

  private void close(char bracket) {
    depth--;
    if (!first) {
      text.append('\n').append("  ".repeat(depth));
    }
    text.append(bracket);
    first = false;
  }

  /** Begins the next member or element. */
  private StringBuilder next() {
    text.append(first ? "\n" : ",\n").append("  ".repeat(depth));
    first = false;
    return text;
  }

  private void member(String name) {
    next();
    string(name);
    text.append(": ");
  }

  private void string(String words) {
    text.append('"');
    JsonStringEncoder.getInstance().quoteAsString(words, text);
    text.append('"');
  }

  private void root(Element root) {
    open('{');
    member("encoding");
    string("UTF-8");
    members(root, false);
    close('}');
  }

  private void object(Element element) {
    open('{');
    if (!element.def().isEmpty()) {
      member("@DEF");
      string(element.def());
    }
    if (!element.use().isEmpty()) {
      member("@USE");
      string(element.use());
    }
    if (element.name().equals("ProtoInstance") && !element.place().usual()) {
      member("@containerField");
      string(element.place().name());
    }
    boolean listed =
        switch (element.name()) {
          case "Scene", "ProtoBody", "field", "fieldValue" -> true;
          default -> false;
        };
    members(element, listed);
    close('}');
  }

  /**
   * Writes the members of an element.
   *
   * @param listed whether nodes, statements and comments form one array of children
   */
  private void members(Element element, boolean listed) {
    for (Value value : element.values()) {
      member("@" + value.name());
      value(value);
    }
    if (listed) {
      if (!element.items().isEmpty()) {
        member("-children");
        list(element.items());
      }
      return;
    }
    ChildrenByField groups = ChildrenByField.of(element);
    boolean node = element.type() != null;
    List<SceneItem> children = new ArrayList<>();
    List<SceneItem> loose = new ArrayList<>(groups.rest());
    Map<String, List<Element>> named = new LinkedHashMap<>();
    // an instance in another field needs its declaration before it
    boolean early =
        groups.fields().keySet().stream().limit(1).noneMatch(p -> p.name().equals("children"));
    for (SceneItem item : groups.statements()) {
      if (item instanceof Words) {
        loose.add(item);
      } else if (node && among((Element) item) && !(early && declares(item))) {
        children.add(item);
      } else {
        named
            .computeIfAbsent(((Element) item).name(), key -> new ArrayList<>())
            .add((Element) item);
      }
    }
    groups
        .fields()
        .forEach(
            (place, items) -> {
              if (!place.multiple()) {
                items.stream().filter(Words.class::isInstance).forEach(loose::add);
              }
            });
    comments(loose);
    named.forEach(this::elements);
    boolean childless =
        groups.fields().keySet().stream().noneMatch(place -> place.name().equals("children"));
    groups.fields().forEach((place, items) -> field(place, items, children));
    if (childless && !children.isEmpty()) {
      member("-children");
      list(children);
    }
    if (!element.source().isEmpty()) {
      member("#sourceCode");
      strings(List.of(element.source().split("\n", -1)));
    }
  }

  private static boolean declares(SceneItem statement) {
    return ((Element) statement).name().endsWith("Declare");
  }

  /** Returns whether a statement is written among nodes. */
  private static boolean among(Element statement) {
    return switch (statement.name()) {
      case "ROUTE", "IMPORT", "EXPORT", "ProtoDeclare", "ExternProtoDeclare" -> true;
      default -> false;
    };
  }

  /**
   * Writes the nodes of a field.
   *
   * @param statements the statements of the parent, which are written among its children:
   *     prototypes before these, routes after them
   */
  private void field(SceneItem.Place place, List<SceneItem> items, List<SceneItem> statements) {
    if (place.multiple()) {
      member("-" + place.name());
      List<SceneItem> all = new ArrayList<>(items);
      if (place.name().equals("children")) {
        int protos = 0;
        for (SceneItem statement : statements) {
          all.add(declares(statement) ? protos++ : all.size(), statement);
        }
      }
      list(all);
    } else {
      for (SceneItem item : items) {
        if (item instanceof Element node) {
          member("-" + place.name());
          wrapped(node);
        }
      }
    }
  }

  /** Writes elements of one name, as an array if several are allowed. */
  private void elements(String name, List<Element> elements) {
    member(name);
    boolean single =
        switch (name) {
          case "head", "Scene", "IS", "ProtoInterface", "ProtoBody" -> true;
          default -> false;
        };
    if (single) {
      object(merged(elements));
      return;
    }
    open('[');
    for (Element element : elements) {
      next();
      object(element);
    }
    close(']');
  }

  /** Returns one element with the content of several. */
  private static Element merged(List<Element> elements) {
    Element first = elements.get(0);
    if (elements.size() == 1) {
      return first;
    }
    List<SceneItem> items = new ArrayList<>();
    elements.forEach(element -> items.addAll(element.items()));
    return new Element(
        first.name(), first.type(), "", "", first.place(), first.values(), items, "");
  }

  private void list(List<SceneItem> items) {
    open('[');
    for (SceneItem item : items) {
      next();
      if (item instanceof Words words) {
        open('{');
        member("#comment");
        string(words.text());
        close('}');
      } else {
        wrapped((Element) item);
      }
    }
    close(']');
  }

  private void wrapped(Element element) {
    open('{');
    member(element.name());
    object(element);
    close('}');
  }

  /** Writes comments outside arrays as one member, since member names are unique. */
  private void comments(List<SceneItem> items) {
    String words =
        items.stream()
            .filter(Words.class::isInstance)
            .map(item -> ((Words) item).text())
            .collect(Collectors.joining("\n"));
    if (!words.isEmpty()) {
      member("#comment");
      string(words);
    }
  }

  private void strings(List<String> all) {
    open('[');
    for (String line : all) {
      next();
      string(line);
    }
    close(']');
  }

  private void value(Value value) {
    // text of an unknown type is read as it is
    FieldType type = value.type() == null ? FieldType.SFString : value.type();
    switch (type.kind()) {
      case STRING -> {
        if (type.multiple()) {
          List<String> all = InlineCodeConverter.strings(value.text());
          if (all.isEmpty()) {
            text.append("[]");
          } else {
            strings(all);
          }
        } else {
          string(value.text());
        }
      }
      case NODE -> string(value.text());
      default -> {
        boolean one = !type.multiple() && type.components() == 1;
        text.append(one ? "" : "[");
        words(value.text());
        text.append(one ? "" : "]");
      }
    }
  }

  /** Writes numbers or booleans with their original line breaks. */
  private void words(String all) {
    boolean behind = false;
    boolean line = false;
    for (int at = 0; at < all.length(); ) {
      char c = all.charAt(at);
      if (c <= ' ' || c == ',') {
        line |= c == '\n';
        at++;
        continue;
      }
      int start = at;
      while (at < all.length() && all.charAt(at) > ' ' && all.charAt(at) != ',') {
        at++;
      }
      text.append(behind ? "," : "");
      if (line) {
        text.append('\n').append("  ".repeat(depth + 1));
      }
      JsonNumberFormatter.append(text, all, start, at);
      behind = true;
      line = false;
    }
  }

  /** Converts X3D numbers to JSON syntax (RFC 8259, 6), with the same digits where possible. */
  private static final class JsonNumberFormatter {
    private JsonNumberFormatter() {}

    /**
     * Appends a number or boolean.
     *
     * @param from the offset of the word
     * @param to the offset after the word
     */
    static void append(StringBuilder into, String text, int from, int to) {
      int at = from;
      char c = text.charAt(at);
      if (c == 't' || c == 'f') {
        into.append(text, from, to);
        return;
      }
      if (c == '-') {
        into.append('-');
      }
      at += c == '-' || c == '+' ? 1 : 0;
      if (text.regionMatches(true, at, "0x", 0, 2)) {
        into.append((int) Long.parseLong(text.substring(at + 2, to), 16));
        return;
      }
      while (at + 1 < to && text.charAt(at) == '0' && digit(text.charAt(at + 1))) {
        at++;
      }
      if (text.charAt(at) == '.') {
        into.append('0');
      }
      for (; at < to; at++) {
        char next = at + 1 < to ? text.charAt(at + 1) : 0;
        if (text.charAt(at) != '.' || digit(next)) {
          into.append(text.charAt(at)); // a decimal point without digits after it is dropped
        }
      }
    }

    private static boolean digit(char c) {
      return c >= '0' && c <= '9';
    }
  }
}
