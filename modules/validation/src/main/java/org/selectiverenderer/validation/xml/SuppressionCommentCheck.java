package org.selectiverenderer.validation.xml;

import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SuppressionComment;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Finds suppression comments that have no effect. */
final class SuppressionCommentCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (XmlDocument.Comment comment : file.document().comments()) {
      SuppressionComment.of(comment)
          .ifPresent(
              ignoring -> {
                String reason = reason(ignoring, file.rules(), comment);
                if (!reason.isEmpty()) {
                  findings.add(XmlRules.COMMENT, comment.location(), "", reason);
                }
              });
    }
  }

  private static String reason(
      SuppressionComment ignoring, Set<String> rules, XmlDocument.Comment comment) {
    if (comment.before() == null) {
      return "no element follows it";
    }
    String unknown =
        ignoring.ids().stream()
            .filter(id -> rules.stream().noneMatch(rule -> rule.startsWith(id)))
            .collect(Collectors.joining(" "));
    if (!unknown.isEmpty()) {
      return "there is no rule " + unknown;
    }
    return ignoring.ids().isEmpty() ? "it names no rule" : "";
  }
}
