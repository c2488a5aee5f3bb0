package org.selectiverenderer.bench;

import java.nio.file.Path;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A generated benchmark scene.
 *
 * @param scene the file to open
 * @param path a camera path for it, header {@code t,x,y,z,yaw,pitch,roll} as {@code run --path}
 *     reads it
 * @param switches Switch nodes with metadata
 * @param triangles triangles of the inlined objects, all of which are shown at first; of a street,
 *     those of its apartments with all objects high
 * @param bytes length of all X3D files together
 * @param outside a position outside of every area
 * @param inside a position in one area
 */
public record BenchScene(
    Path scene,
    Path path,
    int switches,
    long triangles,
    long bytes,
    Vector3dc outside,
    Vector3dc inside) {
  /** Describes a scene with an area around the origin. */
  BenchScene(Path scene, Path path, int switches, long triangles, long bytes) {
    this(scene, path, switches, triangles, bytes, new Vector3d(0, 0, 6), new Vector3d());
  }
}
