package org.selectiverenderer.x3d.source;

import org.selectiverenderer.base.problem.Location;

/**
 * Something wrong with a file as XML, before it says anything about a scene.
 *
 * @param message one sentence without a full stop
 */
public record DocumentFault(Kind kind, Location location, String message) {
  /** What can be wrong. */
  public enum Kind {
    /** Nothing of the file can be used: too large, of another encoding, or no XML. */
    REFUSED,
    /** The compression is damaged. */
    COMPRESSION,
    /** Bytes or an encoding's name that cannot be understood. */
    ENCODING,
    /** An entity of a DOCTYPE, which is never expanded. */
    ENTITY,
    /** XML that is not well formed. */
    SYNTAX,
    /** More elements or deeper nesting than is read. */
    LIMIT
  }
}
