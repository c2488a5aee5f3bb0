package org.selectiverenderer.authoring.packaging;

import java.util.List;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A scene with the files that it names.
 *
 * @param scene the scene itself
 * @param files the other files in the order in which they are named
 * @param left what is left out
 * @param edits the changes of the scene's text, if it is X3D XML
 */
public record ScenePackage(
    PackagedFile scene, List<PackagedFile> files, List<LeftOut> left, List<TextEdit> edits) {
  public ScenePackage {
    files = List.copyOf(files);
    left = List.copyOf(left);
    edits = List.copyOf(edits);
  }

  /**
   * A url whose file is not taken.
   *
   * @param file the file that has the url
   * @param reason a predicate that follows "url ... "
   */
  public record LeftOut(String file, String url, String reason) {}
}
