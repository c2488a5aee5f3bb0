package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.x3d.DocumentAttribute;
import org.selectiverenderer.x3d.DocumentElement;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.NodeView;

/**
 * Collects findings. Of each rule {@value #LIMIT} per file are kept and the rest dropped, the last
 * one saying so: whoever has more mends a few and runs again. Serves one thread.
 */
public final class Findings {
  /** Findings of one rule that are listed per file. */
  public static final int LIMIT = 50;

  private static final int LONGEST_MESSAGE = 300;

  private record Key(Rule rule, String file) {}

  private final List<Finding> list = new ArrayList<>();
  private final Map<Key, Integer> counts = new HashMap<>();

  /** About a node of a document: its whole element. */
  public void add(Rule rule, DocumentElement element, Object... words) {
    add(rule, element.location(), label(element), words);
  }

  /** About an attribute: its name. */
  public void add(Rule rule, DocumentAttribute attribute, Object... words) {
    if (!full(rule, attribute.element().location())) {
      add(rule, attribute.location(), label(attribute.element()), words);
    }
  }

  /** About a word within an attribute's value. */
  public void addAt(Rule rule, DocumentAttribute attribute, int offset, Object... words) {
    if (!full(rule, attribute.element().location())) {
      add(rule, attribute.location(offset), label(attribute.element()), words);
    }
  }

  /** About a node of a scene. */
  public void add(Rule rule, NodeView node, Object... words) {
    add(rule, node.location(), label(node), words);
  }

  /** About any place, or about a file as a whole ({@link Location#of}). */
  public void add(Rule rule, Location location, String node, Object... words) {
    int count = counts.merge(new Key(rule, location.file()), 1, Integer::sum);
    if (count <= LIMIT) {
      String message = printable(rule.message(words));
      if (count == LIMIT) {
        message += "; further findings of this rule in this file are not listed";
      }
      list.add(new Finding(rule, rule.severity(), location, node, message));
    }
  }

  /** All so far, in the order found. */
  public List<Finding> list() {
    return List.copyOf(list);
  }

  // To find a place costs; a hostile file must not make it quadratic.
  private boolean full(Rule rule, Location location) {
    return counts.getOrDefault(new Key(rule, location.file()), 0) >= LIMIT;
  }

  private static String label(DocumentElement element) {
    return printable(
        element.text("DEF").map(def -> element.name() + " " + def).orElse(element.name()));
  }

  private static String label(NodeView node) {
    return printable(
        node.name() == null ? node.type().name() : node.type().name() + " " + node.name());
  }

  private static String printable(String text) {
    StringBuilder line = new StringBuilder();
    text.codePoints()
        .limit(LONGEST_MESSAGE)
        .map(
            c -> Character.isISOControl(c) || Character.getType(c) == Character.SURROGATE ? '?' : c)
        .forEach(line::appendCodePoint);
    return text.length() > LONGEST_MESSAGE ? line + "..." : line.toString();
  }
}
