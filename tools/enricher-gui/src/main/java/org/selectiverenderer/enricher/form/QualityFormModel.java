package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.QualityEdits;
import org.selectiverenderer.authoring.enrichment.QualityTargets;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The texts in the form of one quality that is a field, and of its levels: reads them from the
 * document as it is now, and writes them, each as one undo step. What the document no longer has
 * reads as an empty text.
 */
final class QualityFormModel {
  private final EnricherSession session;
  private final DocumentElement element;
  private final int index;

  /**
   * @param element the Switch
   * @param index of the quality among those of the Switch
   */
  QualityFormModel(EnricherSession session, DocumentElement element, int index) {
    this.session = session;
    this.element = element;
    this.index = index;
  }

  /** The quality, and the Switch that has it. */
  private record Now(EnrichedSwitch node, EnrichedField field) {}

  private Optional<Now> now() {
    return session
        .enrichment()
        .switchNode(element)
        .filter(node -> index < node.fields().size())
        .map(node -> new Now(node, node.fields().get(index)));
  }

  private Optional<EnrichedField.Level> of(int level) {
    return now()
        .map(now -> now.field().levels())
        .filter(levels -> level < levels.size())
        .map(levels -> levels.get(level));
  }

  private QualityEdits edits() {
    return new QualityEdits(session.document());
  }

  private QualityTargets targets() {
    return new QualityTargets(session.document(), session.catalogue());
  }

  private void edit(Function<Now, Edit> making) {
    now().ifPresent(now -> session.attempt(() -> session.perform(making.apply(now))));
  }

  String quality() {
    return now().map(now -> now.field().quality().spelling()).orElse("");
  }

  /** Sets what the levels differ in. */
  Optional<String> quality(String word) {
    edit(now -> edits().quality(now.field(), Quality.of(word).orElseThrow()));
    return Optional.empty();
  }

  String target() {
    return now().map(now -> now.field().target().toString()).orElse("");
  }

  /** Sets the field; returns what is wrong with the text, empty for nothing. */
  Optional<String> target(String text) {
    Optional<FieldReference> wanted = FieldReference.of(text);
    if (wanted.isEmpty()) {
      return Optional.of(Texts.of("quality.target.form"));
    }
    Optional<String> wrong = targets().wrong(element, wanted.get()).map(Remarks::shown);
    if (wrong.isEmpty()) {
      edit(now -> edits().target(now.node(), now.field(), wanted.get()));
    }
    return wrong;
  }

  /** Returns what is wrong with the field that the document names; empty for nothing. */
  Optional<String> wrongTarget() {
    return now()
        .flatMap(now -> targets().wrong(element, now.field().target()))
        .map(Remarks::shown);
  }

  String value(int level) {
    return now()
        .flatMap(
            now ->
                of(level)
                    .map(of -> targets().shown(element, now.field().target(), of.values())))
        .orElse("");
  }

  /** Sets the value of a level; returns what is wrong with the text, empty for nothing. */
  Optional<String> value(int level, String text) {
    if (now().isEmpty()) {
      return Optional.empty();
    }
    FieldReference target = now().get().field().target();
    List<String> values = targets().values(element, target, text);
    Optional<String> wrong = targets().wrong(element, target, values).map(Remarks::shown);
    if (wrong.isEmpty()) {
      edit(now -> edits().value(now.field(), level, values));
    }
    return wrong;
  }

  /** Returns what is wrong with the value of a level in the document; empty for nothing. */
  Optional<String> wrongValue(int level) {
    return now()
        .flatMap(
            now ->
                of(level)
                    .flatMap(of -> targets().wrong(element, now.field().target(), of.values())))
        .map(Remarks::shown)
        .or(() -> twice(level));
  }

  private Optional<String> twice(int level) {
    return IntStream.range(0, level)
        .filter(before -> value(before).equals(value(level)))
        .mapToObj(before -> Texts.of("quality.value.twice", String.valueOf(before + 1)))
        .findFirst();
  }

  /** Returns the model of a level's consistency and schemas. */
  MetadataFormModel metadata(int level) {
    return new MetadataFormModel(
        session,
        () -> of(level).map(EnrichedField.Level::metadata),
        wanted -> described(level, wanted));
  }

  private Edit described(int level, ChoiceMetadata wanted) {
    Now now = now().orElseThrow();
    return edits().metadata(now.node(), now.field(), level, wanted);
  }

  void addLevel() {
    edit(now -> edits().addLevel(now.field()));
  }

  void removeLevel(int level) {
    edit(now -> edits().removeLevel(now.field(), level));
  }

  void remove() {
    edit(now -> edits().remove(now.node(), now.field()));
  }
}
