package org.selectiverenderer.enricher.help;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.enricher.text.AccessHint;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.Rule;

/** Builds the HTML pages of the help, with the terms of thesis 4.2.2 in the author's words. */
final class HelpPageBuilder {
  private static final List<HelpTopic> TERMS =
      List.of(HelpTopic.TYPE, HelpTopic.DEGREE, HelpTopic.SCHEMAS, HelpTopic.ENTER, HelpTopic.EXIT);

  private HelpPageBuilder() {}

  /** Returns a page with what {@code validate --explain} says about a rule. */
  static String rule(Rule rule) {
    return """
        <html><body style="margin: 8px">
        <h2>%s</h2>
        <p><b>%s</b></p>
        <p>%s</p>
        <p>%s</p>
        <h3>%s</h3><pre>%s</pre>
        <h3>%s</h3><pre>%s</pre>
        <p>%s</p>
        </body></html>
        """
        .formatted(
            rule.id(),
            MarkupEscaper.text(
                AccessHint.inWindow(rule.summary().isEmpty() ? rule.template() : rule.summary())),
            MarkupEscaper.text(rule.explanation()),
            MarkupEscaper.text(rule.explanation().contains("--allow") ? AccessHint.ofDialog() : ""),
            Texts.of("problems.rule.bad"),
            MarkupEscaper.text(rule.bad()),
            Texts.of("problems.rule.good"),
            MarkupEscaper.text(rule.good()),
            MarkupEscaper.text(rule.reference()));
  }

  /**
   * Returns the whole help page.
   *
   * @param topic explained first
   */
  static String page(Optional<HelpTopic> topic) {
    String first =
        topic.map(t -> "<h2>%s</h2><p>%s.</p><hr>".formatted(t.title(), t.text())).orElse("");
    StringBuilder terms = new StringBuilder();
    for (HelpTopic term : TERMS) {
      terms.append("<p><b>%s</b>: %s.</p>".formatted(term.title(), term.text()));
    }
    return """
        <html><body style="margin: 8px">
        %s
        %s
        %s
        %s
        </body></html>
        """
        .formatted(first, Texts.of("help.page"), terms, Texts.of("help.page.end"));
  }
}
