package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * A parsed X3D file in any encoding, as elements of the XML encoding with their locations, and its
 * syntax errors. The elements are not interpreted; {@link X3dReader#scene} returns their scene. Not
 * thread-safe.
 */
public final class XmlDocument {
  /**
   * A comment.
   *
   * @param offset the offset of its first character
   * @param before the next sibling element; null if there is none
   */
  public record Comment(
      String text, SourceLocation location, int offset, @Nullable DocumentElement before) {
    Comment before(@Nullable DocumentElement next) {
      return new Comment(text, location, offset, next);
    }
  }

  /** A DOCTYPE; its public identifier is empty if there is none. */
  public record DocumentType(SourceLocation location, String publicId) {}

  private final String name;
  private final boolean compressed;
  private final SceneEncoding encoding;
  private final List<DocumentElement> elements = new ArrayList<>();
  private final List<Comment> comments = new ArrayList<>();
  private final List<DocumentError> faults = new ArrayList<>();

  private @Nullable DocumentType type;

  XmlDocument(String name, boolean compressed, SceneEncoding encoding) {
    this.name = name;
    this.compressed = compressed;
    this.encoding = encoding;
  }

  void add(DocumentElement element) {
    elements.add(element);
  }

  void add(Comment comment) {
    comments.add(comment);
  }

  void add(DocumentError fault) {
    faults.add(fault);
  }

  void type(DocumentType found) {
    type = found;
  }

  /** Returns the name of the file in locations. */
  public String name() {
    return name;
  }

  /** Returns whether the file is compressed by gzip. */
  public boolean isCompressed() {
    return compressed;
  }

  /** Returns the encoding of the file; its elements are always those of the XML encoding. */
  public SceneEncoding encoding() {
    return encoding;
  }

  /** Returns the DOCTYPE, if the file has one. */
  public Optional<DocumentType> type() {
    return Optional.ofNullable(type);
  }

  /** Returns what is wrong if the root element is not that of a scene; empty for X3D or none. */
  public Optional<String> rootFault() {
    return root()
        .filter(root -> !root.name().equals("X3D"))
        .map(root -> "the root element of a scene must be X3D, not " + root.name());
  }

  /** Returns the root element. */
  public Optional<DocumentElement> root() {
    return elements.stream().findFirst();
  }

  /** Returns all elements in document order. */
  public List<DocumentElement> elements() {
    return Collections.unmodifiableList(elements);
  }

  /** Returns the comments in document order. */
  public List<Comment> comments() {
    return Collections.unmodifiableList(comments);
  }

  /** Returns the syntax errors in the order found. */
  public List<DocumentError> faults() {
    return Collections.unmodifiableList(faults);
  }

  /** Returns whether the file is truncated, so that missing parts are no further errors. */
  public boolean broken() {
    return faults.stream()
        .anyMatch(
            fault ->
                switch (fault.kind()) {
                  case REFUSED, COMPRESSION, SYNTAX, LIMIT, ENTITY -> true;
                  case ENCODING, MODEL -> false;
                });
  }
}
