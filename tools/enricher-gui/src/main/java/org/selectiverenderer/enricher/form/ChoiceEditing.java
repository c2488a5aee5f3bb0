package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The metadata of one choice of a Switch as texts that an author edits. Each change is one edit of
 * the document; an invalid text is not written, and the answer says why.
 */
final class ChoiceEditing {
  /** The text for a type that is not set. */
  static String none() {
    return DegreeInput.none();
  }

  private final EnricherSession session;
  private final DocumentElement element;
  private final int index;

  /**
   * @param element a Switch
   * @param index of the choice, from 0
   */
  ChoiceEditing(EnricherSession session, DocumentElement element, int index) {
    this.session = session;
    this.element = element;
    this.index = index;
  }

  private Optional<EnrichedSwitch> node() {
    return session
        .enrichment()
        .switchNode(element)
        .filter(switchNode -> index < switchNode.choices().size());
  }

  private ChoiceValues values() {
    return node().map(switchNode -> switchNode.values().get(index)).orElse(ChoiceValues.NONE);
  }

  String type() {
    return values().type().map(ConsistencyType::spelling).orElse(none());
  }

  String degree() {
    return DegreeInput.format(values().degree());
  }

  String schemas() {
    return SchemaList.format(values().schemas());
  }

  /** Sets the consistency type; returns why that fails, empty if it does not. */
  Optional<String> type(String word) {
    ChoiceValues before = values();
    return write(new ChoiceValues(ConsistencyType.of(word), before.degree(), before.schemas()));
  }

  /** Sets the degree of consistency; returns what is wrong with the text, empty for nothing. */
  Optional<String> degree(String text) {
    ChoiceValues before = values();
    Input<Optional<Degree>> input = DegreeInput.parse(text);
    if (input instanceof Input.Wrong<Optional<Degree>> wrong) {
      return Optional.of(wrong.why());
    }
    Optional<Degree> degree = ((Input.Valid<Optional<Degree>>) input).value();
    return write(new ChoiceValues(before.type(), degree, before.schemas()));
  }

  /** Sets the schemas; returns what is wrong with the text, empty for nothing. */
  Optional<String> schemas(String text) {
    Input<List<String>> input = SchemaList.parse(text);
    if (input instanceof Input.Wrong<List<String>> wrong) {
      return Optional.of(wrong.why());
    }
    return write(values().with(((Input.Valid<List<String>>) input).value()));
  }

  private Optional<String> write(ChoiceValues wanted) {
    node()
        .filter(now -> !now.values().get(index).equals(wanted))
        .ifPresent(
            now ->
                session.attempt(
                    () -> session.document().perform(session.edits().choice(now, index, wanted))));
    return Optional.empty();
  }
}
