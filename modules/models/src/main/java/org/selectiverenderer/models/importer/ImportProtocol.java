package org.selectiverenderer.models.importer;

/**
 * The messages between this program and the child process that reads models, over the child's
 * standard input and output. Numbers are big-endian, strings modified UTF-8 ({@link
 * java.io.DataOutput}), arrays a count and then the values; an absent array has the count {@value
 * #ABSENT}.
 *
 * <ol>
 *   <li>The child begins with {@link #MAGIC}, {@link #VERSION} and a string: why it can read no
 *       models, or "".
 *   <li>For every model: the parent sends {@link #READ_MESHES} or {@link #READ_SCENE} and the
 *       model's name. For the first, all meshes are in one frame, and nodes, cameras, lights,
 *       animations and bones are left out.
 *   <li>The child sends {@link #OPEN} and a url as often as it needs a file, the model itself
 *       included. The parent answers with {@link #SERVED}, the size as a long and the bytes, or
 *       with {@link #REFUSED}.
 *   <li>The child ends with {@link #UNREADABLE}, or with {@link #MODEL} and the lists of {@link
 *       ImportedModel}: materials, textures, nodes, meshes, cameras, lights and animations, each
 *       with the number of its elements and these, in the order of their components.
 * </ol>
 */
final class ImportProtocol {
  static final int MAGIC = 0x53524d49;
  static final int VERSION = 2;

  static final int READ_MESHES = 1;
  static final int READ_SCENE = 2;

  static final int SERVED = 1;
  static final int REFUSED = 0;

  static final int OPEN = 1;
  static final int MODEL = 2;
  static final int UNREADABLE = 3;

  static final int ABSENT = -1;

  /** The maximum length of a url in characters, beyond which it is cut; none is that long. */
  static final int MAX_URL = 8192;

  private ImportProtocol() {}
}
