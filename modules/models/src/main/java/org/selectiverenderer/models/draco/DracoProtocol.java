package org.selectiverenderer.models.draco;

/**
 * The messages between this program and the child process that decodes, over the child's standard
 * input and output; numbers are big-endian.
 *
 * <p>The parent sends the number of values that a mesh may have as a long, the number of bytes as
 * an int, and the bytes. The child answers with {@link #DAMAGED} or {@link #TOO_LARGE}, or with
 * {@link #MESH}, the number of vertices, the number of indices and the indices, the number of
 * attributes, and for each its unique number, the number of components, whether they are integers,
 * and the values.
 */
final class DracoProtocol {
  static final int DAMAGED = 0;
  static final int TOO_LARGE = 1;
  static final int MESH = 2;

  static final int BUFFER = 1 << 16;

  /** The maximum number of attributes; glTF's own are fewer. */
  static final int MAX_ATTRIBUTES = 64;

  /** The maximum number of components of an attribute. */
  static final int MAX_COMPONENTS = 16;

  private DracoProtocol() {}
}
