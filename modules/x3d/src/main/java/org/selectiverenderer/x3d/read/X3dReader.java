package org.selectiverenderer.x3d.read;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.json.X3dJsonParser;
import org.selectiverenderer.x3d.model.ModelFile;
import org.selectiverenderer.x3d.model.ModelFormat;
import org.selectiverenderer.x3d.model.TranslatedModel;
import org.selectiverenderer.x3d.page.PageParser;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.DocumentParser;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.source.Preflight;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.source.SceneBytes;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.SourceText;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.source.XmlPullParser;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.vrml.VrmlParser;
import org.selectiverenderer.x3d.vrml1.Vrml1Parser;

/**
 * Reads scenes of X3D 3.0 to 4.1 in the XML (ISO/IEC 19776-1), ClassicVRML (ISO/IEC 19776-2) and
 * JSON encodings, of VRML97 (ISO/IEC 14772-1), VRML 1.0, and in HTML pages, plain or compressed by
 * gzip; the encoding is detected by the first bytes. Models of other programs, such as glTF, are
 * translated into X3D by {@code x3d.model} first. For any input the result is a scene of the valid
 * parts and problems with locations for the others, in bounded memory. Nothing is fetched: no DTD,
 * no external entity, no Inline; prototypes of other files are provided by {@link #with}.
 *
 * <p>Prototype instances are expanded. The first node of the body replaces the instance; further
 * nodes of the body are reachable by routes only.
 *
 * <p>Immutable and thread-safe.
 */
public final class X3dReader {
  private final NodeCatalogue catalogue;
  private final ReadLimits limits;
  private final PrototypeLibraryProvider libraries;
  private final BaseUrl base;
  private final boolean parts;

  /** Creates a reader with the standard limits. */
  public X3dReader(NodeCatalogue catalogue) {
    this(catalogue, ReadLimits.standard());
  }

  /** Returns the catalogue of node types. */
  public NodeCatalogue catalogue() {
    return catalogue;
  }

  /** Creates a reader with given limits. */
  public X3dReader(NodeCatalogue catalogue, ReadLimits limits) {
    this(catalogue, limits, PrototypeLibraryProvider.none(), BaseUrl.folder(Path.of("")), false);
  }

  private X3dReader(
      NodeCatalogue catalogue,
      ReadLimits limits,
      PrototypeLibraryProvider libraries,
      BaseUrl base,
      boolean parts) {
    this.catalogue = catalogue;
    this.limits = limits;
    this.libraries = libraries;
    this.base = base;
    this.parts = parts;
  }

  /**
   * Returns a reader of files that use prototypes of other files.
   *
   * @param from provides those prototypes
   * @param newBase the base of the relative urls of the files
   */
  public X3dReader with(PrototypeLibraryProvider from, BaseUrl newBase) {
    return new X3dReader(catalogue, limits, from, newBase, parts);
  }

  /** Returns a reader of scene fragments, in which any node may be at the top level. */
  public X3dReader ofParts() {
    return new X3dReader(catalogue, limits, libraries, base, true);
  }

  private ReadContext state(String source, ProblemCollector problems) {
    return new ReadContext(source, catalogue, limits, problems, libraries, base, parts);
  }

  /**
   * Reads the prototypes of a file.
   *
   * @throws IOException if it cannot be read or is refused
   */
  PrototypeLibrary library(UrlContent content) throws IOException {
    XmlDocument document;
    try (InputStream in = content.open()) {
      document = document(content.name(), in, content.size());
    }
    for (DocumentError fault : document.faults()) {
      if (fault.kind() == DocumentError.Kind.REFUSED) {
        throw new IOException(fault.message());
      }
    }
    ProblemCollector problems = new ProblemCollector();
    ReadContext reading = with(libraries, content.base()).state(content.name(), problems);
    reading.base(content.base());
    return new PrototypeLibraryReader(reading, problems).read(document);
  }

  /**
   * Reads a file; problems name it by the given path.
   *
   * @throws IOException if the file is missing or cannot be read, with a one-line message that
   *     names it
   */
  public X3dFile read(Path file, ProblemCollector problems) throws IOException {
    String name = file.toString();
    if (Files.isDirectory(file)) {
      throw new IOException(name + ": this is a folder, not a file");
    }
    try (InputStream in = Files.newInputStream(file)) {
      SceneBytes bytes = SceneBytes.read(in, Files.size(file), limits);
      return parse(name, beside(file).preflight(name, bytes), problems);
    } catch (NoSuchFileException e) {
      throw new IOException(name + ": the file does not exist", e);
    } catch (AccessDeniedException e) {
      throw new IOException(name + ": no permission to read the file", e);
    } catch (IOException e) {
      throw new IOException(name + ": the file cannot be read: " + e.getMessage(), e);
    }
  }

  /**
   * Reads a stream to its end; the caller closes it.
   *
   * @param source the name of the scene in problems
   * @throws IOException if the stream itself fails
   */
  public X3dFile read(String source, InputStream in, ProblemCollector problems) throws IOException {
    return parse(source, preflight(source, SceneBytes.read(in, 0, limits)), problems);
  }

  /**
   * Reads a stream of known length to its end; the caller closes it.
   *
   * @param source the name of the scene in problems
   * @param size the approximate size in bytes, which saves copying
   * @throws IOException if the stream itself fails
   */
  public X3dFile read(String source, InputStream in, long size, ProblemCollector problems)
      throws IOException {
    return parse(source, preflight(source, SceneBytes.read(in, size, limits)), problems);
  }

  /**
   * Reads a scene in memory.
   *
   * @param source the name of the scene in problems
   */
  public X3dFile read(String source, byte[] bytes, ProblemCollector problems) {
    return parse(source, preflight(source, SceneBytes.of(bytes, limits)), problems);
  }

  /**
   * Reads a text, such as one being edited.
   *
   * @param source the name of the scene in problems
   */
  public X3dFile read(String source, CharSequence text, ProblemCollector problems) {
    return parse(source, Preflight.of(source, SourceText.of(text)), problems);
  }

  /**
   * Returns a scene of one prototype instance with the default values of its fields.
   *
   * @param source the name of the scene in problems
   * @param name the name of a prototype of the library
   */
  public X3dFile instance(
      String source, PrototypeLibrary library, String name, ProblemCollector problems) {
    String text =
        "<X3D version='4.0' profile='Full'><Scene><ProtoInstance name=\"%s\"/></Scene></X3D>"
            .formatted(MarkupEscaper.attribute(name));
    ReadContext reading = ofParts().state(source, problems);
    XmlPullParser xml = Preflight.of(source, SourceText.of(text)).events();
    return new X3dElementReader(reading, library.scope()).read(new XmlCursor(xml, reading, false));
  }

  /**
   * Parses a stream to a document, the tree of all elements with their locations, without
   * interpreting them. The caller closes the stream.
   *
   * @param source the name of the document in locations
   * @param size the approximate size in bytes, which saves copying
   * @throws IOException if the stream fails; syntax errors are faults of the document
   */
  public XmlDocument document(String source, InputStream in, long size) throws IOException {
    SceneBytes bytes = SceneBytes.read(in, size, limits);
    return DocumentParser.parse(
        source, bytes, preflight(source, bytes), catalogue, limits, this::parser);
  }

  /** Checks a file; a model of another program is translated into X3D. */
  private Preflight preflight(String source, SceneBytes bytes) {
    Optional<ModelFormat> format =
        bytes.refused() != null || bytes.cut() != null
            ? Optional.empty()
            : ModelFormat.of(source, bytes.bytes(), bytes.length());
    if (format.isEmpty()) {
      return Preflight.of(source, bytes);
    }
    ProblemCollector problems = new ProblemCollector();
    ModelFile model =
        new ModelFile(
            source, format.get(), bytes.bytes(), bytes.length(), libraries.files(), base, limits);
    TranslatedModel translated = TranslatedModel.of(model, problems);
    if (translated.refused() != null) {
      return Preflight.refused(source, translated.refused());
    }
    List<DocumentError> faults = new ArrayList<>();
    for (Problem problem : problems.list()) {
      faults.add(
          new DocumentError(DocumentError.Kind.MODEL, problem.location(), problem.message()));
    }
    return Preflight.translated(source, translated.text(), faults);
  }

  /** Returns this reader for a file, which as a model may refer to others in its folder. */
  private X3dReader beside(Path file) {
    if (libraries.files().isPresent()) {
      return this;
    }
    Path parent = file.toAbsolutePath().getParent();
    Path folder = parent == null ? file.toAbsolutePath() : parent;
    UrlResolver root = new UrlResolver(folder);
    PrototypeLibraryProvider known = libraries;
    PrototypeLibraryProvider withFiles =
        new PrototypeLibraryProvider() {
          @Override
          public Answer find(List<String> urls, BaseUrl from) {
            return known.find(urls, from);
          }

          @Override
          public Optional<UrlResolver> files() {
            return Optional.of(root);
          }
        };
    return with(withFiles, BaseUrl.folder(folder));
  }

  /** Returns the scene of a document, without parsing it again. */
  public X3dFile scene(XmlDocument document, ProblemCollector problems) {
    ReadContext reading = state(document.name(), problems);
    return new X3dElementReader(reading).read(TreeCursor.of(document, reading));
  }

  private X3dFile parse(String source, Preflight preflight, ProblemCollector problems) {
    SourceLocation whole = SourceLocation.of(source);
    if (preflight.refused()) {
      problems.error(whole, preflight.faults().get(0).message());
      return X3dFile.empty(source);
    }
    DocumentError cut = preflight.cut();
    if (cut != null && preflight.text().length() == 0) {
      problems.error(whole, cut.message() + "; nothing can be shown");
      return X3dFile.empty(source);
    }
    if (preflight.text().complaint() != null) {
      problems.warning(whole, preflight.text().complaint());
    }
    for (DocumentError fault : preflight.faults()) {
      if (fault.kind() == DocumentError.Kind.MODEL) {
        problems.warning(fault.location(), fault.message());
      }
    }
    if (preflight.encoding() != SceneEncoding.XML) {
      return tree(preflight, problems);
    }
    XmlPullParser xml = preflight.events();
    if (xml.fault() != null) {
      problems.error(xml.fault().location(), xml.fault().message() + "; nothing can be shown");
      return X3dFile.empty(source);
    }
    ReadContext reading = state(source, problems);
    X3dFile file = new X3dElementReader(reading).read(new XmlCursor(xml, reading, cut != null));
    if (cut != null) {
      boolean limit = cut.kind() == DocumentError.Kind.LIMIT;
      problems.error(
          limit ? cut.location() : whole, cut.message() + "; the part before it is kept");
    }
    return file;
  }

  /** Reads a scene in an encoding other than XML, by way of its element tree. */
  private X3dFile tree(Preflight preflight, ProblemCollector problems) {
    XmlDocument document = DocumentParser.parse(preflight, catalogue, limits, this::parser);
    X3dFile file = scene(document, problems);
    DocumentError cut = preflight.cut();
    if (cut != null) {
      problems.error(
          SourceLocation.of(document.name()), cut.message() + "; the part before it is kept");
    }
    String rest =
        document.root().isPresent() ? "; the part before it is kept" : "; nothing can be shown";
    for (DocumentError fault : document.faults()) {
      if (fault.kind() == DocumentError.Kind.MODEL) {
        problems.warning(fault.location(), fault.message());
      } else {
        problems.error(fault.location(), fault.message() + rest);
      }
    }
    return file;
  }

  private ElementTreeBuilder.Parser parser(SceneEncoding encoding) {
    return switch (encoding) {
      case CLASSIC, VRML97 -> new VrmlParser(catalogue, encoding);
      case VRML1 -> new Vrml1Parser();
      case PAGE -> new PageParser(catalogue);
      case JSON -> new X3dJsonParser(catalogue);
      case XML -> throw new IllegalArgumentException("XML is parsed by events");
    };
  }
}
