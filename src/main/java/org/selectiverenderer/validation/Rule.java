package org.selectiverenderer.validation;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.Problem.Severity;

/**
 * Something that the validator can say, as documented by {@code --explain}.
 *
 * @param id {@code SR} and three digits, the first of which is the group; never used for anything
 *     else once published
 * @param severity unless a configuration changes it
 * @param template the message with names in braces where a finding puts its own words, for example
 *     <code>unknown element {element}</code>
 * @param summary what it is about, for lists of rules; empty where the template says it
 * @param explanation why it matters and what to do, in one or two sentences
 * @param bad a short example that has it: a fragment of a Scene, or a whole file from {@code <?xml}
 *     or {@code <X3D}
 * @param good the same put right
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

  /** An error: the file breaks a rule that everybody relies on, or something will not show. */
  public static Rule error(String id, String template) {
    return new Rule(id, Severity.ERROR, template, "", "", "", "", "");
  }

  /** A warning: it works here, but is not meant so or does not work everywhere. */
  public static Rule warning(String id, String template) {
    return new Rule(id, Severity.WARNING, template, "", "", "", "", "");
  }

  /** A remark, which never makes a run fail. */
  public static Rule info(String id, String template) {
    return new Rule(id, Severity.INFO, template, "", "", "", "", "");
  }

  /** With words for lists of rules, where the message as a whole differs from case to case. */
  public Rule about(String what) {
    return new Rule(id, severity, template, what, explanation, bad, good, reference);
  }

  /** With an explanation. */
  public Rule because(String why) {
    return new Rule(id, severity, template, summary, why.strip(), bad, good, reference);
  }

  /** With an example that has it. */
  public Rule bad(String example) {
    return new Rule(id, severity, template, summary, explanation, example.strip(), good, reference);
  }

  /** With the example put right. */
  public Rule good(String example) {
    return new Rule(id, severity, template, summary, explanation, bad, example.strip(), reference);
  }

  /** With a source. */
  public Rule see(String source) {
    return new Rule(id, severity, template, summary, explanation, bad, good, source);
  }

  /**
   * The message with words in the places of the names, in order.
   *
   * @throws IllegalArgumentException if there are fewer or more words than places
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

  /** The message as a list of rules shows it. */
  public String title() {
    if (!summary.isEmpty()) {
      return summary;
    }
    return PLACEHOLDER
        .matcher(template.replace("{suggestion}", ""))
        .replaceAll(place -> place.group().replaceAll("[{}]", "").toUpperCase(Locale.ROOT));
  }
}
