package org.selectiverenderer.validation;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.Problem.Severity;

/**
 * A rule of the validator, as documented by {@code --explain}.
 *
 * @param id {@code SR} and three digits, the first of which is the group; never used for anything
 *     else once published
 * @param severity default severity, which settings may change
 * @param template the message template with placeholders in braces, which each finding replaces,
 *     for example <code>unknown element {element}</code>
 * @param summary a short description for lists of rules; empty if the template serves
 * @param explanation why it matters and what to do, in one or two sentences
 * @param bad a short example that violates the rule: a fragment of a Scene, or a whole file from
 *     {@code <?xml} or {@code <X3D}
 * @param good the corrected example
 * @param reference a clause of the standard or a section of the thesis
 */
public record Rule(
    String id,
    Severity severity,
    String template,
    String summary,
    String explanation,
    String bad,
    String good,
    String reference) {
  private static final Pattern PLACEHOLDER = Pattern.compile("\\{[a-zA-Z]+}");

  /** Creates an error: the file violates the standard, or something will not be shown. */
  public static Rule error(String id, String template) {
    return new Rule(id, Severity.ERROR, template, "", "", "", "", "");
  }

  /**
   * Creates a warning: the scene works here, but is probably wrong or does not work in every
   * browser.
   */
  public static Rule warning(String id, String template) {
    return new Rule(id, Severity.WARNING, template, "", "", "", "", "");
  }

  /** Creates a remark, which never makes a run fail. */
  public static Rule info(String id, String template) {
    return new Rule(id, Severity.INFO, template, "", "", "", "", "");
  }

  /**
   * Returns the rule with a summary for lists of rules, for messages that differ from case to case.
   */
  public Rule about(String what) {
    return new Rule(id, severity, template, what, explanation, bad, good, reference);
  }

  /** Returns the rule with an explanation. */
  public Rule because(String why) {
    return new Rule(id, severity, template, summary, why.strip(), bad, good, reference);
  }

  /** Returns the rule with an example that violates it. */
  public Rule bad(String example) {
    return new Rule(id, severity, template, summary, explanation, example.strip(), good, reference);
  }

  /** Returns the rule with the corrected example. */
  public Rule good(String example) {
    return new Rule(id, severity, template, summary, explanation, bad, example.strip(), reference);
  }

  /** Returns the rule with a reference. */
  public Rule see(String source) {
    return new Rule(id, severity, template, summary, explanation, bad, good, source);
  }

  /**
   * Returns the message with the placeholders replaced by words, in order.
   *
   * @throws IllegalArgumentException if the numbers of words and placeholders differ
   */
  public String message(Object... words) {
    Matcher place = PLACEHOLDER.matcher(template);
    StringBuilder message = new StringBuilder();
    int used = 0;
    while (place.find()) {
      if (used == words.length) {
        throw new IllegalArgumentException(id + " needs more words than " + words.length);
      }
      place.appendReplacement(message, Matcher.quoteReplacement(String.valueOf(words[used++])));
    }
    if (used < words.length) {
      throw new IllegalArgumentException(id + " has only " + used + " places for words");
    }
    return place.appendTail(message).toString();
  }

  /** Returns the message as shown in lists of rules. */
  public String title() {
    if (!summary.isEmpty()) {
      return summary;
    }
    return PLACEHOLDER
        .matcher(template.replace("{suggestion}", ""))
        .replaceAll(place -> place.group().replaceAll("[{}]", "").toUpperCase(Locale.ROOT));
  }
}
