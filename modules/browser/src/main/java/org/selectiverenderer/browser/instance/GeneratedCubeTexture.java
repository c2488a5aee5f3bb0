package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.shape.GeneratedCubeMapTextureNode;

/**
 * A cube map that the renderer draws from the centre of a shape (X3D 4.0, 34.4.2). The cube is
 * aligned with the axes of the world.
 *
 * @param size the width of a face in pixels, 1 to {@link #LARGEST}
 */
public record GeneratedCubeTexture(
    GeneratedCubeMapTextureNode node, int size, @Nullable TextureSampler sampling)
    implements TextureSource {
  /** Largest width of a face in pixels; six such faces take 25 MB. */
  public static final int LARGEST = 1024;

  static GeneratedCubeTexture of(GeneratedCubeMapTextureNode node) {
    int size = Math.max(1, Math.min(LARGEST, node.integer("size")));
    return new GeneratedCubeTexture(node, size, TextureSamplerReader.of(node));
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
  static List<GeneratedCubeMapTextureNode> in(
      SurfaceMaterial surface, List<ShaderProgramSource> programs) {
    List<TextureSource> all = new ArrayList<>(0);
    if (surface.detail() != null) {
      surface.detail().units().forEach(unit -> all.add(unit.source()));
    }
    for (ShaderProgramSource program : programs) {
      program.fields().forEach(field -> all.addAll(field.textures()));
      program.textures().forEach(unit -> all.add(unit.source()));
    }
    List<GeneratedCubeMapTextureNode> found = new ArrayList<>(0);
    for (TextureSource source : all) {
      if (source instanceof GeneratedCubeTexture cube && !found.contains(cube.node())) {
        found.add(cube.node());
      }
    }
    return List.copyOf(found);
  }
}
