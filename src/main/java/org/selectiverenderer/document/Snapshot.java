package org.selectiverenderer.document;

import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextChange;
import org.selectiverenderer.x3d.source.TextSource;
import org.selectiverenderer.x3d.source.XmlFault;

/**
 * A document as it was at one moment; a value that any thread may read.
 *
 * @param name of the file
 * @param revision of the document then
 * @param text all characters
 * @param locked why the document cannot be changed without harm: a sentence; empty when it can
 * @param encoder gives the bytes that saving a text would write
 */
public record Snapshot(
    String name,
    long revision,
    String text,
    Optional<String> locked,
    Function<String, byte[]> encoder) {
  /** The bytes that saving would write. */
  public byte[] bytes() {
    return encoder.apply(text);
  }

  /** The bytes that saving would write after an edit. */
  public byte[] bytes(Edit edit) {
    return encoder.apply(TextChange.applied(edit.changes(), text).toString());
  }

  /**
   * The elements of the text, not those of the document.
   *
   * @throws XmlFault where the text is not well formed
   */
  public ElementTree elements() throws XmlFault {
    return ElementTree.of(new TextSource(name, text), revision);
  }

  /** How to lay out what an edit adds, after the hand of the author. */
  public Layout layout() {
    return new Layout(text);
  }
}
