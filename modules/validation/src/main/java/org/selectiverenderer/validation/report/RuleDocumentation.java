package org.selectiverenderer.validation.report;

import java.util.Locale;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.RuleGroup;
import org.selectiverenderer.validation.run.RuleCatalogue;

/**
 * Writes the documentation of rules: a list, the explanation of one rule, and the page {@code
 * docs/rules.md}.
 */
public final class RuleDocumentation {
  private static final int SCREEN_WIDTH = 78;
  private static final int PAGE_WIDTH = 120;

  private final RuleCatalogue catalogue;

  /** Creates the documentation of all rules of a catalogue. */
  public RuleDocumentation(RuleCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Returns a line for each rule, group by group. */
  public String list() {
    StringBuilder text = new StringBuilder();
    for (RuleGroup group : catalogue.groups()) {
      text.append(text.isEmpty() ? "" : "\n").append(group.title()).append('\n');
      for (Rule rule : group.rules()) {
        text.append(
            "  %s  %-7s  %s\n"
                .formatted(rule.id(), ReportPhrases.of(rule.severity()), rule.title()));
      }
    }
    return text.toString();
  }

  /** Returns one rule with its explanation and examples. */
  public static String explain(Rule rule) {
    return rule.id()
        + " ("
        + ReportPhrases.of(rule.severity())
        + "): "
        + rule.title()
        + "\n\n"
        + wrapped(rule.explanation(), SCREEN_WIDTH)
        + "\n\nBad:\n\n"
        + rule.bad().indent(4)
        + "\nGood:\n\n"
        + rule.good().indent(4)
        + "\nSource: "
        + rule.reference()
        + "\n";
  }

  /** Returns the page {@code docs/rules.md}. */
  public String page() {
    StringBuilder page =
        new StringBuilder(
            """
            # Rules of the validator

            How to run the validator, to ignore rules and to read its reports: [validate.md](validate.md).

            <!-- RuleDocumentationTest writes this page: do not edit it by hand. -->

            An error violates the standard, or something will not show. A warning works here, but is probably a
            mistake or does not work everywhere. A remark (info) never makes a run fail.
            """);
    for (RuleGroup group : catalogue.groups()) {
      page.append("\n## ").append(group.title()).append("\n\n| rule | severity | message |\n");
      page.append("| --- | --- | --- |\n");
      for (Rule rule : group.rules()) {
        page.append(
            "| [%s](#%s) | %s | %s |\n"
                .formatted(
                    rule.id(),
                    rule.id().toLowerCase(Locale.ROOT),
                    ReportPhrases.of(rule.severity()),
                    markdown(rule.title())));
      }
      group.rules().forEach(rule -> section(page, rule));
    }
    return page.toString();
  }

  private static void section(StringBuilder page, Rule rule) {
    page.append("\n### ").append(rule.id()).append("\n\n");
    String message =
        "**%s** (%s; %s)"
            .formatted(markdown(rule.title()), ReportPhrases.of(rule.severity()), rule.reference());
    page.append(wrapped(message, PAGE_WIDTH)).append("\n\n");
    page.append(wrapped(markdown(rule.explanation()), PAGE_WIDTH)).append("\n\n");
    example(page, "Bad", rule.bad());
    example(page, "Good", rule.good());
  }

  private static void example(StringBuilder page, String heading, String example) {
    String language = example.startsWith("<") ? "xml" : "";
    page.append(heading).append(":\n\n```").append(language).append('\n');
    page.append(example).append("\n```\n");
    page.append(heading.equals("Bad") ? "\n" : "");
  }

  private static String markdown(String text) {
    return text.replace("<", "&lt;").replace("|", "\\|");
  }

  private static String wrapped(String text, int width) {
    StringBuilder lines = new StringBuilder();
    int column = 0;
    for (String word : text.split("\\s+")) {
      if (column > 0 && column + 1 + word.length() > width) {
        lines.append('\n');
        column = 0;
      }
      lines.append(column > 0 ? " " : "").append(word);
      column += word.length() + (column > 0 ? 1 : 0);
    }
    return lines.toString();
  }
}
