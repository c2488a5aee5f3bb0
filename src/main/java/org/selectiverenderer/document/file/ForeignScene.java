package org.selectiverenderer.document.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentFault;
import org.selectiverenderer.x3d.source.Encoding;
import org.selectiverenderer.x3d.source.SourceLines;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * A scene in another encoding than X3D XML. Only XML is edited, since only there what an edit
 * leaves alone keeps every byte; such a scene is converted first, with its comments.
 */
public final class ForeignScene {
  private final Path file;
  private final Encoding encoding;

  private ForeignScene(Path file, Encoding encoding) {
    this.file = file;
    this.encoding = encoding;
  }

  /**
   * Looks at a file's first characters.
   *
   * @return empty for XML, and for what is no scene at all
   * @throws IOException if it cannot be read
   */
  public static Optional<ForeignScene> of(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      return Optional.empty(); // Who opens it says why it cannot be.
    }
    try (InputStream in = Files.newInputStream(file)) {
      return Encoding.of(SourceLines.read(in, Files.size(file)).head())
          .filter(found -> found != Encoding.XML)
          .map(found -> new ForeignScene(file, found));
    }
  }

  /** What users call its encoding. */
  public String encoding() {
    return encoding.title();
  }

  /** The file beside it that its conversion goes into by default. */
  public Path beside() {
    String name = String.valueOf(file.getFileName());
    int dot = name.indexOf('.', 1);
    return file.resolveSibling((dot < 0 ? name : name.substring(0, dot)) + ".x3d");
  }

  /**
   * The scene in X3D XML.
   *
   * @param problems takes what is left out
   * @return empty if it is broken, which is told: nothing may be lost without notice
   * @throws IOException if it cannot be read
   */
  public Optional<String> xml(NodeCatalogue catalogue, Problems problems) throws IOException {
    XmlDocument document;
    try (InputStream in = Files.newInputStream(file)) {
      document = new X3dReader(catalogue).document(file.toString(), in, Files.size(file));
    }
    for (DocumentFault fault : document.faults()) {
      if (fault.kind() != DocumentFault.Kind.ENCODING) {
        problems.error(fault.location(), fault.message() + "; the scene is not converted");
      }
    }
    return document.broken()
        ? Optional.empty()
        : Optional.of(SceneFormat.XML.text(document, catalogue, problems));
  }
}
