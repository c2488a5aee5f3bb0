package org.selectiverenderer.validation.xml;

import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.IgnoreComment;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Finds suppression comments that have no effect. */
final class CommentCheck implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    for (XmlDocument.Comment comment : file.document().comments()) {
      IgnoreComment.of(comment)
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
      IgnoreComment ignoring, Set<String> rules, XmlDocument.Comment comment) {
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
