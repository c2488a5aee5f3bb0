package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

/**
 * The metadata of a version, or of a level of another quality, as texts that an author edits. Each
 * change is one edit of the document; an invalid text is not written, and the answer says why.
 */
final class MetadataFormModel {
  /** The text for a type that is not set. */
  static String none() {
    return DegreeFormat.none();
  }

  private final EnricherSession session;
  private final Supplier<Optional<ChoiceMetadata>> read;
  private final Function<ChoiceMetadata, Edit> edit;

  /**
   * @param read the metadata in the document; empty where they are gone
   * @param edit makes the edit that sets other metadata
   */
  MetadataFormModel(
      EnricherSession session,
      Supplier<Optional<ChoiceMetadata>> read,
      Function<ChoiceMetadata, Edit> edit) {
    this.session = session;
    this.read = read;
    this.edit = edit;
  }

  private ChoiceMetadata values() {
    return read.get().orElse(ChoiceMetadata.NONE);
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
    read.get()
        .filter(now -> !now.equals(wanted))
        .ifPresent(now -> session.attempt(() -> session.document().perform(edit.apply(wanted))));
    return Optional.empty();
  }
}
