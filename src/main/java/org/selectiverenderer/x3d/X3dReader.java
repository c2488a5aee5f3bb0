package org.selectiverenderer.x3d;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLStreamException;
import org.jspecify.annotations.Nullable;

/**
 * Reads scenes in the XML encoding of X3D 3.0 to 4.0 (ISO/IEC 19776-1), plain or compressed by
 * gzip. Whatever a file holds, reading it ends with a scene of what could be read, problems with
 * their places for the rest, and bounded memory. Nothing is fetched: no DOCTYPE, no entity, no
 * Inline.
 *
 * <p>Prototypes are replaced by what they stand for. Of an instance's body the first node takes the
 * instance's place; further nodes of the body are reachable by routes only.
 *
 * <p>Immutable; several threads may read different files with one reader.
 */
public final class X3dReader {
  private final NodeCatalogue catalogue;
  private final ReadLimits limits;

  public X3dReader(NodeCatalogue catalogue) {
    this(catalogue, ReadLimits.standard());
  }

  public X3dReader(NodeCatalogue catalogue, ReadLimits limits) {
    this.catalogue = catalogue;
    this.limits = limits;
  }

  /**
   * Reads a file; problems name it as the path is given.
   *
   * @throws IOException if the file is missing or cannot be read, with a message of one line that
   *     names it
   */
  public X3dFile read(Path file, Problems problems) throws IOException {
    String name = file.toString();
    if (Files.isDirectory(file)) {
      throw new IOException(name + ": this is a folder, not a file");
    }
    try (InputStream in = Files.newInputStream(file)) {
      return parse(name, SceneBytes.read(in, Files.size(file), limits), problems);
    } catch (NoSuchFileException e) {
      throw new IOException(name + ": there is no such file", e);
    } catch (AccessDeniedException e) {
      throw new IOException(name + ": the file may not be read", e);
    } catch (IOException e) {
      throw new IOException(name + ": the file cannot be read: " + e.getMessage(), e);
    }
  }

  /**
   * Reads a stream to its end; the caller closes it.
   *
   * @param source the name that problems call it by
   * @throws IOException if the stream itself fails
   */
  public X3dFile read(String source, InputStream in, Problems problems) throws IOException {
    return parse(source, SceneBytes.read(in, 0, limits), problems);
  }

  /**
   * Reads a stream of known length to its end; the caller closes it.
   *
   * @param source the name that problems call it by
   * @param size in bytes, about; saves copying
   * @throws IOException if the stream itself fails
   */
  public X3dFile read(String source, InputStream in, long size, Problems problems)
      throws IOException {
    return parse(source, SceneBytes.read(in, size, limits), problems);
  }

  /**
   * Reads a file that is in memory.
   *
   * @param source the name that problems call it by
   */
  public X3dFile read(String source, byte[] bytes, Problems problems) {
    return parse(source, SceneBytes.of(bytes, limits), problems);
  }

  /**
   * Reads a stream to its end as a document: all elements with their places, whatever they mean.
   * The caller closes the stream.
   *
   * @param source the name that places call it by
   * @param size in bytes, about; saves copying
   * @throws IOException if the stream itself fails; whatever is wrong with the text is a fault of
   *     the document
   */
  public SceneDocument document(String source, InputStream in, long size) throws IOException {
    SceneBytes bytes = SceneBytes.read(in, size, limits);
    return new DocumentParser(source, catalogue, limits).parse(bytes);
  }

  /** Makes the scene that a document describes, without parsing it again. */
  public X3dFile scene(SceneDocument document, Problems problems) {
    Reading reading = new Reading(document.name(), catalogue, limits, problems);
    return new DocumentReader(reading).read(new TreeCursor(document));
  }

  private X3dFile parse(String source, SceneBytes bytes, Problems problems) {
    Location whole = Location.of(source);
    if (bytes.refused() != null) {
      problems.error(whole, bytes.refused());
      return empty(source);
    }
    if (bytes.cut() != null && bytes.length() == 0) {
      problems.error(whole, bytes.cut() + "; nothing can be shown");
      return empty(source);
    }
    SourceText text = SourceText.of(bytes.bytes(), bytes.length());
    String foreign = foreign(text.head(64));
    if (foreign != null) {
      problems.error(whole, foreign);
      return empty(source);
    }
    if (text.complaint() != null) {
      problems.warning(whole, text.complaint());
    }
    String cut = bytes.cut();
    Location end = whole;
    int flood = text.floodedTag();
    if (flood >= 0) {
      end = text.location(source, flood);
      cut = "an element has more than " + SourceText.ATTRIBUTES + " attributes, as no node does";
      text = text.cutAt(flood);
    }
    Reading reading = new Reading(source, catalogue, limits, problems);
    X3dFile file;
    try {
      file = new DocumentReader(reading).read(new XmlCursor(text, reading, cut != null));
    } catch (XMLStreamException e) {
      // Thrown for a bad XML declaration only, before there is any element.
      problems.error(
          new Location(source, 1, 1),
          "the XML declaration is not well formed; nothing can be shown");
      return empty(source);
    }
    if (cut != null) {
      problems.error(end, cut + "; what was read before is kept");
    }
    return file;
  }

  /** What to say about a file that is no XML, or null when it may be. */
  static @Nullable String foreign(String head) {
    String start = head.stripLeading();
    if (start.startsWith("#VRML") || start.startsWith("#X3D")) {
      return "this is a scene in the Classic VRML encoding, of which nothing is read; convert it to"
          + " X3D's XML encoding";
    }
    if (start.startsWith("{")) {
      return "this is a scene in the JSON encoding at best, of which nothing is read; convert it to"
          + " X3D's XML encoding";
    }
    if (head.isEmpty()) {
      return "the file is empty; nothing can be shown";
    }
    return start.isEmpty() || start.startsWith("<")
        ? null
        : "this is no XML file; nothing can be shown";
  }

  private static X3dFile empty(String source) {
    return new X3dFile(
        source, "", "", Map.of(), List.of(), List.of(), List.of(), Map.of(), List.of(), List.of(),
        List.of());
  }
}
