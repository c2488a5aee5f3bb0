package org.selectiverenderer.authoring.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.model.ModelFormat;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.SourceLineReader;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * A scene in another encoding than X3D XML. Only XML documents can be edited without changing any
 * other byte, so such a scene is first converted to XML, with its comments.
 */
public final class XmlConversion {
  /** The number of bytes by which a model is recognised. */
  private static final int HEAD = 4096;

  private final Path file;
  private final String encoding;

  private XmlConversion(Path file, String encoding) {
    this.file = file;
    this.encoding = encoding;
  }

  /**
   * Detects the encoding of a file from its first characters.
   *
   * @return empty for XML, and for a file that is not a scene
   * @throws IOException if it cannot be read
   */
  public static Optional<XmlConversion> of(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      return Optional.empty(); // Opening it reports why it cannot be read.
    }
    try (InputStream in = Files.newInputStream(file)) {
      byte[] head = in.readNBytes(HEAD);
      Optional<ModelFormat> model = ModelFormat.of(file.toString(), head, head.length);
      if (model.isPresent()) {
        return Optional.of(new XmlConversion(file, model.get().title()));
      }
    }
    try (InputStream in = Files.newInputStream(file)) {
      return SceneEncoding.of(SourceLineReader.read(in, Files.size(file)).head())
          .filter(found -> found != SceneEncoding.XML)
          .map(found -> new XmlConversion(file, found.title()));
    }
  }

  /**
   * Opens a scene to be changed and saved to another file; a scene that is not X3D XML is
   * converted.
   *
   * @param output the file to which it will be saved
   * @param written a clause that says what is written, such as "metadata is written"
   * @return empty if it cannot be changed, which is reported
   * @throws IOException if it cannot be read
   */
  public static Optional<DocumentFile> open(
      Path scene, Path output, String written, NodeCatalogue catalogue, ProblemCollector problems)
      throws IOException {
    Optional<XmlConversion> foreign = of(scene);
    if (foreign.isEmpty()) {
      return Optional.of(DocumentFile.open(scene));
    }
    if (output.equals(scene)) {
      problems.error(
          SourceLocation.of(scene.toString()),
          "the scene is in %s, but %s as X3D XML; name an X3D file with --output"
              .formatted(foreign.get().encoding(), written));
      return Optional.empty();
    }
    Optional<String> xml = foreign.get().xml(catalogue, problems);
    return xml.isEmpty() ? Optional.empty() : Optional.of(DocumentFile.made(scene, xml.get()));
  }

  /** Returns the reader of the scene, which as a model may have files in its folder. */
  private X3dReader reader(NodeCatalogue catalogue) {
    X3dReader reader = new X3dReader(catalogue);
    Path parent = file.toAbsolutePath().getParent();
    Path folder = parent == null ? file.toAbsolutePath() : parent;
    return reader.with(
        new PrototypeLibraryLoader(reader, new UrlResolver(folder)), BaseUrl.folder(folder));
  }

  /** Returns the encoding's name for users. */
  public String encoding() {
    return encoding;
  }

  /** Returns the default file of its conversion, in the same folder. */
  public Path beside() {
    String name = String.valueOf(file.getFileName());
    int dot = name.indexOf('.', 1);
    return file.resolveSibling((dot < 0 ? name : name.substring(0, dot)) + ".x3d");
  }

  /**
   * Converts the scene to X3D XML.
   *
   * @param problems receives problems about parts that are left out
   * @return empty if the scene is broken, which is reported, because nothing may be lost silently
   * @throws IOException if it cannot be read
   */
  public Optional<String> xml(NodeCatalogue catalogue, ProblemCollector problems)
      throws IOException {
    XmlDocument document;
    try (InputStream in = Files.newInputStream(file)) {
      document = reader(catalogue).document(file.toString(), in, Files.size(file));
    }
    for (DocumentError fault : document.faults()) {
      if (fault.kind() == DocumentError.Kind.MODEL) {
        problems.warning(fault.location(), fault.message());
      } else if (fault.kind() != DocumentError.Kind.ENCODING) {
        problems.error(fault.location(), fault.message() + "; the scene is not converted");
      }
    }
    return document.broken()
        ? Optional.empty()
        : Optional.of(SceneFormat.XML.text(document, catalogue, problems));
  }
}
