package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * A file of X3D, in whatever encoding, as elements of the XML encoding with their places, as far as
 * it could be parsed, and what is wrong with it before it says anything about a scene. What the
 * elements mean is for others to say; {@link X3dReader#scene} makes the scene. Serves one thread.
 */
public final class XmlDocument {
  /**
   * A comment.
   *
   * @param offset of its first character
   * @param before the element that begins next beside it; null if none does
   */
  public record Comment(
      String text, Location location, int offset, @Nullable DocumentElement before) {
    Comment before(@Nullable DocumentElement next) {
      return new Comment(text, location, offset, next);
    }
  }

  /** A DOCTYPE; its public identifier is empty where it gives none. */
  public record DocumentType(Location location, String publicId) {}

  private final String name;
  private final boolean compressed;
  private final Encoding encoding;
  private final List<DocumentElement> elements = new ArrayList<>();
  private final List<Comment> comments = new ArrayList<>();
  private final List<DocumentFault> faults = new ArrayList<>();

  private @Nullable DocumentType type;

  XmlDocument(String name, boolean compressed, Encoding encoding) {
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

  void add(DocumentFault fault) {
    faults.add(fault);
  }

  void type(DocumentType found) {
    type = found;
  }

  /** The name that places call the file by. */
  public String name() {
    return name;
  }

  /** Whether the file is compressed by gzip. */
  public boolean isCompressed() {
    return compressed;
  }

  /** How the file is written; its elements are those of the XML encoding all the same. */
  public Encoding encoding() {
    return encoding;
  }

  /** The DOCTYPE, if the file has one. */
  public Optional<DocumentType> type() {
    return Optional.ofNullable(type);
  }

  /** The outermost element. */
  public Optional<DocumentElement> root() {
    return elements.stream().findFirst();
  }

  /** All elements in the order in which they begin. */
  public List<DocumentElement> elements() {
    return Collections.unmodifiableList(elements);
  }

  /** The comments, in the order of the file. */
  public List<Comment> comments() {
    return Collections.unmodifiableList(comments);
  }

  /** What is wrong with the file as XML, in the order found. */
  public List<DocumentFault> faults() {
    return Collections.unmodifiableList(faults);
  }

  /** Whether the file ends before its elements do, so that what is missing is no other fault. */
  public boolean broken() {
    return faults.stream()
        .anyMatch(
            fault ->
                switch (fault.kind()) {
                  case REFUSED, COMPRESSION, SYNTAX, LIMIT, ENTITY -> true;
                  case ENCODING -> false;
                });
  }
}
