package org.selectiverenderer.authoring;

import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.TextSource;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * An immutable snapshot of a document, which any thread may read.
 *
 * @param name name of the file
 * @param revision the document's revision
 * @param text all characters
 * @param locked the reason why the document is read-only, as a sentence; empty if it can be changed
 * @param encoder encodes a text into the bytes that saving would write
 */
public record DocumentSnapshot(
    String name,
    long revision,
    String text,
    Optional<String> locked,
    Function<String, byte[]> encoder) {
  /** Returns the bytes that saving would write. */
  public byte[] bytes() {
    return encoder.apply(text);
  }

  /** Returns the bytes that saving would write after an edit. */
  public byte[] bytes(Edit edit) {
    return encoder.apply(TextEdit.applied(edit.changes(), text).toString());
  }

  /**
   * Parses the text into new elements, which are not those of the document.
   *
   * @throws XmlParseException where the text is not well formed
   */
  public ElementTree elements() throws XmlParseException {
    return ElementTree.of(new TextSource(name, text), revision);
  }

  /** Returns the formatter that writes additions in the author's style. */
  public SourceFormatter layout() {
    return new SourceFormatter(text);
  }
}
