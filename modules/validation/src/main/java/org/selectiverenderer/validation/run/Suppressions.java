package org.selectiverenderer.validation.run;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SuppressionComment;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/**
 * The suppressions of a file: a comment <code> validate-ignore SR102 SR103: why </code> before an
 * element suppresses findings about that element and all its descendants; before the root element,
 * those of the whole file.
 */
final class Suppressions {
  /**
   * A suppression: a comment and the element that it applies to.
   *
   * @param ids ids of rules, or prefixes of ids
   * @param outer the suppression of an enclosing element, or an earlier one of the same element;
   *     null if there is none
   */
  private record Suppression(
      Set<String> ids, SourceLocation from, SourceLocation to, @Nullable Suppression outer) {
    boolean holds(SourceLocation at) {
      return !before(at, from) && !before(to, at);
    }
  }

  private final Set<String> whole;
  private final List<Suppression> list;

  private Suppressions(Set<String> whole, List<Suppression> list) {
    this.whole = whole;
    this.list = list;
  }

  /**
   * Returns the suppressions of a document.
   *
   * @param rules ids of all rules
   */
  static Suppressions of(XmlDocument document, Set<String> rules) {
    Set<String> whole = new HashSet<>();
    List<Suppression> list = new ArrayList<>();
    Suppression last = null;
    for (XmlDocument.Comment comment : document.comments()) {
      SuppressionComment ignoring = SuppressionComment.of(comment).orElse(null);
      DocumentElement element = comment.before();
      if (ignoring == null || element == null) {
        continue;
      }
      Set<String> ids = new HashSet<>(ignoring.ids());
      ids.removeIf(id -> rules.stream().noneMatch(rule -> rule.startsWith(id)));
      if (element.parent().isEmpty()) {
        whole.addAll(ids);
        continue;
      }
      SourceLocation from = element.location();
      SourceLocation to =
          element
              .last()
              .orElse(new SourceLocation(document.name(), Integer.MAX_VALUE, Integer.MAX_VALUE));
      while (last != null && !last.holds(from)) {
        last = last.outer;
      }
      last = new Suppression(ids, from, to, last);
      list.add(last);
    }
    return new Suppressions(whole, list);
  }

  boolean cover(Rule rule, SourceLocation at) {
    String id = rule.id();
    if (whole.stream().anyMatch(id::startsWith)) {
      return true;
    }
    for (Suppression s = lastBefore(at); s != null; s = s.outer) {
      if (s.holds(at) && s.ids.stream().anyMatch(id::startsWith)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the last suppression that begins at or before a location, by binary search: they are in
   * document order, and may be many.
   */
  private @Nullable Suppression lastBefore(SourceLocation at) {
    int low = 0;
    int high = list.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (before(at, list.get(middle).from)) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low == 0 ? null : list.get(low - 1);
  }

  private static boolean before(SourceLocation a, SourceLocation b) {
    return a.line() != b.line() ? a.line() < b.line() : a.column() < b.column();
  }
}
