package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.Objects;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.write.X3dNodeWriter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * A lit X3D file that is being written.
 *
 * @param file path of the file
 * @param place number of the file in {@link OutputFileIndex}
 * @param prefix a prefix of DEF names that no node of the scene has
 */
record LitFileWriter(X3dWriter out, X3dNodeWriter nodes, Path file, int place, String prefix)
    implements X3dNodeWriter.UrlRule {
  LitFileWriter(X3dWriter out, Path file, int place, String prefix) {
    this(out, new X3dNodeWriter(out, X3dNodeWriter.Written.CHANGED), file, place, prefix);
  }

  Path folder() {
    return Objects.requireNonNull(file.toAbsolutePath().getParent());
  }

  /** Returns the file's name without extension. */
  String stem() {
    return String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
  }

  @Override
  public String written(NodeView node, String url) {
    Path from = Path.of(node.location().file()).toAbsolutePath().getParent();
    return from == null ? url : UrlRelativizer.turned(url, from, folder());
  }
}
