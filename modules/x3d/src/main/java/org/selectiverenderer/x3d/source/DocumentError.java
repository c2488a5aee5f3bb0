package org.selectiverenderer.x3d.source;

import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A syntax or encoding error of a file, found before the scene is interpreted.
 *
 * @param message one sentence without a full stop
 */
public record DocumentError(Kind kind, SourceLocation location, String message) {
  /** The kinds of errors. */
  public enum Kind {
    /** Nothing of the file is usable: it is too large, of another encoding, or not XML. */
    REFUSED,
    /** The compression is damaged. */
    COMPRESSION,
    /** Invalid bytes or an unknown character encoding. */
    ENCODING,
    /** An entity that is not declared, external, or beyond the limits of expansion. */
    ENTITY,
    /** XML that is not well formed. */
    SYNTAX,
    /**
     * A part of a model of another program, of VRML 1.0 or of a page that X3D cannot express or
     * that is not read.
     */
    MODEL,
    /** Too many elements or too deep nesting. */
    LIMIT
  }

  /**
   * Returns whether it is told from the tags around it: not by an attribute of one, such as the
   * declaration of a prefix, nor by all of the text.
   */
  boolean plain() {
    return kind == Kind.SYNTAX && !message.startsWith(XmlErrorMessages.PREFIX_FAULT);
  }
}
