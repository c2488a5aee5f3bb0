package org.selectiverenderer.bench;

import java.nio.file.Path;

/**
 * A generated benchmark scene.
 *
 * @param scene the file to open
 * @param path a camera path for it, header {@code t,x,y,z,yaw,pitch,roll} as {@code run --path}
 *     reads it
 * @param switches Switch nodes with metadata
 * @param triangles triangles of the inlined objects, all of which are shown at first
 * @param bytes length of all X3D files together
 */
public record BenchScene(Path scene, Path path, int switches, long triangles, long bytes) {}
