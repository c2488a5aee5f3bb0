package org.selectiverenderer.runtime.instance;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.shape.GeneratedCubeNode;

/**
 * A cube map that the renderer draws from the centre of a shape (X3D 4.0, 34.4.2). The cube is
 * aligned with the axes of the world.
 *
 * @param size the width of a face in pixels, 1 to {@link #LARGEST}
 */
public record GeneratedCube(GeneratedCubeNode node, int size, @Nullable Sampling sampling)
    implements TextureSource {
  /** Largest width of a face in pixels; six such faces take 25 MB. */
  public static final int LARGEST = 1024;

  static GeneratedCube of(GeneratedCubeNode node) {
    int size = Math.max(1, Math.min(LARGEST, node.integer("size")));
    return new GeneratedCube(node, size, SamplingReader.of(node));
  }

  @Override
  public int components() {
    return 3;
  }

  @Override
  public boolean cube() {
    return true;
  }

  /**
   * Returns the generated cube maps on a surface and in the fields of its shader programs; mostly
   * none.
   */
  static List<GeneratedCubeNode> in(Surface surface, List<SurfaceProgram> programs) {
    List<TextureSource> all = new ArrayList<>(0);
    if (surface.detail() != null) {
      surface.detail().units().forEach(unit -> all.add(unit.source()));
    }
    for (SurfaceProgram program : programs) {
      program.fields().forEach(field -> all.addAll(field.textures()));
      program.textures().forEach(unit -> all.add(unit.source()));
    }
    List<GeneratedCubeNode> found = new ArrayList<>(0);
    for (TextureSource source : all) {
      if (source instanceof GeneratedCube cube && !found.contains(cube.node())) {
        found.add(cube.node());
      }
    }
    return List.copyOf(found);
  }
}
