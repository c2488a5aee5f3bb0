package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.function.Supplier;
import org.selectiverenderer.enricher.text.Texts;

/** A text field for schemas separated by commas that proposes the schemas of the scene. */
final class SchemaListField extends CompletingField<String> {
  private static final long serialVersionUID = 1L;

  private final transient Supplier<List<String>> known;

  SchemaListField(Supplier<List<String>> known) {
    super(Texts.of("form.known"));
    this.known = known;
  }

  @Override
  List<String> proposals(boolean asked) {
    int caret = getCaretPosition();
    List<String> found = SchemaListFormat.proposals(getText(), caret, known.get());
    boolean begun = caret > 0 && Character.isLetterOrDigit(getText().charAt(caret - 1));
    boolean done = found.size() == 1 && getText().substring(0, caret).endsWith(found.get(0));
    return !done && (asked || begun) ? found : List.of();
  }

  @Override
  void take(String schema) {
    SchemaListFormat.Completed completed =
        SchemaListFormat.complete(getText(), getCaretPosition(), schema);
    setText(completed.text());
    setCaretPosition(completed.caret());
  }
}
