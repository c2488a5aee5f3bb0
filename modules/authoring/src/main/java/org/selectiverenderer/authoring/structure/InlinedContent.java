package org.selectiverenderer.authoring.structure;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/** The content of a scene, to stand in another scene in the place of an Inline of it. */
public final class InlinedContent {
  private final Pieces pieces;

  /**
   * Prepares the content.
   *
   * @param scene the document of the inlined file
   * @param elements its elements that go into the other scene
   * @param names generates the names that are unused in the other scene
   * @param changes further changes of the elements' text, at offsets of the inlined file
   */
  public InlinedContent(
      SceneDocument scene,
      List<DocumentElement> elements,
      UniqueNameGenerator names,
      List<TextEdit> changes) {
    pieces = new Pieces(scene, elements);
    pieces.written();
    pieces.rename(names, Map.of());
    changes.forEach(pieces::change);
  }

  /** Returns the text of one of the elements as lines, with names that are free. */
  public List<String> lines(DocumentElement element) {
    return pieces.lines(element);
  }
}
