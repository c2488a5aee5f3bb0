package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Collects findings that are wanted. Of each rule and file {@value #LIMIT} are kept and the rest
 * are counted, so that a file of a million slips does not take all memory. Serves one thread.
 */
public final class Findings {
  /** Findings of one rule that are kept per file. */
  public static final int LIMIT = 10_000;

  private static final int LONGEST_MESSAGE = 300;

  private record Key(Rule rule, String file) {}

  private final BiPredicate<Rule, Location> wanted;
  private final List<Finding> list = new ArrayList<>();
  private final Map<Key, Integer> counts = new HashMap<>();

  /**
   * @param wanted says of what is found in a place whether it is to be kept
   */
  public Findings(BiPredicate<Rule, Location> wanted) {
    this.wanted = wanted;
  }

  /** About a node of a document: its whole element. */
  public void add(Rule rule, DocumentElement element, Object... words) {
    addWithin(rule, element, element.location(), words);
  }

  /** About an attribute: its name. */
  public void add(Rule rule, DocumentAttribute attribute, Object... words) {
    addWithin(rule, attribute.element(), attribute.location(), words);
  }

  /** About a word within an attribute's value. */
  public void addAt(Rule rule, DocumentAttribute attribute, int offset, Object... words) {
    addWithin(rule, attribute.element(), attribute.location(offset), words);
  }

  /** About a node of a document, at a place within it. */
  public void addWithin(Rule rule, DocumentElement element, Location place, Object... words) {
    if (keeps(rule, place)) {
      list(rule, place, label(element), words);
    }
  }

  /** About a node of a scene. */
  public void add(Rule rule, NodeView node, Object... words) {
    add(rule, node.location(), label(node), words);
  }

  /** About a field of a node of a scene, whose place {@link FileOutline#place} knows. */
  public void addAt(Rule rule, FileOutline file, NodeView node, String field, Object... words) {
    add(rule, file.place(node, field), label(node), words);
  }

  /** About any place, or about a file as a whole ({@link Location#of}). */
  public void add(Rule rule, Location location, String node, Object... words) {
    if (keeps(rule, location)) {
      list(rule, location, node, words);
    }
  }

  // Asked first: to write a message costs, for suggestions and labels, and there may be a million.
  private boolean keeps(Rule rule, Location location) {
    return wanted.test(rule, location)
        && counts.merge(new Key(rule, location.file()), 1, Integer::sum) <= LIMIT;
  }

  private void list(Rule rule, Location location, String node, Object... words) {
    String message = printable(rule.message(words));
    list.add(new Finding(rule, rule.severity(), location, node, message));
  }

  /** All that are kept, in the order found. */
  public List<Finding> list() {
    return List.copyOf(list);
  }

  /** How many were wanted, but not kept. */
  public int dropped() {
    return counts.values().stream().mapToInt(count -> Math.max(0, count - LIMIT)).sum();
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
