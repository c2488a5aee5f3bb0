package org.selectiverenderer.authoring.packaging;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.packaging.UrlFields.UrlField;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.model.ModelFormat;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.SourceLineReader;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.XmlParseException;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Reads files that may be scenes, and changes urls in their texts. */
final class SceneFileReader {
  private static final int HEAD = 4096;

  private final NodeCatalogue catalogue;
  private final UrlResolver resolver;

  SceneFileReader(NodeCatalogue catalogue, UrlResolver resolver) {
    this.catalogue = catalogue;
    this.resolver = resolver;
  }

  /**
   * A scene as text with its elements.
   *
   * @param encoding the encoding; attributes of XML have places in the text
   */
  record SceneFile(DocumentSnapshot text, List<DocumentElement> elements, SceneEncoding encoding) {
    /** Returns the bytes of the file after changes. */
    byte[] bytes(List<TextEdit> edits) {
      return text.bytes(new Edit("", edits));
    }

    /** Returns the changes that give a field other urls; empty if the text cannot be changed. */
    Optional<List<TextEdit>> changed(UrlField field, List<String> urls) {
      if (text.locked().isPresent()) {
        return Optional.empty();
      }
      if (encoding == SceneEncoding.XML) {
        List<String> written = urls.stream().map(UrlLiterals::plainlyQuoted).toList();
        return Optional.of(
            List.of(
                text.layout()
                    .attribute(field.element(), field.attribute(), String.join(" ", written))));
      }
      return new UrlLiterals(text.text(), encoding == SceneEncoding.JSON).changed(field, urls);
    }
  }

  /** Returns a text in X3D XML as a scene; empty if it is not well-formed. */
  Optional<SceneFile> text(Path file, DocumentSnapshot text) {
    try {
      return Optional.of(new SceneFile(text, elements(text.elements()), SceneEncoding.XML));
    } catch (XmlParseException e) {
      return Optional.empty();
    }
  }

  private static List<DocumentElement> elements(ElementTree tree) {
    List<DocumentElement> all = new ArrayList<>();
    tree.root().visit(all::add);
    return all;
  }

  /**
   * Reads a file; empty if it is no scene in text, or not well-formed.
   *
   * @throws IOException if it cannot be read, with a sentence
   */
  Optional<SceneFile> file(Path file) throws IOException {
    if (model(file).isPresent()) {
      return Optional.empty();
    }
    Optional<SceneEncoding> encoding;
    try (InputStream in = Files.newInputStream(file)) {
      encoding = SceneEncoding.of(SourceLineReader.read(in, Files.size(file)).head());
    }
    if (encoding.isEmpty()) {
      return Optional.empty();
    }
    byte[] bytes = InputFileReader.bytes(file);
    DocumentSnapshot text = SceneDocument.of(file.toString(), bytes).snapshot();
    if (encoding.get() == SceneEncoding.XML) {
      return text(file, text);
    }
    X3dReader reader = new X3dReader(catalogue);
    try (InputStream in = Files.newInputStream(file)) {
      var document = reader.document(file.toString(), in, Files.size(file));
      return document.broken()
          ? Optional.empty()
          : Optional.of(new SceneFile(text, document.elements(), encoding.get()));
    }
  }

  private static Optional<ModelFormat> model(Path file) throws IOException {
    byte[] head = ScenePackager.head(file, HEAD);
    return ModelFormat.of(file.toString(), head, head.length);
  }

  /** Returns the files that a model refers to, such as its buffers; none if it is no model. */
  List<Path> filesOfModel(Path file) throws IOException {
    if (model(file).isEmpty()) {
      return List.of();
    }
    ContentAccessPolicy named =
        new ContentAccessPolicy(resolver.access().folders(), HttpFetcher.none());
    Path folder = file.getParent();
    X3dReader reader = new X3dReader(catalogue);
    reader =
        reader.with(
            new PrototypeLibraryLoader(reader, new UrlResolver(folder, named)),
            BaseUrl.folder(folder));
    List<Path> found = new ArrayList<>();
    try (InputStream in = Files.newInputStream(file)) {
      var document = reader.document(file.toString(), in, Files.size(file));
      for (UrlField field : new UrlFields(catalogue).of(document.elements())) {
        for (String url : field.urls()) {
          new UrlResolver(folder, named).note(url, BaseUrl.folder(folder));
        }
      }
    }
    named.named().list().stream()
        .filter(other -> !other.equals(file) && resolver.mayBeNamed(other))
        .forEach(found::add);
    return found;
  }
}
