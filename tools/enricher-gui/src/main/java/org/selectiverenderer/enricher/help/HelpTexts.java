package org.selectiverenderer.enricher.help;

import java.util.Optional;
import org.selectiverenderer.base.markup.Markup;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.Rule;

/** The vocabulary in the author's words (thesis 4.2.2). */
final class HelpTexts {
  public static final String TYPE =
      "consistent: people expect the object in places of these schemas. "
          + "inconsistent: they do not. frame: part of any place, such as a wall";
  public static final String DEGREE =
      "How strongly the object is expected. high: drawn with few polygons in its "
          + "schemas. low: with all polygons. A number from 0 (low) to 1 (high) for "
          + "versions in between";
  public static final String SCHEMAS =
      "The schemas (kinds of places, such as kitchen) in which this version is shown, separated by"
          + " commas";
  public static final String ENTER = "Schemas that become active when the viewer enters this area";
  public static final String EXIT = "Schemas that become active when the viewer leaves this area";

  private HelpTexts() {}

  /** What {@code validate --explain} says of a rule. */
  static String rule(Rule rule) {
    return """
        <html><body style="margin: 8px">
        <h2>%s</h2>
        <p><b>%s</b></p>
        <p>%s</p>
        <h3>%s</h3><pre>%s</pre>
        <h3>%s</h3><pre>%s</pre>
        <p>%s</p>
        </body></html>
        """
        .formatted(
            rule.id(),
            Markup.text(rule.summary().isEmpty() ? rule.template() : rule.summary()),
            Markup.text(rule.explanation()),
            Texts.of("problems.rule.bad"),
            Markup.text(rule.bad()),
            Texts.of("problems.rule.good"),
            Markup.text(rule.good()),
            Markup.text(rule.reference()));
  }

  /**
   * All of it.
   *
   * @param topic explained first
   */
  static String page(Optional<HelpTopic> topic) {
    String first =
        topic.map(t -> "<h2>%s</h2><p>%s.</p><hr>".formatted(t.title(), t.text())).orElse("");
    return """
        <html><body style="margin: 8px">
        %s
        <h2>Enriching a scene</h2>
        <p>An enriched scene tells the renderer which objects people expect in which place. What is
        expected gets little attention, so it can be drawn with fewer polygons.</p>
        <ol>
        <li>Choose an object (a <b>Switch</b>) on the left. Each of its choices is a version of it,
        with more or fewer polygons.</li>
        <li>State type, degree and schemas of each version.</li>
        <li>Choose an area (a <b>ProximitySensor</b>) and say which schemas become active when the
        viewer enters or leaves it.</li>
        <li>Look at <b>Preview</b>, then save. You see the changes before they are written.</li>
        </ol>
        <h3>Terms</h3>
        <p><b>Schema</b>: what people expect of a kind of place, such as an office or a kitchen.</p>
        <p><b>Type</b> (consistencyType): %s.</p>
        <p><b>Degree</b> (degreeOfConsistency): %s.</p>
        <p><b>Schemas</b> (schemaBelonginess): %s.</p>
        <p><b>On entering</b> (enterTimeSchema): %s.</p>
        <p><b>On leaving</b> (exitTimeSchema): %s.</p>
        <h3>Many objects at once</h3>
        <p>The tab <b>Schemas</b> has a table of all objects by all schemas: mark cells and type
        <i>low</i> or <i>high</i>. Scene &gt; Import Ratings makes the metadata from questionnaires.</p>
        <h3>Keys</h3>
        <p>Every menu shows its shortcuts. F8 goes to the next problem, Alt+Enter fixes it, F6 goes
        to the next part of the window, Ctrl+1 to Ctrl+3 choose a tab.</p>
        </body></html>
        """
        .formatted(first, TYPE, DEGREE, SCHEMAS, ENTER, EXIT);
  }
}
