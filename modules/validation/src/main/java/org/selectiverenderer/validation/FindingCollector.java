package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Collects the findings that settings and comments do not suppress. At most {@value #LIMIT}
 * findings per rule and file are kept and the rest only counted, so that a file with a million
 * faults does not exhaust memory. Not thread-safe.
 */
public final class FindingCollector {
  /** The largest number of findings of one rule that are kept per file. */
  public static final int LIMIT = 10_000;

  private static final int LONGEST_MESSAGE = 300;

  private record Key(Rule rule, String file) {}

  private final BiPredicate<Rule, SourceLocation> wanted;
  private final List<Finding> list = new ArrayList<>();
  private final Map<Key, Integer> counts = new HashMap<>();

  /**
   * @param wanted tests whether a finding of a rule at a location is to be kept
   */
  public FindingCollector(BiPredicate<Rule, SourceLocation> wanted) {
    this.wanted = wanted;
  }

  /** Adds a finding about a node of a document, located at its element. */
  public void add(Rule rule, DocumentElement element, Object... words) {
    addWithin(rule, element, element.location(), words);
  }

  /** Adds a finding about an attribute, located at its name. */
  public void add(Rule rule, DocumentAttribute attribute, Object... words) {
    addWithin(rule, attribute.element(), attribute.location(), words);
  }

  /** Adds a finding about a part of an attribute's value. */
  public void addAt(Rule rule, DocumentAttribute attribute, int offset, Object... words) {
    addWithin(rule, attribute.element(), attribute.location(offset), words);
  }

  /** Adds a finding about a node of a document, at a location within it. */
  public void addWithin(Rule rule, DocumentElement element, SourceLocation place, Object... words) {
    if (keeps(rule, place)) {
      list(rule, place, label(element), words);
    }
  }

  /** Adds a finding about a node of a scene. */
  public void add(Rule rule, NodeView node, Object... words) {
    add(rule, node.location(), label(node), words);
  }

  /** Adds a finding about a field of a node of a scene, located by {@link FileOutline#place}. */
  public void addAt(Rule rule, FileOutline file, NodeView node, String field, Object... words) {
    add(rule, file.place(node, field), label(node), words);
  }

  /** Adds a finding at any location, or about a file as a whole ({@link SourceLocation#of}). */
  public void add(Rule rule, SourceLocation location, String node, Object... words) {
    if (keeps(rule, location)) {
      list(rule, location, node, words);
    }
  }

  // Tested before the message is formatted, since suggestions and labels are expensive and there
  // may be a million findings.
  private boolean keeps(Rule rule, SourceLocation location) {
    return wanted.test(rule, location)
        && counts.merge(new Key(rule, location.file()), 1, Integer::sum) <= LIMIT;
  }

  private void list(Rule rule, SourceLocation location, String node, Object... words) {
    String message = printable(rule.message(words));
    list.add(new Finding(rule, rule.severity(), location, node, message));
  }

  /** Returns all kept findings, in the order found. */
  public List<Finding> list() {
    return List.copyOf(list);
  }

  /** Returns how many findings exceeded {@link #LIMIT} and were not kept. */
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
            c ->
                c == '\t'
                        || ControlCharacterEscaper.isControl(c)
                        || Character.getType(c) == Character.SURROGATE
                    ? '?'
                    : c)
        .forEach(line::appendCodePoint);
    return text.length() > LONGEST_MESSAGE ? line + "..." : line.toString();
  }
}
