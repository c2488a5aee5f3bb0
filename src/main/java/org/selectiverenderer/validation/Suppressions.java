package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.DocumentElement;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.SceneDocument;

/**
 * Findings that an author does not want to hear of: a comment <code>
 * validate-ignore SR102 SR103: why
 * </code> before an element is for that element and all within it; before the root element, for the
 * whole file.
 */
record Suppressions(List<Suppression> list) {
  /**
   * One comment.
   *
   * @param ids of rules, or beginnings of ids
   * @param whole whether it is for the whole file
   */
  record Suppression(List<String> ids, boolean whole, Location from, Location to) {
    boolean covers(Finding finding) {
      Location at = finding.location();
      boolean within = !before(at, from) && !before(to, at);
      return (whole || within) && ids.stream().anyMatch(finding.rule().id()::startsWith);
    }

    private static boolean before(Location a, Location b) {
      return a.line() != b.line() ? a.line() < b.line() : a.column() < b.column();
    }
  }

  static Suppressions of(SceneDocument document) {
    List<Suppression> list = new ArrayList<>();
    for (SceneDocument.Comment comment : document.comments()) {
      IgnoreComment ignoring = IgnoreComment.of(comment).orElse(null);
      DocumentElement element = comment.before();
      if (ignoring != null && element != null) {
        Location end =
            element
                .end()
                .orElse(new Location(document.name(), Integer.MAX_VALUE, Integer.MAX_VALUE));
        list.add(
            new Suppression(ignoring.ids(), element.parent().isEmpty(), element.location(), end));
      }
    }
    return new Suppressions(List.copyOf(list));
  }

  boolean cover(Finding finding) {
    return list.stream().anyMatch(suppression -> suppression.covers(finding));
  }
}
