package org.selectiverenderer.authoring.editing;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates the edit that suppresses a rule of the validator for an element and what is in it: a
 * comment {@code validate-ignore SR207} before the element, which {@code validate} reads too.
 */
public final class FindingSuppression {
  /** The comments of a text that suppress rules, as the validator reads them. */
  public static final class Comments {
    private static final String WORD = "validate-ignore";
    private static final Pattern COMMENT =
        Pattern.compile("<!--\\s*" + WORD + "\\b([^:]*?)(?::.*?)?-->", Pattern.DOTALL);

    private final String text;
    private final boolean any;

    /** Looks in a text, of whose tree the elements are. */
    public Comments(String text) {
      this.text = text;
      any = text.contains(WORD);
    }

    /**
     * Returns whether a comment before an element, or before one around it, suppresses a rule.
     *
     * @param rule id of the rule: {@code SR207}
     */
    public boolean suppress(String rule, DocumentElement element) {
      Optional<DocumentElement> at = any ? Optional.of(element) : Optional.empty();
      while (at.isPresent()) {
        if (before(rule, at.get())) {
          return true;
        }
        at = at.get().parent();
      }
      return false;
    }

    private boolean before(String rule, DocumentElement element) {
      Matcher comment = COMMENT.matcher(text).region(gap(element), element.start());
      while (comment.find()) {
        if (Stream.of(comment.group(1).strip().split("[\\s,]+"))
            .anyMatch(id -> !id.isEmpty() && rule.startsWith(id))) {
          return true;
        }
      }
      return false;
    }

    /** Returns where what stands between an element and the one before it begins. */
    private static int gap(DocumentElement element) {
      if (element.parent().isEmpty()) {
        return 0;
      }
      DocumentElement parent = element.parent().get();
      List<DocumentElement> siblings = parent.children();
      int at =
          Collections.binarySearch(
              siblings, element, Comparator.comparingInt(DocumentElement::start));
      return Math.min(element.start(), at > 0 ? siblings.get(at - 1).end() : parent.tagEnd());
    }
  }

  private final SceneDocument document;

  /** Suppresses findings of a document. */
  public FindingSuppression(SceneDocument document) {
    this.document = document;
  }

  /**
   * Returns the edit.
   *
   * @param rule id of the rule: {@code SR207}
   * @throws EditRejectedException if the element comes from an entity
   */
  public Edit suppress(String rule, DocumentElement element) {
    if (element.isReference()) {
      throw new EditRejectedException(
          element + " comes from an entity of the DOCTYPE; change it in the source");
    }
    String comment = "<!-- validate-ignore " + rule + ": accepted by the author -->";
    boolean ownLine = document.layout().onItsOwnLine(element);
    String between =
        ownLine
            ? document.layout().endOfLine(element) + document.layout().indentation(element)
            : "";
    return new Edit(
        "Ignore " + rule + " at " + element,
        List.of(TextEdit.insert(element.start(), comment + between)));
  }
}
