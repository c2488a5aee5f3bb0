package org.selectiverenderer.models.structure;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Checks that a model file's structure is one that a reader can take: what it announces fits into
 * it, and its tree is finite. A file that passes may still be damaged.
 *
 * @param maxModelBytes the size of all arrays of numbers together, those of a mesh once for each
 *     node that shows it
 */
public record ModelStructureCheck(long maxModelBytes) {
  private static final int BUFFER = 1 << 16;

  /**
   * Checks a file.
   *
   * @throws IOException if it cannot be read
   * @throws ModelStructureException if its structure is not one to be read
   */
  public void check(Path file) throws IOException, ModelStructureException {
    try (InputStream in = Files.newInputStream(file)) {
      check(file.toString(), in, Files.size(file));
    }
  }

  /**
   * Checks the bytes of a file, without closing the stream.
   *
   * @param name the name of the file, whose ending tells its format
   * @param size the number of bytes of the stream
   * @throws IOException if it cannot be read
   * @throws ModelStructureException if its structure is not one to be read
   */
  public void check(String name, InputStream content, long size)
      throws IOException, ModelStructureException {
    InputStream in = new BufferedInputStream(content, BUFFER);
    String lower = name.toLowerCase(Locale.ROOT);
    switch (lower.substring(lower.lastIndexOf('.') + 1)) {
      case "gltf", "glb" -> GltfStructureCheck.check(in, size, maxModelBytes);
      case "ply" -> PlyStructureCheck.check(in, size);
      case "stl" -> StlStructureCheck.check(in, size);
      default -> {
        // Lines of text: nothing is announced that does not follow.
      }
    }
  }
}
