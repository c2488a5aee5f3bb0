package org.selectiverenderer.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.authoring.packaging.UrlFields;
import org.selectiverenderer.authoring.packaging.UrlFields.UrlField;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlRelativizer;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Finds and reads the files that a scene names and may read, as X3D XML. */
final class SceneFiles {
  private final NodeCatalogue catalogue;
  private final UrlResolver resolver;
  private final ProblemCollector problems;

  SceneFiles(NodeCatalogue catalogue, UrlResolver resolver, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.resolver = resolver;
    this.problems = problems;
  }

  /**
   * The file that a url field names.
   *
   * @param fragment what follows {@code #} in the url; empty without
   */
  record Target(Path file, String fragment) {}

  /** Returns what the url field of an element names, if it is a file that the scene may read. */
  Optional<Target> target(DocumentElement element, Path file) {
    for (String named : MFStringParser.strings(element.text("url").orElse(""))) {
      int at = named.indexOf('#');
      String url = at < 0 ? named : named.substring(0, at);
      if (resolver.resolve(url, BaseUrl.folder(folder(file)))
              instanceof UrlResolver.Target.Found found
          && found.content().file().isPresent()) {
        return Optional.of(
            new Target(found.content().file().get(), at < 0 ? "" : named.substring(at + 1)));
      }
    }
    return Optional.empty();
  }

  /** Returns the name of a file in messages. */
  String display(Path file) {
    return resolver.display(file);
  }

  /** Returns the changes that make the urls of a file relative to another one. */
  List<TextEdit> urls(SceneDocument content, Path from, Path to) {
    List<TextEdit> edits = new ArrayList<>();
    for (UrlField field : new UrlFields(catalogue).of(elements(content))) {
      List<String> now =
          field.urls().stream()
              .map(url -> UrlRelativizer.turned(url, folder(from), folder(to)))
              .toList();
      if (!now.equals(field.urls())) {
        edits.add(
            content
                .layout()
                .attribute(field.element(), field.attribute(), FieldValueFormatter.strings(now)));
      }
    }
    return edits;
  }

  /** Returns all elements of a document, in its order. */
  static List<DocumentElement> elements(SceneDocument document) {
    List<DocumentElement> all = new ArrayList<>();
    document.tree().orElseThrow().root().visit(all::add);
    return all;
  }

  private static Path folder(Path file) {
    Path folder = file.getParent();
    return folder == null ? file : folder;
  }

  /** Reads a file that may be anything; empty for what is no scene or not well-formed. */
  Optional<SceneDocument> readQuietly(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    return read(file, file.toString(), new ProblemCollector());
  }

  /** Reads a file; empty if that cannot be done, which is reported. */
  Optional<SceneDocument> read(Path file, String name) throws IOException {
    return read(file, name, problems);
  }

  private Optional<SceneDocument> read(Path file, String name, ProblemCollector to)
      throws IOException {
    Optional<XmlConversion> foreign = XmlConversion.of(file);
    SceneDocument document;
    if (foreign.isPresent()) {
      Optional<String> xml = foreign.get().xml(catalogue, to);
      if (xml.isEmpty()) {
        return Optional.empty();
      }
      document = SceneDocument.of(name, xml.get().getBytes(StandardCharsets.UTF_8));
    } else {
      document = SceneDocument.of(name, InputFileReader.bytes(file));
    }
    if (document.tree().isEmpty()) {
      document.fault().ifPresent(fault -> to.error(fault.location(), fault.message()));
      return Optional.empty();
    }
    Optional<String> locked = document.locked();
    if (locked.isPresent()) {
      to.error(SourceLocation.of(name), locked.get());
      return Optional.empty();
    }
    return Optional.of(document);
  }
}
