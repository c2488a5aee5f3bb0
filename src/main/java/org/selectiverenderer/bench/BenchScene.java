package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Path;

/**
 * What a generator wrote.
 *
 * @param scene the file to open
 * @param path a camera path for it, header {@code t,x,y,z,yaw,pitch,roll} as {@code run --path}
 *     reads it
 * @param switches Switch nodes with metadata
 * @param triangles triangles of the inlined objects, all of which are shown at first
 * @param bytes length of all X3D files together
 */
public record BenchScene(Path scene, Path path, int switches, long triangles, long bytes) {

  /**
   * The whole {@link HeavyScene}, in a folder {@code heavy}.
   *
   * @param folder that this folder is made in
   * @throws IOException when a file cannot be written
   */
  public static BenchScene heavy(Path folder) throws IOException {
    return HeavyScene.write(folder.resolve("heavy"), 1);
  }

  /** The sixth of it that selective rendering leaves, in a folder {@code light}. */
  public static BenchScene light(Path folder) throws IOException {
    return HeavyScene.write(folder.resolve("light"), 1.0 / 6);
  }
}
