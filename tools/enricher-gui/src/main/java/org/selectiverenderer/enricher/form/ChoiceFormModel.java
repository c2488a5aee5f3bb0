package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The metadata of one choice of a Switch as texts that an author edits. Each change is one edit of
 * the document; an invalid text is not written, and the answer says why.
 */
final class ChoiceFormModel {
  /** The text for a type that is not set. */
  static String none() {
    return DegreeFormat.none();
  }

  private final EnricherSession session;
  private final DocumentElement element;
  private final int index;

  /**
   * @param element a Switch
   * @param index of the choice, from 0
   */
  ChoiceFormModel(EnricherSession session, DocumentElement element, int index) {
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

  private ChoiceMetadata values() {
    return node().map(switchNode -> switchNode.values().get(index)).orElse(ChoiceMetadata.NONE);
  }

  String type() {
    return values().type().map(ConsistencyType::spelling).orElse(none());
  }

  String degree() {
    return DegreeFormat.format(values().degree());
  }

  String schemas() {
    return SchemaListFormat.format(values().schemas());
  }

  /** Sets the consistency type; returns why that fails, empty if it does not. */
  Optional<String> type(String word) {
    ChoiceMetadata before = values();
    return write(new ChoiceMetadata(ConsistencyType.of(word), before.degree(), before.schemas()));
  }

  /** Sets the degree of consistency; returns what is wrong with the text, empty for nothing. */
  Optional<String> degree(String text) {
    ChoiceMetadata before = values();
    ParseResult<Optional<ConsistencyDegree>> input = DegreeFormat.parse(text);
    if (input instanceof ParseResult.Wrong<Optional<ConsistencyDegree>> wrong) {
      return Optional.of(wrong.why());
    }
    Optional<ConsistencyDegree> degree =
        ((ParseResult.Valid<Optional<ConsistencyDegree>>) input).value();
    return write(new ChoiceMetadata(before.type(), degree, before.schemas()));
  }

  /** Sets the schemas; returns what is wrong with the text, empty for nothing. */
  Optional<String> schemas(String text) {
    ParseResult<List<String>> input = SchemaListFormat.parse(text);
    if (input instanceof ParseResult.Wrong<List<String>> wrong) {
      return Optional.of(wrong.why());
    }
    return write(values().with(((ParseResult.Valid<List<String>>) input).value()));
  }

  private Optional<String> write(ChoiceMetadata wanted) {
    node()
        .filter(now -> !now.values().get(index).equals(wanted))
        .ifPresent(
            now ->
                session.attempt(
                    () -> session.document().perform(session.edits().choice(now, index, wanted))));
    return Optional.empty();
  }
}
