package org.selectiverenderer.x3d.vrml1;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.vrml.VrmlScanner;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Child;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field.Form;

/**
 * Parses nodes with their fields and children. The form of a value is seen from its first
 * character, so that fields of unknown nodes are parsed, too.
 */
final class Vrml1NodeParser {
  private final ElementTreeBuilder document;
  private final VrmlScanner scanner;
  private final Map<String, Vrml1Node> named = new HashMap<>();
  private final Set<String> names = new TreeSet<>();
  private int count;

  Vrml1NodeParser(ElementTreeBuilder document, VrmlScanner scanner) {
    this.document = document;
    this.scanner = scanner;
  }

  /** Returns all names that nodes have been given. */
  Set<String> names() {
    return names;
  }

  /** Parses the nodes of a file into a group, which has those before an error after it, too. */
  void scene(Vrml1Node into) throws XmlParseException {
    scanner.space();
    while (!scanner.ended()) {
      int at = scanner.at();
      String word = scanner.name("a node");
      if (!child(into, word, at, 1)) {
        scanner.space();
        throw scanner.expected("'{' after the type of a node, " + FieldTokenizer.quote(word) + ",");
      }
      scanner.space();
    }
    into.endAt(scanner.at());
  }

  /** Parses the child that begins with a word; returns false if it is none but a field. */
  private boolean child(Vrml1Node parent, String word, int at, int depth) throws XmlParseException {
    switch (word) {
      case "DEF" -> {
        String name = scanner.name("the name of a node");
        node(parent, scanner.name("the type of the node " + name), name, at, depth);
      }
      case "USE" -> {
        String name = scanner.name("the name of a node");
        Vrml1Node found = named.get(name);
        if (found == null) {
          String what = "no node before this one has the name %s; the USE is left out";
          document.leftOut(at, what.formatted(FieldTokenizer.quote(name)));
        } else {
          parent.children().add(new Child(found, true, at));
        }
      }
      default -> {
        if (!scanner.opens()) {
          return false;
        }
        node(parent, word, null, at, depth);
      }
    }
    return true;
  }

  private void node(Vrml1Node parent, String type, @Nullable String name, int at, int depth)
      throws XmlParseException {
    if (depth > document.limits().maxDepth()) {
      throw document.limit(
          at, "nodes are nested more than " + document.limits().maxDepth() + " deep");
    }
    if (++count > document.limits().maxNodes()) {
      throw document.limit(at, "there are more than " + document.limits().maxNodes() + " nodes");
    }
    Vrml1Node node = new Vrml1Node(type, name, at, scanner.at() - type.length());
    scanner.expect('{', "after the type of a node, " + FieldTokenizer.quote(type) + ",");
    parent.children().add(new Child(node, false, at));
    node.endAt(scanner.at());
    scanner.space();
    while (scanner.peek() != '}') {
      int start = scanner.at();
      String word = scanner.name("a field, a node or '}'");
      if (!child(node, word, start, depth + 1)) {
        Field field = field(word, start, depth);
        if (field != null) {
          node.fields().put(word, field);
        }
      }
      node.endAt(scanner.at());
      scanner.space();
    }
    scanner.step();
    node.endAt(scanner.at());
    if (name != null) {
      // only now, so that no node is within itself
      named.put(name, node);
      names.add(name);
    }
  }

  /** Parses the value of a field; returns null for a node, as some extensions have them. */
  private @Nullable Field field(String name, int at, int depth) throws XmlParseException {
    int from = scanner.space();
    switch (scanner.peek()) {
      case '"' -> {
        scanner.passString();
        return new Field(Form.STRING, at, from, scanner.at());
      }
      case '[' -> {
        return list(at, from);
      }
      case '(' -> {
        return words(at, from);
      }
      default -> {
        // numbers and words
      }
    }
    if (scanner.number()) {
      int end = from;
      while (scanner.number()) {
        scanner.passWord();
        end = scanner.at();
        scanner.space();
      }
      return new Field(Form.NUMBERS, at, from, end);
    }
    String word = scanner.name("the value of the field " + FieldTokenizer.quote(name));
    int end = scanner.at();
    if (child(new Vrml1Node("", null, at, at), word, from, depth + 1)) {
      return null;
    }
    return new Field(Form.WORDS, at, from, end);
  }

  private Field list(int at, int open) throws XmlParseException {
    scanner.step();
    int first = scanner.space();
    int end = first;
    int depth = 1;
    while (true) {
      scanner.space();
      char c = scanner.peek();
      if (c == '"') {
        scanner.passString();
      } else if (c == ']' && depth == 1) {
        scanner.step();
        return new Field(Form.LIST, at, first, end);
      } else if (scanner.ended() || c == '}' && depth == 1) {
        throw document.fault(open, "the list that begins here has no closing ']'");
      } else if (c == '[' || c == '{') {
        depth++;
        scanner.step();
      } else if (c == ']' || c == '}') {
        depth--;
        scanner.step();
      } else {
        scanner.passWord();
      }
      end = scanner.at();
    }
  }

  /** Parses the words of a bit mask, such as {@code (BOLD | ITALIC)}. */
  private Field words(int at, int open) throws XmlParseException {
    scanner.step();
    int from = scanner.at();
    while (scanner.peek() != ')') {
      if (scanner.ended() || scanner.peek() == '}' || scanner.peek() == '{') {
        throw document.fault(open, "the words that begin here have no closing ')'");
      }
      scanner.step();
    }
    int to = scanner.at();
    scanner.step();
    return new Field(Form.WORDS, at, from, to);
  }
}
